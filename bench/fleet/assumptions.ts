import { mean } from '../harness/index.ts';

/** What one job costs for each level, s of one core, the dearest first: levels of the set are drawn from these. */
export type LevelCosts = readonly number[];

/** Costs that are measured by running gq, s of processor time. */
export interface Measured {
  /** What the replay of a level with one run costs. */
  readonly replay: LevelCosts;
  /** What a level costs for which a run is searched and none is in its file. */
  readonly search: LevelCosts;
  /** Most ticks of each of these searches. */
  readonly effort: number;
  /** The start of a process until its first level. */
  readonly start: number;
  /** Reading and hashing one level that belongs to another shard. */
  readonly scan: number;
  /** What `gq plan` needs for a level. */
  readonly plan: number;
  /** What `gq merge` needs for a level. */
  readonly merge: number;
}

/** The machines, and how they fail. Chosen, not measured. */
export interface Fleet {
  readonly machines: number;
  /** Shards that a machine does at a time, one on each core. */
  readonly cores: number;
  /** How often a running task dies, per hour; exponential. */
  readonly taskDeathsPerHour: number;
  /** How often a machine dies with all its tasks, per hour; exponential. */
  readonly machineDeathsPerHour: number;
  /** s until a death is noticed: a timeout. The slot of a task that died is lost meanwhile. */
  readonly detection: number;
  /** s from then on until the shard waits for a slot again */
  readonly restartDelay: number;
  /** s until a dead machine is back */
  readonly repair: number;
  /** The share of the tasks that run slowly. */
  readonly stragglers: number;
  /** How many times as long these take. */
  readonly slowdown: number;
}

/** All that the model takes for granted. */
export interface Assumptions {
  /** Levels in the set. */
  readonly levels: number;
  readonly measured: Measured;
  readonly fleet: Fleet;
  /** A running shard gets a second copy once it has taken this many times the mean of those that ended. */
  readonly patience: number;
}

const whole = (value: number): string => Math.round(value).toLocaleString('en-US');

/** Says the assumptions in sentences. */
export function inWords({ levels, measured, fleet, patience }: Assumptions): string[] {
  const { replay, search, effort, start, scan, plan, merge } = measured;
  return [
    `Measured now on this machine, by processor time: a replay costs ${(mean(replay) * 1000).toFixed(2)} ms (${whole(1 / mean(replay))} levels a second of one core), a search of at most ${whole(effort)} ticks ${(mean(search) * 1000).toFixed(0)} ms in the mean of ${search.length} random levels and ${search[0].toFixed(1)} s at most. A process starts in ${start.toFixed(2)} s and skips ${whole(1 / scan)} levels of other shards a second. gq plan reads ${whole(1 / plan)} levels a second, gq merge ${whole(1 / merge)}.`,
    `Assumed: ${whole(levels)} levels, their costs drawn from the measured ones; ${fleet.machines} machines with ${fleet.cores} cores, a shard on each core. A task dies ${fleet.taskDeathsPerHour} times an hour, a machine ${fleet.machineDeathsPerHour} times. A death is noticed after ${fleet.detection} s, the shard waits again ${fleet.restartDelay} s later, the machine is back after ${fleet.repair} s. ${(100 * fleet.stragglers).toFixed(0)} % of the tasks take ${fleet.slowdown} times as long. A second copy starts on a free core once a shard has taken ${patience} times the mean.`,
    'Not in the model: reading over a network or from a shared disk, machines of different speed, costs that differ from those of the last time.',
  ];
}
