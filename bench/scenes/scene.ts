import type { Hold, Level } from '../../schema/index.ts';

/** A level with a script, shared by benchmarks, their tests and the peers, so that all speak of the same thing. */
export interface BenchScene {
  readonly name: string;
  /** One line for a person. */
  readonly what: string;
  readonly level: Level;
  /** [press, release) in ticks of 1/60 s. */
  readonly holds: readonly Hold[];
  /** s */
  readonly seconds: number;
}
