import { fstatSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import process from 'node:process';
import { type Command, Option } from 'commander';
import { PLAY_LIMITS } from '../../game/index.ts';
import type { VerifyReport } from '../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../config/index.ts';
import { nothingFound, unreadableFolders, whyMissing } from '../find/index.ts';
import { reportWhole, shardOfPlan } from '../fleet/index.ts';
import { filesBelow, firstPack, once, readRegularFile, STDIN, statOrError } from '../io/index.ts';
import {
  addShardOptions,
  jobsOption,
  maxWorkOption,
  refuseBesidesPlan,
  refuseUnused,
  type ShardOptions,
  type TermsOptions,
} from '../options/index.ts';
import { colorsFor, Failure, hearSignals, namedPath, print, systemReason, visibleLine } from '../terminal/index.ts';
import {
  addPlayOptions,
  countsPretty,
  deskSettings,
  itemOfFile,
  itemOfLine,
  linesOf,
  PlayDesk,
  type PlayItem,
  type PlayOptions,
  playAccuracyOption,
  playPretty,
  playSettings,
  startThreads,
  unusableInWords,
  unusableLevels,
  verifyInOrder,
} from '../verify/index.ts';

/** Plays in files that are read together. */
const TOGETHER = 32;

const PLAY_FILE = /\.gqr$/;

/** So many stale plays of files are tried on the levels that there are. */
const CANDIDATES = 20;

interface Options extends ConfigOptions, PlayOptions, ShardOptions, Pick<TermsOptions, 'maxWork'> {
  readonly jobs: number;
  readonly format?: 'pretty' | 'json';
}

export const help: CommandHelp = {
  description:
    'Verify recorded plays: repeat the inputs of each on its level, and compare what comes of them with what it claims. Levels are found by the hash in the play.',
  more: `
Verdicts: ok; claim-differs; stale-level: no level has the play's hash; other-accuracy: it was played at another accuracy, so the
physics was not that of these levels; unknown-engine; malformed; too-long.

With -, each line is a play as base64url, or {"id": ..., "play": "<base64url>", "subject": ...}; --format json is the default then.
--format json prints a JSON object per play on a line of its own, in the order of the plays, as soon as it is known.

Exit code: 0 when every play is what it claims; 1 when one is not; 2 when a play or a level could not be read.

Examples:
  $ gq verify attempt.gqr
  $ gq verify plays --levels levels --format json
  $ gq verify - --challenge-key secret.key < plays.ndjson
  $ gq verify plays --engines engines     engines/IDENTITY holds a package, as npm install --prefix makes it`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addShardOptions(addPlayOptions(addConfigOptions(command)))
    .argument(
      '[file...]',
      'plays (.gqr), directories of them, packs (.ndjson with a play a line, .tar, also as .gz or .zst), or -: NDJSON on standard input',
    )
    .addOption(playAccuracyOption())
    .addOption(maxWorkOption())
    .addOption(jobsOption(availableParallelism()))
    .addOption(new Option('--format <format>', 'format of the report (default: pretty; json with -)').choices(['pretty', 'json']))
    .action(async (paths: string[], options: Options) => finish(await verify(paths, options, command)));
}

async function verify(paths: readonly string[], options: Options, command: Command): Promise<CommandResult> {
  refuseBesidesPlan(command, paths, options);
  if (options.plan !== undefined) return shardOfPlan('verify', options, options.jobs);
  if (paths.length === 0)
    throw new Failure('nothing was verified: expected a .gqr file, a directory of them, a pack, or - for standard input');
  const isStdin = paths.includes(STDIN);
  if (isStdin && paths.length > 1) {
    throw new Failure('the path - reads plays from standard input: expected no other path with it (./- is a file of that name)');
  }
  refuseUnused(command, [{ option: '--now', isUsed: options.challengeKey !== undefined, needs: '--challenge-key' }]);
  const configuration = await readConfiguration(options);
  const found = isStdin ? null : findPlays(paths);
  const { settings, unreadable } = await playSettings(options, configuration);
  if (found !== null && firstPack(found.files) !== undefined) {
    const all = [...unreadable, ...found.unreadable];
    if (all.length > 0) throw unreadableFolders(all);
    const destinations = [{ name: options.format ?? 'pretty', file: null }] as const;
    const reported = await reportWhole('verify', settings, found.files, destinations, 'verified', { jobs: options.jobs });
    return { ...reported, messages: unusableLevels(settings) + (reported.messages ?? '') };
  }
  const threads = startThreads(options.jobs);
  const desk = new PlayDesk(deskSettings(settings, isStdin ? 0 : CANDIDATES), threads);
  const folders = [...unreadable, ...(found?.unreadable ?? [])];
  const errors = folders.map(({ path, reason }) => `error: ${visibleLine(path)}: the directory can't be read: ${reason}\n`);
  const warnings = unusableInWords(desk.catalogue);
  const format = options.format ?? (isStdin ? 'json' : 'pretty');
  const counts = new Map<string, number>();
  const shown = (reports: readonly VerifyReport[]): string => {
    for (const { verdict } of reports) counts.set(verdict, (counts.get(verdict) ?? 0) + 1);
    if (format === 'json') return reports.map((report) => `${JSON.stringify(report)}\n`).join('');
    const colors = colorsFor(process.stdout);
    return reports.map((report) => playPretty(report, colors)).join('');
  };
  const groups = found === null ? submittedPlays() : savedPlays(found.files, errors);
  try {
    await verifyInOrder(groups, desk, threads.most, (reports) => print(shown(reports)));
  } finally {
    await threads.end();
  }
  if (counts.size === 0 && errors.length === 0) throw new Failure('nothing was verified: standard input has no play');
  const isClean = [...counts.keys()].every((verdict) => verdict === 'ok');
  return {
    output: format === 'pretty' ? countsPretty(counts) : '',
    messages: [warnings, ...errors].join(''),
    exitCode: errors.length > 0 ? 2 : isClean ? 0 : 1,
  };
}

interface FoundPlays {
  readonly files: readonly string[];
  readonly unreadable: readonly { readonly path: string; readonly reason: string }[];
}

/** @throws Failure with every path that matches nothing */
function findPlays(paths: readonly string[]): FoundPlays {
  const files: string[] = [];
  const unreadable: { path: string; reason: string }[] = [];
  const unmatched: string[] = [];
  for (const path of paths) {
    const stats = statOrError(path);
    if (stats instanceof Error) {
      unmatched.push(`${namedPath(path)}: ${whyMissing(path, stats)}`);
    } else if (stats.isDirectory()) {
      const before = unreadable.length;
      const found = filesBelow(path, (name) => PLAY_FILE.test(name), unreadable);
      if (found.length === 0 && unreadable.length === before)
        unmatched.push(`${namedPath(path)}: the directory contains no *.gqr`);
      files.push(...found);
    } else files.push(path);
  }
  if (unmatched.length === 0) return { files: once(files), unreadable };
  const what = unmatched.length === 1 ? 'a path matches no play' : 'paths match no play';
  const expected = 'expected a .gqr file, a directory of them, a pack, or - for standard input';
  throw nothingFound(`nothing was verified: ${what}`, unmatched, expected);
}

/** The plays in files. Of one that can't be read only the error is kept. */
async function* savedPlays(files: readonly string[], errors: string[]): AsyncGenerator<PlayItem[]> {
  let group: PlayItem[] = [];
  for (const file of files) {
    await hearSignals();
    let content: Uint8Array;
    try {
      content = readRegularFile(file, PLAY_LIMITS.bytes);
    } catch (error) {
      errors.push(`error: ${visibleLine(file)}: can't be read: ${systemReason(error)}; expected a .gqr file\n`);
      continue;
    }
    group.push(itemOfFile(file, content));
    if (group.length < TOGETHER) continue;
    yield group;
    group = [];
  }
  if (group.length > 0) yield group;
}

/** The plays on standard input. */
async function* submittedPlays(): AsyncGenerator<PlayItem[]> {
  const { stdin } = process;
  if (stdin.isTTY) {
    throw new Failure('standard input is a terminal: expected plays from a file or a pipe, as in gq verify - < plays.ndjson');
  }
  try {
    if (fstatSync(0).isDirectory()) throw new Failure('standard input is a directory: expected plays, one a line');
    for await (const lines of linesOf(stdin)) {
      yield lines.flatMap(({ number, text }) => itemOfLine(null, number, text) ?? []);
    }
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(`standard input can't be read: ${systemReason(error)}`);
  }
}
