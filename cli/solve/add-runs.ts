import type { Hold, LevelFile } from '../../schema/index.ts';
import { replaceLevel } from '../levels/index.ts';

/** A run that was added to a level file, or that was already there under this name. */
export interface AddedRun {
  readonly name: string;
  readonly status: 'written' | 'already there';
}

/** The default name of a run that was found. */
export const DEFAULT_NAME = 'solution';

/**
 * Appends runs to a level file and writes it in the canonical layout; no other data changes.
 * @param base the bytes that were read before the search
 * @param file the parsed bytes
 * @param wanted the name of the first run; null: `solution`, or the next free name
 * @throws Failure if the file has changed since, or can't be written
 */
export function addRuns(
  path: string,
  base: Uint8Array,
  file: LevelFile,
  found: readonly (readonly Hold[])[],
  wanted: string | null,
): AddedRun[] {
  const runs = [...(file.runs ?? [])];
  const added = found.map((holds, i): AddedRun => {
    const text = JSON.stringify(holds);
    const same = runs.find((run) => JSON.stringify(run.holds) === text);
    if (same !== undefined) return { name: same.name, status: 'already there' };
    const name = freeName(
      wanted !== null && i > 0 ? `${wanted}-${i + 1}` : (wanted ?? DEFAULT_NAME),
      runs.map((run) => run.name),
    );
    runs.push({ name, holds: holds.map(([press, release]): [number, number] => [press, release]) });
    return { name, status: 'written' };
  });
  if (added.every(({ status }) => status === 'already there')) return added;
  replaceLevel(path, base, { ...file, runs }, 'run gq solve again, or add the run by hand');
  return added;
}

/** The name itself if it is free, else with the first number that makes it free. */
export function freeName(name: string, taken: readonly string[]): string {
  if (!taken.includes(name)) return name;
  for (let i = 2; ; i++) if (!taken.includes(`${name}-${i}`)) return `${name}-${i}`;
}
