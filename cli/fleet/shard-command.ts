import process from 'node:process';
import type { CommandResult } from '../command.ts';
import type { ShardOptions } from '../options/index.ts';
import { createProgress, exitCodeAfter, Failure, namedPath, stoppable } from '../terminal/index.ts';
import { contentsOf } from './job.ts';
import { jobOf } from './jobs/index.ts';
import { readPlan } from './plan.ts';
import { runShard } from './run-shard.ts';

/** Does the shard of a plan that the options choose. */
export async function shardOfPlan(
  name: string,
  { plan: file, shard: asked, out }: ShardOptions,
  jobs: number,
): Promise<CommandResult> {
  const plan = readPlan(file!);
  if (plan.job !== name)
    throw new Failure(`${namedPath(file!)} is a plan for gq ${plan.job}: run gq ${plan.job} --plan, not gq ${name}`);
  const { shard, message } = chooseShard(asked!, process.env, plan.shards.length);
  const progress = createProgress('done', plan.shards[shard].levels);
  const { done, signal } = await stoppable((stopping) =>
    runShard(plan, shard, out!, { jobs, isLong: jobOf(plan.job).isLong(plan.settings), stopping, onProgress: progress.update }),
  ).finally(progress.clear);
  const said = message === '' ? '' : `${message.trimEnd()}\n`;
  if (signal !== null || done.status === 'stopped')
    return { messages: said, exitCode: signal === null ? 2 : exitCodeAfter(signal) };
  if (done.status === 'differs') {
    const why = `${namedPath(done.path)} has been written meanwhile and differs; this result is ${namedPath(done.kept)}`;
    return { messages: `${said}error: ${why}: a machine computes otherwise; gq merge says where\n`, exitCode: 3 };
  }
  const count = `${done.levels} of ${plan.levels} ${contentsOf(plan.job)}`;
  return { messages: `${said}${namedPath(done.path)}: ${done.status}: ${count}\n`, exitCode: 0 };
}

/** The variables of a process, as in `process.env`. */
export type Environment = Readonly<Record<string, string | undefined>>;

/** Which part of a plan a process does. */
interface ShardChoice {
  /** From 0. */
  readonly shard: number;
  readonly total: number;
  /** A line for people: which shard, and where its number is from. */
  readonly message: string;
}

/** A system that numbers the processes of a parallel job. */
interface System {
  readonly name: string;
  /** The variable with the number of the process. */
  readonly index: string;
  /** The number of the first process. */
  readonly first: 0 | 1;
  /** The variable with how many processes there are; null where the system has none that can be trusted. */
  readonly total: string | null;
}

const SYSTEMS: readonly System[] = [
  { name: 'GitLab', index: 'CI_NODE_INDEX', first: 1, total: 'CI_NODE_TOTAL' },
  { name: 'CircleCI', index: 'CIRCLE_NODE_INDEX', first: 0, total: 'CIRCLE_NODE_TOTAL' },
  { name: 'Buildkite', index: 'BUILDKITE_PARALLEL_JOB', first: 0, total: 'BUILDKITE_PARALLEL_JOB_COUNT' },
  { name: 'Azure Pipelines', index: 'SYSTEM_JOBPOSITIONINPHASE', first: 1, total: 'SYSTEM_TOTALJOBSINPHASE' },
  { name: 'Semaphore', index: 'SEMAPHORE_JOB_INDEX', first: 1, total: 'SEMAPHORE_JOB_COUNT' },
  { name: 'Bitbucket', index: 'BITBUCKET_PARALLEL_STEP', first: 0, total: 'BITBUCKET_PARALLEL_STEP_COUNT' },
  { name: 'AWS Batch', index: 'AWS_BATCH_JOB_ARRAY_INDEX', first: 0, total: 'AWS_BATCH_JOB_ARRAY_SIZE' },
  // SLURM_ARRAY_TASK_COUNT is the number of tasks submitted together: it is 1 when one shard of many is repeated
  { name: 'Slurm', index: 'SLURM_ARRAY_TASK_ID', first: 0, total: null },
  { name: 'Kubernetes', index: 'JOB_COMPLETION_INDEX', first: 0, total: null },
];

const BY_HAND = 'GQ_SHARD';

/** What one source says. */
interface Said {
  /** From 0. */
  readonly shard: number;
  /** Null if the source does not say it. */
  readonly total: number | null;
  /** The source as it was found, for messages. */
  readonly source: string;
}

/**
 * Decides which shard this process does.
 * @param asked the text of `--shard`: `3`, from 0; `4/8`, from 1; `auto`, from the environment
 * @param planned the number of shards in the plan; null without a plan
 * @throws Failure if that is not certain: a process that takes the wrong shard could leave levels out without a sign of it
 */
export function chooseShard(asked: string, environment: Environment, planned: number | null): ShardChoice {
  const said = asked === 'auto' ? fromEnvironment(environment) : fromOption(asked);
  if (said === null) return withoutSource(planned);
  const { shard, source } = said;
  if (planned !== null && said.total !== null && said.total !== planned) {
    throw new Failure(`${source}: expected ${planned} ${shards(planned)}, as in the plan, found ${said.total}`);
  }
  const total = planned ?? said.total;
  if (total === null) {
    throw new Failure(`${source}: it is not known how many shards there are: expected a total, as in --shard 4/8`);
  }
  requireWithin(said, total);
  const totalFrom = said.total === null ? '; the total is from the plan' : '';
  return { shard, total, message: `shard ${shard} (${shard + 1}/${total}), from ${source}${totalFrom}\n` };
}

const shards = (count: number): string => (count === 1 ? 'shard' : 'shards');
const numbersOf = (total: number): string => (total === 1 ? '0' : `0 to ${total - 1}`);

/** What there is to do when no variable names a shard: everything, but only if everything is one shard. */
function withoutSource(planned: number | null): ShardChoice {
  const variables = [BY_HAND, ...SYSTEMS.map(({ index }) => index)];
  if (planned !== null && planned !== 1) {
    throw new Failure(
      `--shard auto: the plan has ${planned} shards, and no variable says which one to do: expected one of ${variables.join(', ')}; or name the shard, as in --shard 0 or ${BY_HAND}=1/${planned}`,
    );
  }
  return { shard: 0, total: 1, message: `shard 0 (1/1): no variable names a shard, and everything is one shard\n` };
}

const PART = /^(\d+)\/(\d+)$/;
const A_SHARD = 'a shard, as 3 (counted from 0), 4/8 (counted from 1) or auto';
const A_PART = 'a shard and how many there are, counted from 1, as in 4/8';
const A_TOTAL = 'a number of shards';

function fromOption(asked: string): Said {
  const source = `--shard ${quotedIfOdd(asked)}`;
  if (PART.test(asked)) return fromPart(asked, source);
  return { shard: wholeNumber(asked, source, A_SHARD), total: null, source };
}

function fromEnvironment(environment: Environment): Said | null {
  const byHand = environment[BY_HAND];
  if (byHand !== undefined) return fromPart(byHand, shown(BY_HAND, byHand));
  const found = SYSTEMS.flatMap((system) => fromSystem(system, environment) ?? []);
  if (found.length === 0) return null;
  for (const [i, one] of found.entries()) {
    const other = found.slice(i + 1).find((later) => disagree(one, later));
    if (other === undefined) continue;
    throw new Failure(
      `--shard auto: two systems disagree: ${one.source} is ${inWords(one)}, ${other.source} is ${inWords(other)}; name the shard by --shard or ${BY_HAND}`,
    );
  }
  return {
    shard: found[0].shard,
    total: found.find(({ total }) => total !== null)?.total ?? null,
    source: found.map(({ source }) => source).join(' and '),
  };
}

const disagree = (a: Said, b: Said): boolean =>
  a.shard !== b.shard || (a.total !== null && b.total !== null && a.total !== b.total);

const inWords = ({ shard, total }: Said): string => `shard ${shard}${total === null ? '' : ` (${shard + 1}/${total})`}`;

function fromSystem(system: System, environment: Environment): Said | null {
  const { name, index, first } = system;
  const position = environment[index];
  const count = system.total === null ? undefined : environment[system.total];
  const ofTotal = system.total === null || count === undefined ? null : shown(system.total, count);
  const total = count === undefined || ofTotal === null ? null : wholeNumber(count, `${ofTotal} (${name})`, A_TOTAL);
  if (position === undefined) {
    // GitLab sets the total to 1 where a job is not parallel
    if (total === null || total === 1) return null;
    throw new Failure(`${ofTotal} (${name}): expected ${index} beside it, found none; name the shard by --shard or ${BY_HAND}`);
  }
  const ofIndex = shown(index, position);
  const source = `${ofTotal === null ? ofIndex : `${ofIndex}, ${ofTotal}`} (${name})`;
  const expected = `a whole number from ${first}`;
  const number = wholeNumber(position, `${ofIndex} (${name})`, expected);
  if (number < first) throw new Failure(`${ofIndex} (${name}): expected ${expected}`);
  const said = { shard: number - first, total, source };
  if (total !== null) requireWithin(said, total);
  return said;
}

/** `4/8`, counted from 1. */
function fromPart(text: string, source: string): Said {
  const [, part, count] = PART.exec(text) ?? [];
  const [number, total] = [part, count].map((digits) => wholeNumber(digits ?? '', source, A_PART));
  if (number === 0) throw new Failure(`${source}: expected a number from 1 in this form: the first shard is 1/${total}`);
  const said = { shard: number - 1, total, source };
  requireWithin(said, total);
  return said;
}

function requireWithin({ shard, source }: Said, total: number): void {
  if (total === 0) throw new Failure(`${source}: expected at least one shard, found a total of 0`);
  if (shard >= total)
    throw new Failure(`${source}: found shard ${shard} of ${total}: expected ${numbersOf(total)}, counted from 0`);
}

function wholeNumber(text: string, source: string, expected: string): number {
  const value = Number(text);
  if (/^\d+$/.test(text) && Number.isSafeInteger(value)) return value;
  throw new Failure(`${source}: expected ${expected}`);
}

const shown = (variable: string, value: string): string => `${variable}=${quotedIfOdd(value)}`;
const quotedIfOdd = (value: string): string => (/^[\w./-]+$/.test(value) ? value : JSON.stringify(value));
