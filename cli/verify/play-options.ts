import { createHash } from 'node:crypto';
import { type Command, Option } from 'commander';
import { ACCURACIES, DEFAULT_TERMS } from '../../engine/basics/index.ts';
import { type AcceptedAccuracy, PLAY_LIMITS } from '../../game/index.ts';
import type { OwnRules } from '../../schema/index.ts';
import type { Configuration } from '../config/index.ts';
import { type FoundFiles, findConfigured } from '../find/index.ts';
import { readBytes } from '../io/index.ts';
import { collect, type TermsOptions, termsFrom, wholeNumberOption } from '../options/index.ts';
import { Failure, namedPath, visible } from '../terminal/index.ts';
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
  readonly accuracy?: AcceptedAccuracy;
}

/** `--accuracy` of plays, which may be `any`. */
export const playAccuracyOption = (): Option =>
  new Option(
    '--accuracy <name>',
    `the accuracy at which plays must have been played; any takes all (default: that of gq.config.json, else ${JSON.stringify(DEFAULT_TERMS.accuracy.name)})`,
  ).choices([...Object.keys(ACCURACIES), 'any']);

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

/** What plays are compared with. */
export interface PlayJobSettings {
  /** Level files. */
  readonly files: readonly string[];
  readonly rules: OwnRules;
  readonly engines: string | null;
  /** The name of the accuracy at which plays must have been played, or `any`. */
  readonly accuracy: string;
  /** `key`: its file. */
  readonly challenge: { readonly key: string; readonly now: number } | null;
  readonly maxTicks: number;
  readonly maxWork: number;
  /** Hashes of what is in the files, where shards must find the same. */
  readonly planned?: { readonly levels: string; readonly key: string | null };
}

/** What the options and the configuration choose. */
export async function playSettings(
  options: PlayOptions & Pick<TermsOptions, 'maxWork'>,
  configuration: Configuration,
): Promise<{ readonly settings: PlayJobSettings; readonly unreadable: FoundFiles['unreadable'] }> {
  const { challengeKey: key, engines = null, maxTicks, maxWork: most } = options;
  const { rules, maxWork, accuracy: usual } = termsFrom({ maxWork: most }, configuration);
  const accuracy = options.accuracy ?? usual.name;
  if (key !== undefined) readKey(key);
  const { files, unreadable } = await findConfigured(options.levels ?? [], configuration);
  const challenge = key === undefined ? null : { key, now: options.now ?? Math.floor(Date.now() / 1000) };
  return { settings: { files, rules, engines, accuracy, challenge, maxTicks, maxWork }, unreadable };
}

/** Settings for a plan: shards refuse other levels and another key than those of now. */
export const planned = (settings: PlayJobSettings): PlayJobSettings => ({ ...settings, planned: hashesOf(settings) });

const hashesOf = ({ files, challenge }: PlayJobSettings): Required<PlayJobSettings>['planned'] => ({
  levels: hashOf(files.map((file) => `${file}\0${hashOf([bytesOrNothing(file)])}\n`)),
  key: challenge === null ? null : hashOf([readKey(challenge.key)]),
});

/** @throws Failure if the levels or the key are others than those that were planned */
export function expectAsPlanned(settings: PlayJobSettings): void {
  const { files, challenge, planned: expected } = settings;
  if (expected === undefined) return;
  const found = hashesOf(settings);
  const advice = 'restore it, or make the plan anew with gq plan';
  if (found.levels !== expected.levels) {
    const many = files.length > 1 ? ` to ${namedPath(files[files.length - 1])}` : '';
    throw new Failure(
      `a level that plays are compared with has changed since the plan was made, of ${namedPath(files[0])}${many}: ${advice}`,
    );
  }
  if (challenge !== null && found.key !== expected.key)
    throw new Failure(`--challenge-key ${namedPath(challenge.key)} is another key than when the plan was made: ${advice}`);
}

/** @param candidates how many stale plays are tried on the levels that there are */
export const deskSettings = (
  { files, rules, engines, accuracy, challenge, maxTicks, maxWork }: PlayJobSettings,
  candidates: number,
): PlaySettings => ({
  files,
  rules,
  engines,
  accuracy,
  options: {
    maxTicks,
    maxWork,
    challengeKey: challenge === null ? undefined : readKey(challenge.key),
    now: challenge?.now,
  },
  candidates,
});

/** Which levels no play can be compared with, for stderr. */
export const unusableInWords = ({ unusable }: Pick<Catalogue, 'unusable'>): string =>
  unusable.map((reason) => `warning: ${visible(reason)}; no play is compared with it\n`).join('');

/** The same, of levels that are still to be read. */
export const unusableLevels = ({ files, rules }: PlayJobSettings): string =>
  unusableInWords(readCatalogue(files, rules, ownEngine));

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

/** A file that can't be read counts as empty: it is no level either way. */
function bytesOrNothing(file: string): Uint8Array {
  try {
    return readBytes(file);
  } catch (error) {
    if (error instanceof Failure) return new Uint8Array();
    throw error;
  }
}
