import { availableParallelism } from 'node:os';
import process from 'node:process';
import type { Command } from 'commander';
import { accuracyInWords, countMinerals, effortInWords, holdsInWords, outcomeInWords } from '../../check/words/index.ts';
import type { Level } from '../../schema/index.ts';
import type { Goal, Objective } from '../../solver/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../config/index.ts';
import { findConfigured, unreadableFolders } from '../find/index.ts';
import { reportWhole, shardOfPlan } from '../fleet/index.ts';
import { entryName, packFormat, statOrError } from '../io/index.ts';
import { expectWritable, type OpenedFile, openLevel } from '../levels/index.ts';
import {
  addSearchOptions,
  addShardOptions,
  addTermsOptions,
  expectMinerals,
  formatOption,
  jobsOption,
  limitsOf,
  mineralsOption,
  objectiveOption,
  refuseBesidesPlan,
  type SearchOptions,
  type ShardOptions,
  type TermsOptions,
  wholeNumberOption,
} from '../options/index.ts';
import { closestRunInWords, robustnessLines } from '../report-parts/index.ts';
import {
  addRuns,
  askedRuns,
  progressText,
  type Solved,
  type SolvedRun,
  type SolveSettings,
  settingsFor,
  solveLevel,
  solveReport,
} from '../solve/index.ts';
import { type Colors, colorsFor, createStatusLine, Failure, uncut, visible, visibleLine } from '../terminal/index.ts';

interface Options extends ConfigOptions, TermsOptions, SearchOptions, ShardOptions {
  readonly minerals: Goal['minerals'];
  readonly objective: Objective;
  readonly count: number;
  readonly jobs: number;
  readonly write?: true;
  readonly run?: string;
  readonly format: 'pretty' | 'json';
}

export const help: CommandHelp = {
  description:
    'Find a run that completes a level, by default the one that forgives bad timing most, or prove that there is none.',
  more: `
The search starts from the level's own runs that reach the goal. Every run is replayed from the start before it is reported:
gq simulate --holds gives the same hash. The search ends early when no better run is possible, and at the end of --budget with
the best run so far. Ctrl-C ends it without a report, and nothing is written.

Several levels are solved one in each thread, and make a table, or JSON with all of them.

Exit code: 0 when a run was found, of several for each; 1 when none was found, when it is proved that there is none, or when the level is invalid;
2 when the level could not be read or written; 130 and 143 after SIGINT and SIGTERM.

Examples:
  $ gq solve levels/16-firewalk.level.json
  $ gq solve levels/16-firewalk.level.json --minerals all --budget 30 --write
  $ gq solve levels/16-firewalk.level.json --objective first --format json | jq .holds
  $ gq solve levels/16-firewalk.level.json --effort 5000000 --seed 7   the same answer on every machine
  $ gq solve levels.ndjson.gz --effort 5000000 --format json`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addShardOptions(addSearchOptions(addConfigOptions(addTermsOptions(command)), ' for each level'))
    .argument('[level...]', 'a level file; several, directories or packs (.ndjson, .tar, also as .gz or .zst) make a table')
    .addOption(mineralsOption())
    .addOption(objectiveOption())
    .option('--count <n>', 'how many clearly different runs to find', wholeNumberOption('a number of runs', 1, 100), 1)
    .option('--write', 'add the runs to the level file, after those it has')
    .option('--run <name>', 'with --write: the name of the run (default: "solution", or the next free name)')
    .addOption(jobsOption(availableParallelism()))
    .addOption(formatOption('pretty', 'json'))
    .action(async (paths: string[], options: Options) => finish(await solve(paths, options, command)));
}

async function solve(paths: readonly string[], options: Options, command: Command): Promise<CommandResult> {
  refuseBesidesPlan(command, paths, options);
  if (options.plan !== undefined) return shardOfPlan('solve', options, options.jobs);
  if (paths.length === 0) throw new Failure('expected the path of a level file, found none');
  const [file] = paths;
  return paths.length > 1 || isOfMany(file) ? solveMany(paths, options) : solveOne(file, options);
}

/** Whether a path stands for any number of levels. */
function isOfMany(path: string): boolean {
  const stats = statOrError(path);
  return stats instanceof Error
    ? /[*?]/.test(path) && entryName(path) === null
    : stats.isDirectory() || packFormat(path) !== null;
}

async function solveMany(paths: readonly string[], options: Options): Promise<CommandResult> {
  const given = options.write ? '--write' : options.run !== undefined ? '--run' : null;
  if (given !== null) throw new Failure(`${given} is for a single level file: leave it out, or solve the levels one at a time`);
  const configuration = await readConfiguration(options);
  const settings = { ...askedRuns(options, configuration), limits: limitsOf(options) };
  const { files, unreadable } = await findConfigured(paths, configuration);
  if (unreadable.length > 0) throw unreadableFolders(unreadable);
  return reportWhole('solve', settings, files, [{ name: options.format, file: null }], 'solved', { jobs: options.jobs });
}

async function solveOne(file: string, options: Options): Promise<CommandResult> {
  const configuration = await readConfiguration(options);
  const asked = askedRuns(options, configuration);
  const opened = openLevel(file, configuration);
  if (!('level' in opened)) return opened;
  const { level } = opened;
  expectRunName(file, level, options);
  expectMinerals(file, level, options.minerals);
  if (options.write) expectWritable(file);
  const settings = settingsFor(level, asked);
  const solved = await search(settings, options);
  const report =
    options.format === 'json'
      ? `${JSON.stringify(solveReport(settings, solved))}\n`
      : solvePretty(settings, solved, colorsFor(process.stdout));
  const found = solved.runs.length > 0;
  const exitCode = found ? 0 : 1;
  const count = solved.runs.length;
  const fewer =
    found && count < options.count
      ? `found ${count} of ${options.count} clearly different runs: a larger --budget or another --seed may find more\n`
      : '';
  if (!options.write) return { output: report, messages: fewer, exitCode };
  if (!found) return { output: report, messages: 'nothing was written: no run was found\n', exitCode };
  try {
    const messages = await uncut(() => write(file, opened, solved, options.run ?? null));
    return { output: report, messages: fewer + messages, exitCode };
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    // the runs that were found are reported even if they can't be written
    return { output: report, messages: `error: ${visibleLine(error.message)}\n`, exitCode: 2 };
  }
}

async function search(settings: SolveSettings, options: Options): Promise<Solved> {
  const line = createStatusLine();
  const start = performance.now();
  try {
    return await solveLevel(settings, {
      limits: limitsOf(options),
      jobs: options.jobs,
      onRound: (found) => line.show(progressText(found, (performance.now() - start) / 1000)),
    });
  } finally {
    line.clear();
  }
}

/** @returns the message about it for people */
function write(file: string, { bytes, document }: OpenedFile, { runs }: Solved, name: string | null): string {
  const found = runs.map(({ holds }) => holds);
  return addRuns(file, bytes, document.file, found, name)
    .map((run) =>
      run.status === 'written'
        ? `wrote run ${JSON.stringify(run.name)} to ${file}\n`
        : `${file} already has this run: ${JSON.stringify(run.name)}\n`,
    )
    .map((text) => `${visibleLine(text.trimEnd())}\n`)
    .join('');
}

const LONGEST_NAME = 80;

function expectRunName(file: string, { runs }: Level, { run, write }: Options): void {
  if (run === undefined) return;
  if (!write) throw new Failure('--run names the run that --write writes: give --write as well');
  if (run.length === 0 || run.length > LONGEST_NAME) {
    throw new Failure(`--run: expected a name of 1 to ${LONGEST_NAME} characters, found ${run.length}`);
  }
  if (runs.some(({ name }) => name === run)) {
    throw new Failure(`${file}: a run is already named ${JSON.stringify(run)}: expected another name`);
  }
}

/** The results of `solve` for people. */
function solvePretty(settings: SolveSettings, solved: Solved, colors: Colors): string {
  const { level, terms } = settings;
  const { runs, effort, impossible, closest } = solved;
  const head = `${colors.bold(visibleLine(level.name))}, ${accuracyInWords(terms)}`;
  if (impossible !== null) {
    return (
      `${head}\n${colors.red('proved impossible')}: ${visible(impossible.reason)}\n\n` +
      `${rows([['proof', `${impossible.code}; a separate checker has confirmed its certificate (--format json shows it)`]])}`
    );
  }
  const spent: [string, string] = ['effort', `${effortInWords(effort)}, ${solved.seconds.toFixed(1)} s, seed ${settings.seed}`];
  if (runs.length === 0) {
    const lines: [string, string][] = [spent];
    if (closest !== null) lines.push(['closest', closestRunInWords(closest)]);
    return `${head}\n${colors.yellow('no run found')}; this does not prove that there is none\n\n${rows(lines)}`;
  }
  const parts = runs.map((run, i) => {
    const title = runs.length === 1 ? '' : `${colors.bold(`${i + 1} of ${runs.length}`)}: `;
    return `${title}${colors.green(outcomeInWords(run.run, level.range))}\n${rows(linesOf(settings, run))}`;
  });
  return `${head}\n${parts.join('\n')}\n${rows([spent])}`;
}

function linesOf({ level }: SolveSettings, { holds, run, robustness }: SolvedRun): [string, string][] {
  return [
    ['holds', holdsInWords(holds)],
    ['minerals', `${countMinerals(run)} of ${level.minerals.length}`],
    ...robustnessLines(robustness),
    ['hash', run.hash],
  ];
}

const WIDTH = 11;

const rows = (lines: readonly (readonly [string, string])[]): string =>
  lines.map(([label, text]) => `${label.padEnd(WIDTH)}${text}\n`).join('');
