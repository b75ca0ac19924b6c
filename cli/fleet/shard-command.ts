import process from 'node:process';
import type { CommandResult } from '../command.ts';
import { createProgress, exitCodeAfter, Failure, namedPath, stoppable } from '../io/index.ts';
import type { ShardOptions } from '../shard-options.ts';
import { contentsOf } from './job-names.ts';
import { jobOf } from './jobs/index.ts';
import { readPlan } from './plan.ts';
import { runShard } from './run-shard.ts';
import { chooseShard } from './shard-number.ts';

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
