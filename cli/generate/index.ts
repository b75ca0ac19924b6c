import { basename, join, resolve } from 'node:path';
import { formatLevel, formatPack, MAX_FILE_SIZE, PACK_NAME, PACK_VERSION } from '../../schema/index.ts';
import { createPackJudge, type Generated, type PackOptions, packLevel } from '../../solver/index.ts';
import { createFile, levelIdOf, makeFolders, NotAFile, readRegularFile, runInPool, tryFolder } from '../io/index.ts';
import { schemaReference } from '../levels/index.ts';
import { Failure, namedPath, systemReason } from '../terminal/index.ts';
import type { GenerateTask, MadeLevel } from './make-level.ts';

/** What happened to a generated level; `in the way`: another file has its name, which is not overwritten. */
type Kept = 'written' | 'unchanged' | 'in the way';

const slugOf = (name: string): string =>
  name
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');

/** The file name of a level, made from its name and seed, so that the same seed gives the same file. */
export const generatedPath = (directory: string, name: string, seed: number): string =>
  join(directory, `${slugOf(name)}-${seed}.level.json`);

/** The file name of a level of a pack: its number, from 1, with as many digits as the last one has, and its name. */
export const packPath = (directory: string, name: string, number: number, count: number): string =>
  join(directory, `${`${number}`.padStart(Math.max(2, `${count}`.length), '0')}-${slugOf(name)}.level.json`);

/**
 * Writes a level to a new file: completely or not at all.
 * @throws Failure if it can't be written
 */
export function keepLevel(directory: string, path: string, { level }: Generated): Kept {
  const $schema = schemaReference(directory) ?? undefined;
  return keep(path, formatLevel({ $schema, ...level }));
}

function keep(path: string, text: string): Kept {
  try {
    if (createFile(path, Buffer.from(text))) return 'written';
    return Buffer.from(text).equals(readRegularFile(path, MAX_FILE_SIZE)) ? 'unchanged' : 'in the way';
  } catch (error) {
    if (error instanceof NotAFile) return 'in the way';
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
}

/** The pack file of generated levels, and what happened to it. */
export interface KeptPack {
  readonly file: string;
  readonly status: Kept;
}

/**
 * Writes the order of a pack to a new file: completely or not at all.
 * @param levels the paths of its level files, in order
 * @throws Failure if it can't be written
 */
export function keepPack(directory: string, levels: readonly string[]): KeptPack {
  const file = join(directory, PACK_NAME);
  const $schema = schemaReference(directory, 'pack') ?? undefined;
  const name = basename(resolve(directory)) || 'Generated levels';
  const ids = levels.map((level) => levelIdOf(directory, level));
  return {
    file,
    status: keep(file, formatPack({ ...($schema !== undefined && { $schema }), version: PACK_VERSION, name, levels: ids })),
  };
}

/** Creates the directory if it is missing, and tries to write into it. @throws Failure if that fails */
export function makeDirectory(directory: string): void {
  const fail = (what: string, error: unknown): never => {
    const reason = systemReason(error);
    throw new Failure(`--out ${namedPath(directory)}: ${what}: ${reason}; expected a directory that can be written`);
  };
  try {
    makeFolders(directory);
  } catch (error) {
    fail("the directory can't be created", error);
  }
  try {
    tryFolder(directory);
  } catch (error) {
    fail('no file can be created in it', error);
  }
}

export type { GenerateTask, MadeLevel } from './make-level.ts';

/** What became of a pack. */
interface PackResult {
  /** For each level, in order, what was made last, accepted or not. */
  readonly made: readonly MadeLevel[];
  /** How many levels were rejected because they were too close to an earlier one. */
  readonly alike: number;
}

// How often a level of the pack is tried with another seed.
const ROUNDS = 4;

/**
 * Makes the levels of a pack in worker threads. They are judged in their order, so the pack is the same for any number of threads.
 * A level that is rejected, or for which nothing good was found, is tried with another seed after the others.
 * @param effort most ticks for each try
 * @param jobs the largest number of threads
 * @param onAccepted called with each level once it is accepted, and at the end with those for which nothing was found
 */
export async function makePack(
  pack: PackOptions,
  effort: number,
  jobs: number,
  onAccepted: (index: number, made: MadeLevel) => Promise<void>,
): Promise<PackResult> {
  const judge = createPackJudge();
  const last = new Map<number, MadeLevel>();
  let alike = 0;
  let pending = Array.from({ length: pack.count }, (_, i) => i);
  for (let round = 0; round < ROUNDS && pending.length > 0; round++) {
    const tasks = pending.map((index) => ({ options: packLevel(pack, index, round), effort }));
    const waiting = new Map<number, MadeLevel>();
    const rejected: number[] = [];
    let next = 0;
    const judgeReady = async () => {
      for (; next < tasks.length; next++) {
        const ready = waiting.get(tasks[next].options.seed);
        if (ready === undefined) return;
        const index = pending[next];
        const all = added(ready, last.get(index));
        last.set(index, all);
        const isGood = ready.made !== null && judge.accepts(ready.made.level);
        if (isGood) await onAccepted(index, all);
        else rejected.push(index);
        if (!isGood && ready.made !== null) alike++;
      }
    };
    // one after the other, since levels become ready while others are judged
    let judging = Promise.resolve();
    await makeLevels(tasks, jobs, (_, one) => {
      waiting.set(one.seed, one);
      judging = judging.then(judgeReady);
      return judging;
    });
    pending = rejected;
  }
  for (const index of pending) {
    const nothing = last.get(index);
    if (nothing === undefined) continue;
    last.set(index, { ...nothing, made: null, length: null });
    await onAccepted(index, { ...nothing, made: null, length: null });
  }
  return { made: [...last.entries()].sort(([a], [b]) => a - b).map(([, one]) => one), alike };
}

/** A try with the effort of the one before it. */
const added = (now: MadeLevel, before: MadeLevel | undefined): MadeLevel =>
  before === undefined ? now : { ...now, attempts: now.attempts + before.attempts, ticks: now.ticks + before.ticks };

/**
 * Generates levels in worker threads. Resolves after `onMade` has finished for every level.
 * @param jobs the largest number of threads
 * @param onMade called with each level as soon as it is done
 */
export async function makeLevels(
  tasks: readonly GenerateTask[],
  jobs: number,
  onMade: (done: number, made: MadeLevel) => Promise<void>,
): Promise<void> {
  await runInPool<GenerateTask, MadeLevel>(new URL('./worker.js', import.meta.url), tasks, jobs, onMade);
}
