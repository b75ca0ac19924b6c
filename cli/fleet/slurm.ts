import { shellWord } from '../io/index.ts';
import { rangesOf } from './ranges.ts';

/** What is to be submitted to Slurm. */
export interface SlurmOrder {
  /** The working directory, in which the paths of a plan are found. */
  readonly directory: string;
  /** Node and the file of gq that it runs. */
  readonly program: readonly [node: string, main: string];
  /** The command of which each shard is a part. */
  readonly command: string;
  readonly plan: string;
  /** The directory of the results. */
  readonly out: string;
  /** The shards to do, from 0. */
  readonly shards: readonly number[];
  /** The name of the jobs. */
  readonly name: string;
  /** Processors for each shard. */
  readonly cpus: number;
  /** Most shards at a time; null: as many as the cluster runs. */
  readonly atOnce: number | null;
  /** In Slurm's own notation; null: what the cluster gives. */
  readonly partition: string | null;
  readonly time: string | null;
  readonly memory: string | null;
}

/** A job for `sbatch`: its arguments, and the script that it reads from standard input. */
export interface SlurmJob {
  readonly args: readonly string[];
  readonly script: string;
}

/** The directory of what jobs print. */
export const logsOf = (out: string): string => inside(out, 'logs');

/** The report that the merge job writes. */
export const reportOf = (out: string): string => inside(out, 'report.json');

const inside = (folder: string, name: string): string => `${folder.replace(/\/+$/, '')}/${name}`;

/** The array job: a task for each shard. */
export function arrayJob(order: SlurmOrder): SlurmJob {
  const { command, plan, out, shards, cpus, atOnce, name } = order;
  const array = `--array=${rangesOf(shards)}${atOnce === null ? '' : `%${atOnce}`}`;
  return {
    args: ['--parsable', array, ...commonArgs(order, name, 'shard-%a.log'), `--cpus-per-task=${cpus}`],
    // not --shard auto: the environment of who submits comes along, and another system may have numbered that
    script: scriptOf(
      order,
      [command, '--plan', path(plan)],
      ['--shard', '"$SLURM_ARRAY_TASK_ID"'],
      ['--out', path(out), '--jobs', `${cpus}`],
    ),
  };
}

/**
 * The job that merges the results once every task has ended, however it ended.
 * @param after the number of the array job
 */
export function mergeJob(order: SlurmOrder, after: string): SlurmJob {
  const { plan, out, name } = order;
  const report = ['--format', 'json', '-o', path(reportOf(out))];
  return {
    args: ['--parsable', `--dependency=afterany:${after}`, ...commonArgs(order, `${name}-merge`, 'merge.log')],
    script: scriptOf(order, ['merge', path(out), '--plan', path(plan)], [], report),
  };
}

/** A shell script that does what a submission does: for a look, a change by hand, or another machine. */
export function submission(order: SlurmOrder): string {
  const array = arrayJob(order);
  const merge = mergeJob(order, AFTER);
  return `#!/bin/sh
set -e
cd ${shellWord(order.directory)}
mkdir -p ${shellWord(path(logsOf(order.out)))}

array=$(
${sbatchLine(array, 'ARRAY_JOB')}
)

# after the last task, however it ends; with a federation of clusters, the number is followed by ;CLUSTER
${sbatchLine(merge, 'MERGE_JOB').replace(AFTER, '"$' + '{array%%;*}"')}
`;
}

/** Stands for the number of the array job, which only the submission knows. */
const AFTER = '@array@';

function sbatchLine({ args, script }: SlurmJob, end: string): string {
  return `sbatch ${args.map(shellWord).join(' ')} <<'${end}'\n${script}${end}`;
}

function commonArgs({ directory, out, partition, time, memory }: SlurmOrder, name: string, log: string): string[] {
  return [
    `--job-name=${name}`,
    `--chdir=${directory}`,
    `--output=${inside(logsOf(out).replaceAll('%', '%%'), log)}`,
    // a task that is started again adds to what it has said before
    '--open-mode=append',
    '--requeue',
    ...(partition === null ? [] : [`--partition=${partition}`]),
    ...(time === null ? [] : [`--time=${time}`]),
    ...(memory === null ? [] : [`--mem=${memory}`]),
  ];
}

/** @param words parts of the command line; those of `program` and `first` and `last` are quoted, `middle` is for the shell */
function scriptOf({ program }: SlurmOrder, first: readonly string[], middle: readonly string[], last: readonly string[]): string {
  const words = [...program.map(shellWord), ...first.map(shellWord), ...middle, ...last.map(shellWord)];
  return `#!/bin/sh\nexec ${words.join(' ')}\n`;
}

/** A path that no command takes for an option. */
const path = (text: string): string => (text.startsWith('-') ? `./${text}` : text);
