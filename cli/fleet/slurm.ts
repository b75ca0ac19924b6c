import { spawnSync } from 'node:child_process';
import process from 'node:process';
import { Failure, shellWord } from '../terminal/index.ts';

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
interface SlurmJob {
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

/**
 * Whole numbers in the notation of job arrays, sorted and each once: `2,5-7`. Three or more in a row become a range, as in
 * the status of a Job of Kubernetes. Without numbers it is empty.
 */
export function rangesOf(numbers: Iterable<number>): string {
  const sorted = [...new Set(numbers)].sort((a, b) => a - b);
  const parts: string[] = [];
  for (let i = 0; i < sorted.length; ) {
    const first = i;
    while (i + 1 < sorted.length && sorted[i + 1] === sorted[i] + 1) i++;
    const row = sorted.slice(first, ++i);
    if (row.length < 3) parts.push(...row.map(String));
    else parts.push(`${row[0]}-${row.at(-1)}`);
  }
  return parts.join(',');
}

/**
 * The numbers that `2,5-7` stands for, sorted and each once.
 * @param source what has the text, for messages
 * @param total the numbers are less than this
 * @throws Failure if the text is not of this form
 */
export function readRanges(text: string, source: string, total: number): number[] {
  const found = new Set<number>();
  for (const part of text.split(',')) {
    const match = /^(\d+)(?:-(\d+))?$/.exec(part);
    if (match === null)
      throw new Failure(`${source} ${JSON.stringify(text)}: expected shards, as in 2,5-7, found ${JSON.stringify(part)}`);
    const first = Number(match[1]);
    const last = Number(match[2] ?? match[1]);
    if (last < first) throw new Failure(`${source} ${text}: ${part} goes down: expected ${last}-${first}`);
    if (last >= total) {
      throw new Failure(
        `${source} ${text}: found no shard ${last}: the plan has ${total}, counted from 0; expected at most ${total - 1}`,
      );
    }
    for (let number = first; number <= last; number++) found.add(number);
  }
  return [...found].sort((a, b) => a - b);
}

/** Slurm's own default of MaxArraySize. */
export const USUAL_ARRAY_SIZE = 1001;

/**
 * Submits a job.
 * @param what the job in messages
 * @returns its number
 * @throws Failure with the words of `sbatch` if it refuses
 */
export function submitJob({ args, script }: SlurmJob, what: string): string {
  const answer = ask('sbatch', args, script);
  if (answer === null) {
    throw new Failure(
      'gq submit slurm needs the command sbatch, and there is none in PATH: run it on a machine of the cluster from which jobs are submitted; gq submit slurm --dry-run prints the jobs for another machine',
    );
  }
  const id = /^(\d+)(?:;\S*)?$/m.exec(answer.output)?.[1];
  if (answer.ok && id !== undefined) return id;
  throw new Failure(
    `sbatch refused ${what}: ${answer.words === '' ? `it said nothing and ended with ${answer.ending}` : answer.words}`,
  );
}

/** The least number that a task may not have; null if there is no cluster to be asked. */
export function maxArraySize(): number | null {
  const answer = ask('scontrol', ['show', 'config'], '');
  const size = answer === null ? undefined : /^MaxArraySize\s*=\s*(\d+)/m.exec(answer.output)?.[1];
  return size === undefined ? null : Number(size);
}

interface Answer {
  readonly ok: boolean;
  readonly output: string;
  /** What a command says on both streams, on one line. */
  readonly words: string;
  /** An exit code or a signal. */
  readonly ending: string;
}

/** @returns null if there is no such command */
function ask(command: string, args: readonly string[], input: string): Answer | null {
  const { status, signal, stdout, stderr, error } = spawnSync(command, args, {
    input,
    encoding: 'utf8',
    windowsHide: true,
    env: { ...process.env, LC_ALL: 'C' },
  });
  // a command that does not read its input is no error
  if (error !== undefined && (error as NodeJS.ErrnoException).code !== 'EPIPE') {
    if ((error as NodeJS.ErrnoException).code === 'ENOENT') return null;
    throw new Failure(`${command} can't be run: ${error.message}`);
  }
  const words = `${stderr}\n${stdout}`.split('\n').map((line) => line.trim());
  return {
    ok: status === 0,
    output: stdout,
    words: words.filter((line) => line !== '').join('; '),
    ending: `${signal ?? `exit code ${status}`}`,
  };
}
