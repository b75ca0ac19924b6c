import type { Configuration } from '../../config/index.ts';
import { type FoundFiles, findConfigured } from '../../find/index.ts';
import { readStdin, STDIN_NAME, stdinName } from '../../io/index.ts';
import { Failure, namedPath } from '../../terminal/index.ts';

/** What the options say about the files to check. */
interface ChoiceOptions {
  /** `true`: no ref was given. */
  readonly changed?: true | string;
  readonly stdinPath?: string;
  readonly lock?: string;
  readonly updateLock?: true;
  /** The lock with which levels are compared, whatever has chosen it; null: none. */
  readonly comparedLock: string | null;
}

/** The files to check. */
interface ChosenFiles extends FoundFiles {
  /** All files that the paths name, also those that are not checked because they have not changed. */
  readonly all: readonly string[];
  /** The content of the only level, if it comes from standard input. */
  readonly input: Uint8Array | null;
  /** Which files these are, for people; '' for all that the paths name. */
  readonly message: string;
}

/** Chooses the files to check. @throws Failure if a path matches none, or options contradict each other */
export async function chooseFiles(
  paths: readonly string[],
  options: ChoiceOptions,
  configuration: Configuration,
): Promise<ChosenFiles> {
  const { changed } = options;
  const stdin = stdinName(paths, options.stdinPath);
  if (stdin !== null) {
    refuseForStdin(stdin, options);
    return { files: [stdin], all: [stdin], packs: [], unreadable: [], input: readStdin('check'), message: '' };
  }
  const found = await findConfigured(paths, configuration);
  if (changed === undefined) return { ...found, all: found.files, input: null, message: '' };
  const { changedFiles } = await import('../../changed/index.ts');
  const { files, inWords } = await changedFiles(found.files, changed === true ? null : changed, {
    config: configuration.file,
    lock: options.comparedLock,
  });
  return { ...found, files, all: found.files, input: null, message: `${inWords}\n` };
}

function refuseForStdin(stdin: string, { changed, lock, updateLock }: ChoiceOptions): void {
  if (changed !== undefined) throw new Failure('--changed chooses among files: expected no level from standard input with it');
  if (updateLock) throw new Failure('--update-lock records files: expected no level from standard input with it');
  if (lock !== undefined && stdin === STDIN_NAME)
    throw new Failure('--lock has results of files: expected --stdin-path FILE with it, to say which one the level is');
}

/** Options that follow single files. */
interface OfFiles {
  readonly changed?: unknown;
  readonly updateLock?: true;
  readonly bail?: number;
  readonly watch?: true;
  /** The lock that the options or the configuration choose. */
  readonly lock: string | null;
}

/** @throws Failure if an option is given that only a check of single files has */
export function refuseForPacks(pack: string, { changed, updateLock, bail, watch, lock }: OfFiles): void {
  const option =
    changed !== undefined ? '--changed' : updateLock ? '--update-lock' : watch ? '--watch' : bail !== undefined ? '--bail' : null;
  const given = option ?? (lock === null ? null : `the lock ${namedPath(lock)}`);
  if (given === null) return;
  const advice = option === null ? 'check packs with --no-lock' : `leave ${option} out, or unpack it`;
  throw new Failure(`${namedPath(pack)} is a pack, and ${given} is for level files: ${advice}`);
}
