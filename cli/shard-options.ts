import type { Command } from 'commander';
import { Failure, namedPath } from './io/index.ts';

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
