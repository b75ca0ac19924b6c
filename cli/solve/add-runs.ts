import { realpathSync } from 'node:fs';
import { formatLevel, type Hold, type LevelFile } from '../../schema/index.ts';
import { replaceFile } from '../disk.ts';
import { Failure, systemReason } from '../failure.ts';
import { readBytes } from '../read-bytes.ts';
import { whyNotWritable } from '../writable.ts';

/** A run that was put into a level file, or is there already under this name. */
export interface AddedRun {
  readonly name: string;
  readonly status: 'written' | 'already there';
}

/** What a run that was found is called when nothing else is said. */
const DEFAULT_NAME = 'solution';

/**
 * Puts runs into a level file, behind those it has, in the canonical layout; nothing else in it changes.
 * @param base the bytes that were read before the search
 * @param file what they say
 * @param wanted the name of the first run; `solution` or the next free one when null
 * @throws Failure when the file has changed since, or can't be written
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
    // a link stays one: what it leads to is replaced
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

/** Looks before a long search whether its result could be written. @throws Failure when it could not */
export function expectWritable(path: string): void {
  const why = whyNotWritable(path);
  if (why !== null) throw new Failure(`${path}: --write can't write it: ${why}`);
}

/** The name itself, or with the first number behind it that is free. */
function freeName(name: string, taken: readonly string[]): string {
  if (!taken.includes(name)) return name;
  for (let i = 2; ; i++) if (!taken.includes(`${name}-${i}`)) return `${name}-${i}`;
}
