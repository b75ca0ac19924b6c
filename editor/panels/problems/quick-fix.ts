import { joinHolds } from '../../../engine/index.ts';
import type { LevelFile, Problem } from '../../../schema/index.ts';
import { type Recipe, replaceHolds } from '../../document/index.ts';

/** What mends a problem without changing how anything plays. */
export interface QuickFix {
  readonly title: string;
  readonly recipe: Recipe;
}

/** The run a pointer leads to or into; null when it leads to none. */
export function runAt(file: LevelFile, pointer: string): string | null {
  const match = /^\/runs\/(\d+)/.exec(pointer);
  return match === null ? null : (file.runs?.[Number(match[1])]?.name ?? null);
}

/** The safe way to mend a problem at once; null where somebody has to decide. */
export function quickFixOf(file: LevelFile, { code, pointer }: Problem): QuickFix | null {
  const name = runAt(file, pointer);
  const run = file.runs?.find((other) => other.name === name);
  if (run === undefined || name === null) return null;
  // holds are played sorted and joined anyway
  if (code === 'holds-overlap') return { title: 'Join the holds', recipe: replaceHolds(name, joinHolds(run.holds)) };
  if (code === 'holds-unsorted') {
    return {
      title: 'Sort the holds',
      recipe: replaceHolds(
        name,
        [...run.holds].sort((a, b) => a[0] - b[0] || a[1] - b[1]),
      ),
    };
  }
  return null;
}
