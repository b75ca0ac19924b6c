import type { Hold, Level } from '../../schema/index.ts';

/** A level with a script. Benchmarks, their tests and the peers share it, so that all of them measure the same thing. */
export interface BenchScene {
  readonly name: string;
  /** One line for people. */
  readonly what: string;
  readonly level: Level;
  /** [press, release) in ticks of 1/60 s. */
  readonly holds: readonly Hold[];
  /** Simulated time, s. */
  readonly seconds: number;
}
