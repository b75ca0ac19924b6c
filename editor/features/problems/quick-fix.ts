import { joinHolds } from '../../../engine/index.ts';
import type { LevelFile, Problem } from '../../../schema/index.ts';
import { type Recipe, replaceHolds } from '../../core/document/index.ts';

/** A fix that does not change how any run plays. */
export interface QuickFix {
  readonly title: string;
  readonly recipe: Recipe;
}

/** The run that a pointer leads to or into; null if there is none. */
export function runAt(file: LevelFile, pointer: string): string | null {
  const match = /^\/runs\/(\d+)/.exec(pointer);
  return match === null ? null : (file.runs?.[Number(match[1])]?.name ?? null);
}

/** The safe fix of a problem; null if the user has to decide. */
export function quickFixOf(file: LevelFile, { code, pointer }: Problem): QuickFix | null {
  const name = runAt(file, pointer);
  const run = file.runs?.find((other) => other.name === name);
  if (run === undefined || name === null) return null;
  // the engine sorts and joins holds anyway
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
