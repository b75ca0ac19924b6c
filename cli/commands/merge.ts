import { availableParallelism } from 'node:os';
import { type Command, InvalidArgumentError, Option } from 'commander';
import { plural } from '../../check/words/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import {
  contentsOf,
  type Gathered,
  gather,
  type JobName,
  jobOf,
  mergedRecords,
  type Plan,
  rangesOf,
  readPlan,
  recordOfLine,
  replaySample,
  resultsIn,
  setPaths,
} from '../fleet/index.ts';
import { levelsRead } from '../io/index.ts';
import { jobsOption } from '../options/index.ts';
import {
  chooseReports,
  type Destination,
  expectReportFiles,
  forceReportsOption,
  reporterOption,
  reportFormatOption,
} from '../reporters/index.ts';
import { exitCodeAfter, Failure, namedPath, shellPath, stoppable } from '../terminal/index.ts';

const LISTS = ['list', 'slurm', 'k8s'] as const;

interface Options {
  readonly plan: string;
  readonly missing?: (typeof LISTS)[number];
  /** The share of the levels, 0 to 1. */
  readonly replay?: number;
  readonly format?: string;
  readonly reporter?: readonly string[];
  readonly output?: string;
  readonly force?: true;
  readonly quiet?: true;
  readonly jobs: number;
}

export const help: CommandHelp = {
  description: 'Put the results of shards together: every level exactly once, the same report for any number of shards.',
  more: `
Missing shards are named, and nothing else is reported. --missing slurm and k8s print them as 2,5-7, list as one a line; do those
shards again, and merge again. Copies of a result that agree are fine. Results that differ are an alarm: a machine computes
otherwise, or a result was changed.
--replay repeats a sample of what is said to be good, chosen by a hash of all results, and needs the levels for it.
The report has the same bytes for any number of shards, in any order, on any machine; so levels have no times in it (ms is 0).

Exit code: 0 and 1 as the command that was planned; 2 when a result is missing, damaged or of another plan; 3 when results
contradict each other or a replay.

Examples:
  $ gq merge results --plan plan.json
  $ gq merge results --plan plan.json --format json -o report.json
  $ sbatch --array=$(gq merge results --plan plan.json --missing slurm) shard.sh`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .argument('<dir...>', 'directories with results')
    .requiredOption('--plan <file>', 'the plan, as gq plan has written it')
    .addOption(new Option('--missing <form>', 'print only the shards whose results are missing').choices(LISTS))
    .option(
      '--replay <share>',
      'how many of the good results to repeat: a percentage, all or none (default: 1 %, and about 20 of a small set)',
      parseShare,
    )
    .addOption(reportFormatOption())
    .addOption(reporterOption())
    .addOption(forceReportsOption())
    .option('-o, --output <file>', 'write the report into a file in place of stdout')
    .option('--quiet', 'show only errors and the summary (pretty and github); warnings still count')
    .addOption(jobsOption(availableParallelism()))
    .action(async (folders: string[], options: Options) => finish(await merge(folders, options)));
}

/** The share of the good results that are repeated, and of a small set how many. */
const USUAL_SHARE = 0.01;
const FEW = 20;

function parseShare(text: string): number {
  if (text === 'all') return 1;
  if (text === 'none') return 0;
  const percent = Number(text.replace(/%$/, ''));
  if (/^[\d.]+%?$/.test(text) && percent <= 100) return percent / 100;
  throw new InvalidArgumentError('expected a percentage from 0 to 100, all or none');
}

async function merge(folders: readonly string[], options: Options): Promise<CommandResult> {
  const plan = readPlan(options.plan);
  const asked = chooseReports(options).map((one) =>
    one.file === null && options.output !== undefined ? { ...one, file: options.output } : one,
  );
  expectFormats(plan.job, asked);
  const inputs = {
    ...levelsRead(await levelsOf(plan, asked), 'checked'),
    'the plan': options.plan,
    'a result': resultsIn(folders),
  };
  expectReportFiles(asked, inputs, options.force === true);
  const gathered = await gather(plan, folders);
  const notes = [...gathered.notes, ...gathered.conflicts].map((note) => `${note}\n`).join('');
  if (options.missing !== undefined) return { ...listMissing(options.missing, gathered), messages: notes };
  if (gathered.conflicts.length > 0) {
    return {
      messages: `${notes}error: results contradict each other or the plan: a machine computes otherwise, or a result was changed; move the wrong ones away, and do their shards again\n`,
      exitCode: 3,
    };
  }
  if (gathered.missing.length > 0) return { messages: notes + missingInWords(plan.job, gathered, options), exitCode: 2 };
  const rate = options.replay ?? Math.min(1, Math.max(USUAL_SHARE, FEW / plan.levels));
  const results = gathered.results.map((path) => path!);
  const { done: replayed, signal } = await stoppable((stopping) =>
    replaySample(plan, results, { rate, seed: gathered.seed, jobs: options.jobs, stopping }),
  );
  if (signal !== null) return { exitCode: exitCodeAfter(signal) };
  if (replayed.refuted.length > 0) {
    const lines = replayed.refuted
      .map(({ file, truth }) => `${namedPath(file)}: recorded as good, but it is ${truth}\n`)
      .join('');
    return {
      messages: `${notes}${lines}error: replays contradict the results: a machine computes otherwise, or a result was changed\n`,
      exitCode: 3,
    };
  }
  function* records() {
    for (const line of mergedRecords(results)) yield recordOfLine(line);
  }
  let report: CommandResult;
  try {
    report = await jobOf(plan.job).report(records, plan.report, asked, { quiet: options.quiet, withTimes: false });
  } catch (error) {
    if (error instanceof Failure) throw error;
    // no shard writes a record that can't be read; one without a good result is not repeated
    const why = `a record is not as gq writes it (${error instanceof Error ? error.message : error})`;
    return { messages: `${notes}error: ${why}: a result was changed; do the shards again\n`, exitCode: 3 };
  }
  const sample = rate === 0 ? 'no result was repeated' : `${plural(replayed.replayed, 'good result')} repeated: as recorded`;
  const whole = `${plural(plan.shards.length, 'shard')}, ${plural(plan.levels, contentsOf(plan.job) === 'plays' ? 'play' : 'level')}: each exactly once; ${sample}\n`;
  return { ...report, messages: notes + whole + (report.messages ?? '') };
}

/** The files that no report may replace; none where none is written. The levels need not be where the results are merged. */
async function levelsOf({ job, paths, ignore }: Plan, asked: readonly Destination[]): Promise<readonly string[]> {
  if (asked.every(({ file }) => file === null)) return [];
  try {
    return await setPaths(paths, ignore, contentsOf(job));
  } catch (error) {
    if (error instanceof Failure) return [];
    throw error;
  }
}

/** @throws Failure if a report is asked for that the command has not */
function expectFormats(job: JobName, asked: readonly Destination[]): void {
  const { formats } = jobOf(job);
  const other = asked.find(({ name }) => !formats.includes(name));
  if (other !== undefined)
    throw new Failure(`the plan is for gq ${job}, which has no report ${other.name}: expected ${formats.join(' or ')}`);
}

function listMissing(form: (typeof LISTS)[number], { missing }: Gathered): CommandResult {
  if (missing.length === 0) return { exitCode: 0 };
  return { output: form === 'list' ? missing.map((shard) => `${shard}\n`).join('') : `${rangesOf(missing)}\n`, exitCode: 2 };
}

function missingInWords(job: JobName, { missing, results }: Gathered, { plan }: Options): string {
  const ranges = rangesOf(missing);
  const which = missing.length === 1 ? `shard ${ranges} is` : `shards ${ranges} are`;
  return `error: ${missing.length} of ${plural(results.length, 'result')} missing: ${which} not there; do ${missing.length === 1 ? 'it' : 'them'} again: gq ${job} --plan ${shellPath(plan)} --shard ${missing[0]} --out ...\n`;
}
