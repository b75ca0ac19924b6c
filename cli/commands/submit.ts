import { accessSync, constants, existsSync, realpathSync } from 'node:fs';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { Argument, type Command } from 'commander';
import type { CommandHelp, CommandResult } from '../command.ts';
import {
  arrayJob,
  gather,
  logsOf,
  maxArraySize,
  mergeJob,
  type Plan,
  rangesOf,
  readPlan,
  readRanges,
  reportOf,
  type SlurmOrder,
  submission,
  submitJob,
  USUAL_ARRAY_SIZE,
} from '../fleet/index.ts';
import { makeFolders } from '../io/index.ts';
import { wholeNumberOption } from '../options/index.ts';
import { Failure, hearSignals, namedPath, shellPath, systemReason, visibleLine } from '../terminal/index.ts';

interface Options {
  readonly plan: string;
  readonly out: string;
  readonly dryRun?: true;
  readonly name: string;
  readonly partition?: string;
  readonly time?: string;
  readonly mem?: string;
  readonly cpus: number;
  readonly maxRunning?: number;
  readonly only?: string;
  readonly missing?: true;
}

export const help: CommandHelp = {
  description:
    'Run the shards of a plan on a cluster: an array job with a task for each shard, and a job after it that merges the results.',
  more: `
The jobs run in the current directory with this gq and this Node, so all nodes must see them at the same paths. What a shard prints
is in DIR/logs; the report is DIR/report.json. The merge job fails if a level fails or a result is missing, with the exit codes of
gq merge. A shard whose result is there is not done again.

Exit code: 0 when the jobs were submitted, or nothing is missing; 2 when they were not.

Examples:
  $ gq submit slurm --plan plan.json --out out --dry-run
  $ gq submit slurm --plan plan.json --out out --partition short --time 30 --max-running 50
  $ gq submit slurm --plan plan.json --out out --missing`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .addArgument(new Argument('<system>', 'the system of the cluster').choices(['slurm']))
    .requiredOption('--plan <file>', 'the plan, as gq plan has written it')
    .requiredOption('--out <dir>', 'directory for results, logs and report; every node must have it and the levels')
    .option('--dry-run', 'print the jobs as a shell script and submit nothing')
    .option('--only <shards>', 'submit these shards alone, counted from 0, as in 2,5-7')
    .option('--missing', 'submit the shards alone whose results are missing')
    .option('--name <name>', 'name of the jobs', 'gq')
    .option('--partition <name>', 'partition of the cluster (default: the one that the cluster gives)')
    .option('--time <time>', 'most time for a shard, in the notation of Slurm: minutes, or hours:minutes:seconds')
    .option('--mem <size>', 'memory for a shard, in the notation of Slurm: 500M, 2G')
    .option('--cpus <n>', 'processors for each shard', wholeNumberOption('a number of processors', 1, 256), 1)
    .option('--max-running <n>', 'most shards at a time', wholeNumberOption('a number of shards', 1, 1_000_000))
    .action(async (_system: string, options: Options) => finish(await submit(options)));
}

async function submit(options: Options): Promise<CommandResult> {
  const { plan, out, only, missing } = options;
  for (const [option, value] of Object.entries({ '--out': out, '--name': options.name, '--partition': options.partition })) {
    if (value === '') throw new Failure(`${option} "": expected a name, found nothing`);
  }
  if (only !== undefined && missing) throw new Failure('--only and --missing each choose the shards: expected one of them');
  const planned = readPlan(plan);
  const total = planned.shards.length;
  const command = planned.job;
  const shards = missing
    ? await missingShards(planned, out)
    : only === undefined
      ? all(total)
      : readRanges(only, '--only', total);
  if (shards.length === 0) {
    return {
      output: `nothing is missing: ${namedPath(out)} has the results of all ${total} shards of ${namedPath(plan)}\n`,
      exitCode: 0,
    };
  }
  const order = orderOf(options, command, shards);
  refuseHidden(order);
  const warning = fitOrWarn(order, total);
  if (options.dryRun) return { output: submission(order), messages: warning, exitCode: 0 };
  makeFolder(out);
  await hearSignals();
  const array = submitJob(arrayJob(order), 'the array job');
  const merge = submitMerge(order, array);
  const what = shards.length === total ? `all ${total} shards` : `${shards.length} of ${total} shards: ${rangesOf(shards)}`;
  return {
    output: `job ${array}: ${what}\njob ${merge}: the merge after them, which writes ${reportOf(out)}\nlogs: ${logsOf(out)}\nto see how far they are: squeue --jobs ${array},${merge}\n`,
    messages: warning,
    exitCode: 0,
  };
}

/** The shards without a good result. Without the directory, that is all of them. */
const missingShards = async (plan: Plan, out: string): Promise<readonly number[]> =>
  existsSync(out) ? (await gather(plan, [out])).missing : all(plan.shards.length);

const all = (total: number): number[] => Array.from({ length: total }, (_, i) => i);

function orderOf(options: Options, command: string, shards: readonly number[]): SlurmOrder {
  return {
    directory: process.cwd(),
    program: [process.execPath, realpathSync(fileURLToPath(new URL('../main.js', import.meta.url)))],
    command,
    plan: options.plan,
    out: options.out,
    shards,
    name: options.name,
    cpus: options.cpus,
    atOnce: options.maxRunning ?? null,
    partition: options.partition ?? null,
    time: options.time ?? null,
    memory: options.mem ?? null,
  };
}

/**
 * Scripts and settings of Slurm go line by line: a line break in a name would end the text of a script, or begin a setting.
 * @throws Failure if a name has a character that does not show
 */
function refuseHidden({ plan, out, name, partition, time, memory, directory, program }: SlurmOrder): void {
  const [node, main] = program;
  const values = { '--plan': plan, '--out': out, '--name': name, '--partition': partition, '--time': time, '--mem': memory };
  const places = { 'the current directory': directory, 'the path of Node': node, 'the path of gq': main };
  for (const [what, value] of Object.entries({ ...values, ...places })) {
    if (value === null || visibleLine(value) === value) continue;
    throw new Failure(
      `${what} "${visibleLine(value)}": expected a name without line breaks and other characters that do not show, as the jobs are shell scripts: rename it`,
    );
  }
}

/**
 * Array jobs have a largest number of a task.
 * @returns a warning if it is not known and may be passed
 */
function fitOrWarn({ shards }: SlurmOrder, total: number): string {
  const last = shards[shards.length - 1];
  const size = maxArraySize();
  if (size === null) {
    if (last < USUAL_ARRAY_SIZE) return '';
    return `warning: the plan has ${total} shards; unless the cluster allows more (MaxArraySize), Slurm refuses tasks above ${USUAL_ARRAY_SIZE - 1}\n`;
  }
  if (last < size) return '';
  throw new Failure(
    `the plan has ${total} shards, and the cluster allows array jobs with tasks 0 to ${size - 1} (MaxArraySize=${size}): expected at most ${size} shards; make the plan again with gq plan --shards ${size} or fewer, or ask for a larger MaxArraySize`,
  );
}

function makeFolder(out: string): void {
  const logs = logsOf(out);
  try {
    makeFolders(logs);
    for (const folder of [out, logs]) accessSync(folder, constants.W_OK | constants.X_OK);
  } catch (error) {
    throw new Failure(
      `--out ${namedPath(out)}: ${systemReason(error)}: expected a directory that can be written, or a place where one can be made`,
    );
  }
}

function submitMerge(order: SlurmOrder, array: string): string {
  try {
    return submitJob(mergeJob(order, array), 'the merge job');
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    const byHand = `gq merge ${shellPath(order.out)} --plan ${shellPath(order.plan)}`;
    throw new Failure(
      `${error.message}\njob ${array} with the shards is submitted all the same: once it has ended, run ${byHand}; or cancel it with scancel ${array}`,
    );
  }
}
