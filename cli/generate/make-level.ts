import { compile, simulate } from '../../engine/index.ts';
import { resolveLevel } from '../../schema/index.ts';
import { createGenerator, type Generated, type GeneratorOptions } from '../../solver/index.ts';

/** One task of a worker: a level from a seed. */
export interface GenerateTask {
  readonly options: GeneratorOptions;
  /** Ticks simulated at most. */
  readonly effort: number;
}

/** What came of a seed. */
export interface MadeLevel {
  readonly seed: number;
  /** null: nothing that was good enough within the effort */
  readonly made: Generated | null;
  /** Of its run `solution`, s; null when nothing was made. */
  readonly length: number | null;
  /** Layouts begun; all but the last came to nothing, the last, too, when nothing was made. */
  readonly attempts: number;
  readonly ticks: number;
}

const SLICE = 1_000_000;

/** Makes a level; takes the thread it is called from until it is done. */
export function makeLevel({ options, effort }: GenerateTask): MadeLevel {
  const generator = createGenerator(options);
  while (generator.result === null && generator.effort.ticks < effort) {
    generator.advance(Math.min(SLICE, effort - generator.effort.ticks));
  }
  const made = generator.result;
  const length = made === null ? null : simulate(compile(resolveLevel(made.level)), made.holds).time;
  return { seed: options.seed, made, length, ...generator.effort };
}
