import { compile, simulate } from '../../engine/index.ts';
import { resolveLevel } from '../../schema/index.ts';
import { createGenerator, type Generated, type GeneratorOptions, type Rejection } from '../../solver/index.ts';

/** A task for a worker: to generate a level from a seed. */
export interface GenerateTask {
  readonly options: GeneratorOptions;
  /** The largest effort, ticks. */
  readonly effort: number;
}

/** The result for a seed. */
export interface MadeLevel {
  readonly seed: number;
  /** null: no layout was good enough within the effort */
  readonly made: Generated | null;
  /** The time of its run `solution`, s; null if there is no level. */
  readonly length: number | null;
  /** The number of layouts that were begun; all but the last failed, and without a level the last one, too. */
  readonly attempts: number;
  readonly ticks: number;
  /** How many layouts were given up for each reason. */
  readonly rejected: Readonly<Record<Rejection, number>>;
}

const SLICE = 1_000_000;

/** Generates a level; blocks the calling thread until it is done. */
export function makeLevel({ options, effort }: GenerateTask): MadeLevel {
  const generator = createGenerator(options);
  while (generator.result === null && generator.effort.ticks < effort) {
    generator.advance(Math.min(SLICE, effort - generator.effort.ticks));
  }
  const made = generator.result;
  const length = made === null ? null : simulate(compile(resolveLevel(made.level)), made.holds).time;
  return { seed: options.seed, made, length, ...generator.effort };
}
