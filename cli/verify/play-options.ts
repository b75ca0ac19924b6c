import { createHash } from 'node:crypto';
import { type Command, Option } from 'commander';
import { PLAY_LIMITS } from '../../game/index.ts';
import type { OwnRules } from '../../schema/index.ts';
import type { Configuration } from '../configuration.ts';
import { Failure } from '../failure.ts';
import type { FoundFiles } from '../files.ts';
import { findConfigured } from '../level-paths.ts';
import { collect, wholeNumberOption } from '../options.ts';
import { readBytes } from '../read-bytes.ts';
import { namedPath } from '../shown-path.ts';
import { visible } from '../visible.ts';
import { type Catalogue, readCatalogue } from './catalogue.ts';
import { ownEngine } from './engine-module.ts';
import type { PlaySettings } from './verify-plays.ts';

/** The values of the options that `addPlayOptions` declares. */
export interface PlayOptions {
  readonly levels?: readonly string[];
  readonly engines?: string;
  readonly challengeKey?: string;
  readonly now?: number;
  readonly maxTicks: number;
}

const secondsOption = wholeNumberOption('seconds since 1970', 0, 0xffff_ffff);

/** Declares what plays are compared with. @param forWhat what they are for, where a command has other options beside them */
export const addPlayOptions = (command: Command, forWhat = ''): Command =>
  command
    .option(
      '--levels <path>',
      `${forWhat}level files or directories that plays may be of (default: "levels" of gq.config.json, else levels); can be given several times`,
      collect,
    )
    .option('--engines <dir>', `${forWhat}older engines, to verify plays that were made with them: DIR/IDENTITY has the package`)
    .option('--challenge-key <file>', `${forWhat}every play must contain a challenge made with the key in this file, still valid`)
    .option('--now <seconds>', `${forWhat}the time for challenges, seconds since 1970 (default: the clock)`, secondsOption)
    .addOption(
      new Option('--max-ticks <n>', `${forWhat}most ticks of 1/60 s that a play may have`)
        .argParser(wholeNumberOption('a number of ticks', 1, PLAY_LIMITS.ticks))
        .default(PLAY_LIMITS.ticks),
    );

/** What a set of plays is compared with, as a plan holds it. */
export interface PlayJobSettings {
  readonly levels: {
    readonly files: readonly string[];
    /** The hash over their names and bytes. */
    readonly sha256: string;
  };
  readonly rules: OwnRules;
  readonly engines: string | null;
  readonly challenge: { readonly file: string; readonly sha256: string; readonly now: number } | null;
  readonly maxTicks: number;
  readonly maxWork: number;
}

/** What the options and the configuration choose; the levels are as they are now. */
export async function playSettings(
  options: PlayOptions & { readonly maxWork: number },
  configuration: Configuration,
): Promise<{ readonly settings: PlayJobSettings; readonly unreadable: FoundFiles['unreadable'] }> {
  const { challengeKey, engines = null, maxTicks, maxWork } = options;
  const { rules } = configuration;
  const key = challengeKey === undefined ? null : readKey(challengeKey);
  const { files, unreadable } = await findConfigured(options.levels ?? [], configuration);
  const now = options.now ?? Math.floor(Date.now() / 1000);
  const challenge = key === null ? null : { file: challengeKey!, sha256: hashOf([key]), now };
  return {
    settings: { levels: { files, sha256: hashOfFiles(files) }, rules, engines, challenge, maxTicks, maxWork },
    unreadable,
  };
}

/** @throws Failure if the levels or the key are others than when the settings were made */
export function expectAsPlanned({ levels, challenge }: PlayJobSettings): void {
  const advice = 'restore it, or make the plan anew with gq plan';
  if (hashOfFiles(levels.files) !== levels.sha256) {
    const many = levels.files.length > 1 ? ` to ${namedPath(levels.files[levels.files.length - 1])}` : '';
    throw new Failure(
      `a level that plays are compared with has changed since the plan was made, of ${namedPath(levels.files[0])}${many}: ${advice}`,
    );
  }
  if (challenge !== null && hashOf([readKey(challenge.file)]) !== challenge.sha256)
    throw new Failure(`--challenge-key ${namedPath(challenge.file)} is another key than when the plan was made: ${advice}`);
}

/** @param candidates how many stale plays are tried on the levels that there are */
export const deskSettings = (
  { levels, rules, engines, challenge, maxTicks, maxWork }: PlayJobSettings,
  candidates: number,
): PlaySettings => ({
  files: levels.files,
  rules,
  engines,
  options: {
    maxTicks,
    maxWork,
    challengeKey: challenge === null ? undefined : readKey(challenge.file),
    now: challenge?.now,
  },
  candidates,
});

/** Which levels no play can be compared with, for stderr. */
export const unusableInWords = ({ unusable }: Pick<Catalogue, 'unusable'>): string =>
  unusable.map((reason) => `warning: ${visible(reason)}; no play is compared with it\n`).join('');

/** The same, of levels that are still to be read. */
export const unusableLevels = ({ levels, rules }: PlayJobSettings): string =>
  unusableInWords(readCatalogue(levels.files, rules, ownEngine));

/** Bytes that a challenge key has at least, and at most. */
const SHORTEST_KEY = 16;
const LONGEST_KEY = 4096;

/** The key in a file, without the end of its line. */
function readKey(path: string): Uint8Array {
  const bytes = readBytes(path);
  const end = bytes.at(-1) === 0x0a ? (bytes.at(-2) === 0x0d ? 2 : 1) : 0;
  const key = bytes.slice(0, bytes.length - end);
  if (key.length >= SHORTEST_KEY && key.length <= LONGEST_KEY) return key;
  throw new Failure(
    `--challenge-key ${namedPath(path)}: expected a key of ${SHORTEST_KEY} to ${LONGEST_KEY} bytes, found ${key.length}; openssl rand -hex 32 makes one`,
  );
}

function hashOf(parts: readonly (Uint8Array | string)[]): string {
  const hash = createHash('sha256');
  for (const part of parts) hash.update(part);
  return hash.digest('hex');
}

/** Files that can't be read count as empty: they are no levels either way. */
function hashOfFiles(files: readonly string[]): string {
  return hashOf(files.map((file) => `${file}\0${hashOf([bytesOrNothing(file)])}\n`));
}

function bytesOrNothing(file: string): Uint8Array {
  try {
    return readBytes(file);
  } catch (error) {
    if (error instanceof Failure) return new Uint8Array();
    throw error;
  }
}
