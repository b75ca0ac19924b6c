import { fstatSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import process from 'node:process';
import { type Command, Option } from 'commander';
import { PLAY_LIMITS } from '../../../game/index.ts';
import type { VerifyReport } from '../../../schema/index.ts';
import { colorsFor } from '../../colors.ts';
import type { CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions } from '../../config-file.ts';
import { Failure, systemReason } from '../../failure.ts';
import { once, statOrError, walk } from '../../files.ts';
import { findConfigured } from '../../level-paths.ts';
import { collect, jobsOption, maxWorkOption, wholeNumberOption } from '../../options.ts';
import { print } from '../../print.ts';
import { readBytes } from '../../read-bytes.ts';
import { readConfiguration } from '../../read-configuration.ts';
import { readRegularFile } from '../../regular-file.ts';
import { namedPath, shellPath } from '../../shown-path.ts';
import { siblingHint } from '../../sibling-hint.ts';
import { hearSignals } from '../../signals.ts';
import { STDIN } from '../../stdin.ts';
import { refuseUnused } from '../../unused-options.ts';
import { linesOf, PlayDesk, type PlayItem, readLine, startThreads, verifyInOrder } from '../../verify/index.ts';
import { visible, visibleLine } from '../../visible.ts';
import { countsPretty, playPretty } from './pretty.ts';

/** Plays in files that are read together. */
const TOGETHER = 32;

const PLAY_FILE = /\.gqr$/;

/** So many stale plays of files are tried on the levels that there are. */
const CANDIDATES = 20;

/** Bytes that a challenge key has at least. */
const SHORTEST_KEY = 16;
const LONGEST_KEY = 4096;

interface Options extends ConfigOptions {
  readonly levels?: readonly string[];
  readonly engines?: string;
  readonly challengeKey?: string;
  readonly now?: number;
  readonly maxTicks: number;
  readonly maxWork: number;
  readonly jobs: number;
  readonly format?: 'pretty' | 'json';
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(command)
    .description(
      'Verify recorded plays: repeat the inputs of each on its level, and compare what comes of them with what it claims. Levels are found by the hash in the play.',
    )
    .argument('<file...>', 'plays (.gqr), directories of them, or -: NDJSON on standard input')
    .option(
      '--levels <path>',
      'level files or directories that plays may be of (default: "levels" of gq.config.json, else levels); can be given several times',
      collect,
    )
    .option('--engines <dir>', 'older engines, to verify plays that were made with them: DIR/IDENTITY has the package')
    .option('--challenge-key <file>', 'every play must contain a challenge made with the key in this file, still valid')
    .option('--now <seconds>', 'the time for challenges, seconds since 1970 (default: the clock)', secondsOption)
    .addOption(
      new Option('--max-ticks <n>', 'most ticks of 1/60 s that a play may have')
        .argParser(wholeNumberOption('a number of ticks', 1, PLAY_LIMITS.ticks))
        .default(PLAY_LIMITS.ticks),
    )
    .addOption(maxWorkOption())
    .addOption(jobsOption(availableParallelism()))
    .addOption(new Option('--format <format>', 'format of the report (default: pretty; json with -)').choices(['pretty', 'json']))
    .addHelpText(
      'after',
      `
Verdicts: ok; claim-differs; stale-level: no level has the play's hash; unknown-engine; malformed; too-long.

With -, each line is a play as base64url, or {"id": ..., "play": "<base64url>", "subject": ...}; --format json is the default then.
--format json prints a JSON object per play on a line of its own, in the order of the plays, as soon as it is known.

Exit code: 0 when every play is what it claims; 1 when one is not; 2 when a play or a level could not be read.

Examples:
  $ gq verify attempt.gqr
  $ gq verify plays --levels levels --format json
  $ gq verify - --challenge-key secret.key < plays.ndjson
  $ gq verify plays --engines engines     engines/IDENTITY holds a package, as npm install --prefix makes it`,
    )
    .action(async (paths: string[], options: Options) => finish(await verify(paths, options, command)));
}

const secondsOption = wholeNumberOption('seconds since 1970', 0, 0xffff_ffff);

async function verify(paths: readonly string[], options: Options, command: Command): Promise<CommandResult> {
  const isStdin = paths.includes(STDIN);
  if (isStdin && paths.length > 1) {
    throw new Failure('the path - reads plays from standard input: expected no other path with it (./- is a file of that name)');
  }
  refuseUnused(command, [{ option: '--now', isUsed: options.challengeKey !== undefined, needs: '--challenge-key' }]);
  const configuration = readConfiguration(options);
  const challengeKey = options.challengeKey === undefined ? undefined : readKey(options.challengeKey);
  const found = isStdin ? null : findPlays(paths);
  const { files, unreadable } = await findConfigured(options.levels ?? [], configuration);
  const threads = startThreads(options.jobs);
  const desk = new PlayDesk(
    {
      files,
      rules: configuration.rules,
      engines: options.engines ?? null,
      options: {
        maxTicks: options.maxTicks,
        maxWork: options.maxWork,
        challengeKey,
        now: challengeKey === undefined ? undefined : (options.now ?? Math.floor(Date.now() / 1000)),
      },
      candidates: isStdin ? 0 : CANDIDATES,
    },
    threads,
  );
  const folders = [...unreadable, ...(found?.unreadable ?? [])];
  const errors = folders.map(({ path, reason }) => `error: ${visibleLine(path)}: the directory can't be read: ${reason}\n`);
  const warnings = desk.catalogue.unusable.map((reason) => `warning: ${visible(reason)}; no play is compared with it\n`);
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
    messages: [...warnings, ...errors].join(''),
    exitCode: errors.length > 0 ? 2 : isClean ? 0 : 1,
  };
}

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
      const hint = (stats as NodeJS.ErrnoException).code === 'ENOENT' ? siblingHint(path) : '';
      unmatched.push(`${namedPath(path)}: ${systemReason(stats)}${hint}`);
    } else if (stats.isDirectory()) {
      const before = unreadable.length;
      const found = walk(path, (name) => PLAY_FILE.test(name), unreadable);
      if (found.length === 0 && unreadable.length === before)
        unmatched.push(`${namedPath(path)}: the directory contains no *.gqr`);
      files.push(...found);
    } else files.push(path);
  }
  if (unmatched.length === 0) return { files: once(files), unreadable };
  throw new Failure(
    `nothing was verified: ${unmatched.length === 1 ? 'a path matches' : 'paths match'} no play\n${unmatched.map((line) => `  ${line}\n`).join('')}expected a .gqr file, a directory of them, or - for standard input`,
  );
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
    const isText = content[0] === 0x7b || content[0] === 0x22;
    const why = `expected a play, found text; if its lines are plays: gq verify - < ${shellPath(file)}`;
    group.push({ file, line: null, id: null, subject: null, content: isText ? { verdict: 'malformed', why } : content });
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
      yield lines.flatMap(({ number, text }): PlayItem[] => {
        const read = readLine(text);
        if (read === null) return [];
        const place = { file: null, line: number, id: read.id };
        if ('why' in read) return [{ ...place, subject: null, content: read }];
        return [{ ...place, subject: read.subject, content: read.bytes }];
      });
    }
  } catch (error) {
    if (error instanceof Failure) throw error;
    throw new Failure(`standard input can't be read: ${systemReason(error)}`);
  }
}
