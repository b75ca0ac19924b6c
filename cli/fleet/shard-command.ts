import process from 'node:process';
import type { Command } from 'commander';
import type { CommandResult } from '../command.ts';
import { Failure } from '../failure.ts';
import { createProgress } from '../progress.ts';
import { namedPath } from '../shown-path.ts';
import { exitCodeAfter, stoppable } from '../signals.ts';
import { contentsOf } from './job-names.ts';
import { jobOf } from './jobs/index.ts';
import { readPlan } from './plan.ts';
import { runShard } from './run-shard.ts';
import { chooseShard } from './shard-number.ts';

/** The values of the options that `addShardOptions` declares. */
export interface ShardOptions {
  readonly plan?: string;
  readonly shard?: string;
  readonly out?: string;
}

/** Declares the options for a shard of a plan. */
export const addShardOptions = (command: Command): Command =>
  command
    .option('--plan <file>', 'do one shard of a plan of gq plan, which has the paths and all other options')
    .option('--shard <i>', 'with --plan: which one: 3 from 0, 4/8 from 1, or auto: from the system that runs it')
    .option('--out <dir>', 'with --plan: the directory for its result');

/** Options that a shard takes besides those of the plan. */
const OWN = new Set(['plan', 'shard', 'out', 'jobs']);

/** @throws Failure if an option is given that only a plan can have, or one of a shard without a plan */
export function refuseBesidesPlan(command: Command, paths: readonly string[], { plan, shard, out }: ShardOptions): void {
  if (plan === undefined) {
    const given = shard !== undefined ? '--shard' : out !== undefined ? '--out' : null;
    if (given !== null) throw new Failure(`${given} is for a shard of a plan: expected --plan FILE with it; gq plan makes one`);
    return;
  }
  if (shard === undefined) throw new Failure('--plan: expected --shard with it: 3 (from 0), 4/8 (from 1) or auto');
  if (out === undefined) throw new Failure('--plan: expected --out DIR with it, the directory for the result');
  if (paths.length > 0) throw new Failure(`the plan has the paths: expected none with --plan, found ${namedPath(paths[0])}`);
  for (const option of command.options) {
    const name = option.attributeName();
    if (OWN.has(name) || command.getOptionValueSource(name) !== 'cli') continue;
    throw new Failure(`${option.long} comes from the plan: give it to gq plan, not with --plan`);
  }
}

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
