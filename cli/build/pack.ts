import { dirname, relative, resolve, sep } from 'node:path';
import { type Pack, packedLevel } from '../../check/pack/index.ts';
import { VERDICT_MEANS } from '../../check/words/index.ts';
import { type AccuracyName, isAccuracyName } from '../../engine/index.ts';
import { MAX_FILE_SIZE, type OwnRules, readLevel } from '../../schema/index.ts';
import { cacheFolder } from '../cache/index.ts';
import {
  type AskedOptions,
  type CheckedLevel,
  type CheckSettings,
  checkFiles,
  judgeLevels,
  openLevelCache,
  settingsFor,
} from '../check/index.ts';
import type { Configuration } from '../config/index.ts';
import { type FoundFiles, findConfigured, pathsOr } from '../find/index.ts';
import { type FoundPack, levelIdOf, NotAFile, readRegularFile, sortedByPlay, statOrError } from '../io/index.ts';
import { type CheckedPack, checkPackFile } from '../pack-file/index.ts';
import { FileFailure } from '../report-parts/index.ts';
import { isFailing } from '../show-failure/index.ts';
import { Failure, type StoppingSignal } from '../terminal/index.ts';

/** A level file of a pack. */
interface PackFile {
  readonly file: string;
  /** The path below the folder of the pack, with slashes, without .level.json. */
  readonly id: string;
}

/** The levels of a pack, and what says so. */
interface FoundLevels {
  readonly files: readonly PackFile[];
  /** What the pack.json of the only path says; null if there is none. */
  readonly order: CheckedPack | null;
  /** The ids of the levels that it leaves out. */
  readonly leftOut: readonly string[];
}

/**
 * The level files of a pack, in the order in which they are played: those that the pack.json of a folder lists; where there is none,
 * that of the paths, and below each path by name, with numbers by their value.
 * @throws Failure if a path matches none, a folder can't be read, a pack.json has errors, or two files have one id
 */
export async function findPack(paths: readonly string[], configuration: Configuration): Promise<FoundLevels> {
  const { files, packs, unreadable } = await findConfigured(paths, configuration);
  if (unreadable.length > 0) {
    const list = unreadable.map(({ path, reason }) => `  ${path}: ${reason}\n`).join('');
    throw new Failure(`nothing was written, because directories can't be read:\n${list.trimEnd()}`);
  }
  const given = pathsOr(paths, configuration);
  const checked = packs.map((pack) => checkPackFile(pack, new Set(files), configuration));
  refuseErrors(checked);
  const ordered = given.length === 1 ? inOrder(files, checked.length > 0) : await inOrderOfPaths(given, files, configuration);
  const folder = given.length === 1 && isFolder(given[0]) ? resolve(given[0]) : commonFolder(ordered);
  const left = new Set(packs.flatMap((pack, i) => unlistedOf(pack, checked[i], files)));
  const owners = new Map<string, string>();
  const all = ordered.map((file) => {
    const id = levelIdOf(folder, file);
    const other = owners.get(id);
    if (other !== undefined)
      throw new Failure(`${file}: expected one level ${JSON.stringify(id)}, found ${other} as well; rename one, or leave it out`);
    owners.set(id, file);
    return { file, id };
  });
  const kept = all.filter(({ file }) => !left.has(file));
  if (kept.length === 0)
    throw new Failure(`nothing was written: ${packs[0].file} lists no level; list the levels that are played`);
  const leftOut = all.filter(({ file }) => left.has(file)).map(({ id }) => id);
  return { files: kept, order: given.length === 1 ? (checked[0] ?? null) : null, leftOut };
}

/** The files of a folder that its pack does not list. */
const unlistedOf = ({ folder }: FoundPack, { listed }: CheckedPack, files: readonly string[]): string[] =>
  files.filter((file) => isBelow(folder, file) && listed?.includes(levelIdOf(folder, file)) === false);

const isBelow = (folder: string, file: string): boolean => !relative(resolve(folder), resolve(file)).startsWith('..');

/** @throws Failure if the order of a pack has errors: a hole in the game is not built */
function refuseErrors(packs: readonly CheckedPack[]): void {
  const wrong = packs.map((pack) => ({ ...pack, problems: pack.problems.filter(({ severity }) => severity === 'error') }));
  const files = wrong.filter(({ problems }) => problems.length > 0);
  if (files.length > 0) throw new FileFailure('nothing was written, because of errors in the order of the levels', files);
}

const slashed = (path: string): string => path.split(sep).join('/');

/** @param isGiven whether a pack has put them in order already */
const inOrder = (files: readonly string[], isGiven: boolean): string[] => (isGiven ? [...files] : sortedByPlay(files, slashed));

async function inOrderOfPaths(
  paths: readonly string[],
  files: readonly string[],
  configuration: Configuration,
): Promise<string[]> {
  const wanted = new Set(files);
  const ordered: string[] = [];
  for (const path of paths) {
    const found: FoundFiles = await findConfigured([path], configuration);
    // a file that two paths name counts where it is named first
    for (const file of inOrder(found.files, found.packs.length > 0)) if (wanted.delete(file)) ordered.push(file);
  }
  return ordered;
}

const isFolder = (path: string): boolean => {
  const stats = statOrError(path);
  return !(stats instanceof Error) && stats.isDirectory();
};

/** The innermost folder that all files are in or below. */
function commonFolder(files: readonly string[]): string {
  let common = resolve(dirname(files[0])).split(sep);
  for (const file of files) {
    const parts = resolve(dirname(file)).split(sep);
    const differs = common.findIndex((part, i) => part !== parts[i]);
    if (differs >= 0) common = common.slice(0, differs);
  }
  return common.join(sep) || sep;
}

/** How the levels of a pack are checked. */
interface BuildOptions {
  readonly asked: AskedOptions;
  /** The folder of the cache, or false for none; null: the usual one. */
  readonly cache: boolean | string | null;
  readonly jobs: number;
  /** Called now and then with the number of levels that are done. */
  readonly onProgress: (done: number) => void;
}

/** What became of the levels of a pack. */
export interface BuiltPack {
  readonly accuracy: AccuracyName;
  /** The longest that a run may last, s. */
  readonly maxTime: number;
  /** In the order of the pack. */
  readonly levels: readonly (CheckedLevel & { readonly id: string })[];
  /** The bytes that were checked, by file; none of a file that can't be read. */
  readonly bytes: ReadonlyMap<string, Uint8Array>;
  /** The signal that ended the check early; null if none came. */
  readonly signal: StoppingSignal | null;
}

/** Checks the levels of a pack as `gq check` does. @throws Failure if a file changes meanwhile */
export async function checkPack(
  files: readonly PackFile[],
  configuration: Configuration,
  { asked, cache: choice, jobs, onProgress }: BuildOptions,
): Promise<BuiltPack> {
  const settings: CheckSettings = {
    ...settingsFor(asked, configuration, files.length),
    forLock: false,
    inFull: false,
  };
  const { maxTime } = settings.terms;
  const accuracy = settings.terms.accuracy.name;
  // a page plays at an accuracy that has a name, so a build has no options for another
  if (!isAccuracyName(accuracy)) throw new Error(`not the name of an accuracy: ${accuracy}`);
  const folder = cacheFolder(choice);
  const cache = folder === null ? null : openLevelCache(folder, settings);
  const bytes = new Map<string, Uint8Array>();
  for (const { file } of files) {
    const content = bytesOrNull(file);
    if (content !== null) bytes.set(file, content);
  }
  const names = files.map(({ file }) => file);
  const { levels, signal } = await checkFiles(names, settings, jobs, onProgress, { cache });
  for (const [file, content] of bytes) {
    const now = bytesOrNull(file);
    if (now === null || Buffer.compare(now, content) !== 0)
      throw new Failure(`${file}: the file has changed during the check, so nothing was written: build again`);
  }
  const ids = new Map(files.map(({ file, id }) => [file, id]));
  const judged = await judgeLevels(levels, configuration);
  return { accuracy, maxTime, levels: judged.map((level) => ({ ...level, id: ids.get(level.file)! })), bytes, signal };
}

/** @throws Failure if it is not a regular file: a pipe can't be read both by the check and for the pack */
function bytesOrNull(file: string): Uint8Array | null {
  try {
    return readRegularFile(file, MAX_FILE_SIZE);
  } catch (error) {
    if (error instanceof NotAFile) throw new Failure(`${file}: can't be built: ${error.message}; expected a level file`);
    // the check says why
    return null;
  }
}

/** The pack of levels that were checked and are valid. */
export function packOf(
  { accuracy, maxTime, levels, bytes }: BuiltPack,
  {
    title,
    rules,
    withRuns,
    chapters,
  }: {
    readonly title: string;
    readonly rules: OwnRules;
    readonly withRuns: boolean;
    /** The chapter of each level that stands below a heading, by its id. */
    readonly chapters: ReadonlyMap<string, string>;
  },
): Pack {
  return {
    title,
    accuracy,
    maxTime,
    levels: levels.map(({ id, file, found }) => {
      const read = readLevel(bytes.get(file)!);
      if (!read.ok) throw new Error(`${file}: was valid and now is not`);
      const level = packedLevel(read.document.file, { rules, withRuns, found });
      const chapter = chapters.get(id);
      return chapter === undefined ? { id, level } : { id, chapter, level };
    }),
  };
}

/** Whether nobody can play a level, so that it is never built. */
export const isUnplayable = ({ verdict }: CheckedLevel): boolean => verdict === 'invalid' || verdict === 'crashed';

/** The levels because of which nothing is built: with `force` only those that nobody can play. */
export const refusedOf = ({ levels }: BuiltPack, force: boolean): BuiltPack['levels'] =>
  levels.filter(force ? isUnplayable : isFailing);

/** What is wrong with a level that is refused. */
export const whyRefused = ({ verdict }: CheckedLevel): string =>
  verdict === 'completable' ? 'it has an error' : VERDICT_MEANS[verdict];
