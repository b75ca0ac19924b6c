import { realpathSync } from 'node:fs';
import { formatLevel, type Hold, type LevelFile } from '../../schema/index.ts';
import { replaceFile } from '../disk.ts';
import { Failure, systemReason } from '../failure.ts';
import { readBytes } from '../read-bytes.ts';
import { whyNotWritable } from '../writable.ts';

/** A run that was added to a level file, or that was already there under this name. */
export interface AddedRun {
  readonly name: string;
  readonly status: 'written' | 'already there';
}

/** The default name of a run that was found. */
const DEFAULT_NAME = 'solution';

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
  const content = Buffer.from(formatLevel({ ...file, runs }));
  try {
    // a link stays a link: the file that it leads to is replaced
    const real = realpathSync(path);
    replaceFile(real, content, () => {
      if (Buffer.compare(readBytes(real), base) === 0) return;
      throw new Failure(
        `${path}: the file changed during the search, so nothing was written: run gq solve again, or add the run by hand`,
      );
    });
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
  return added;
}

/** Checks before a long search whether its result can be written. @throws Failure if it can't */
export function expectWritable(path: string): void {
  const why = whyNotWritable(path);
  if (why !== null) throw new Failure(`${path}: --write can't write it: ${why}`);
}

/** The name itself if it is free, else with the first number that makes it free. */
function freeName(name: string, taken: readonly string[]): string {
  if (!taken.includes(name)) return name;
  for (let i = 2; ; i++) if (!taken.includes(`${name}-${i}`)) return `${name}-${i}`;
}
