import { type Pack, packedLevel } from '../../check/pack/index.ts';
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
import type { Configuration } from '../configuration.ts';
import { Failure, NotAFile, readRegularFile, type StoppingSignal } from '../io/index.ts';
import type { PackFile } from './find-pack.ts';

/** How the levels of a pack are checked. */
export interface BuildOptions {
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
