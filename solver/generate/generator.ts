import { createRandom } from '../random.ts';
import { attemptLevel } from './attempt.ts';
import { type Attempt, type Generated, REJECTIONS, type Rejection } from './generated.ts';
import { type GeneratorOptions, specOf } from './generator-spec.ts';
import { THEMES } from './themes/index.ts';

/** Generates one level. The caller decides how long it works. */
export interface LevelGenerator {
  /** The work done so far. */
  readonly effort: {
    /** Layouts begun. */
    readonly attempts: number;
    /** Ticks simulated, plus 1000 for each attempt. */
    readonly ticks: number;
    /** How many were given up for each reason. */
    readonly rejected: Readonly<Record<Rejection, number>>;
  };
  /** The level; null until one fulfils everything that was asked for. */
  readonly result: Generated | null;
  /**
   * Continues the work until there is a result or the ticks are spent. The same seed gives the same level however the work is
   * split into calls.
   * @param ticks how many more ticks to simulate; the generator may overshoot
   */
  advance(ticks: number): void;
}

// The cost of an attempt besides its simulations, ticks, so that attempts that fail at once also come to an end.
const OVERHEAD = 1000;

/**
 * Creates a generator that makes a level from a seed. It lays out asteroids at random, finds a run, closes easier paths with
 * novae until the level is as hard as wanted, and adds minerals. Layouts that fail are discarded, and the next one is begun.
 * @param options the seed, and what the level should be like
 * @returns a generator at its start
 * @throws RangeError if the size or the difficulty is out of range
 * @example
 * ```ts
 * import { createGenerator } from 'gravity-quest-toolkit/solver';
 *
 * const generator = createGenerator({ seed: 7, size: 'small', difficulty: 'easy' });
 * while (generator.result === null) generator.advance(1_000_000);
 * console.log(generator.result.level.name, generator.result.grade.value);
 * ```
 */
export function createGenerator(options: GeneratorOptions): LevelGenerator {
  const asked = specOf(options);
  const spec = asked.theme === null ? asked : { ...asked, ...THEMES[asked.theme].adjust(asked) };
  const random = createRandom(options.seed);
  const description = `Generated from seed ${options.seed}.`;
  let attempts = 0;
  let ticks = 0;
  const rejected = Object.fromEntries(REJECTIONS.map((reason) => [reason, 0])) as Record<Rejection, number>;
  let result: Generated | null = null;
  let attempt: Attempt | null = null;
  return {
    get effort() {
      return { attempts, ticks, rejected: { ...rejected } };
    },
    get result() {
      return result;
    },
    advance(more) {
      const until = ticks + more;
      while (result === null && ticks < until) {
        if (attempt === null) {
          attempts++;
          ticks += OVERHEAD;
          attempt = attemptLevel(random.fork(), spec, description);
        }
        const step = attempt.next();
        if (step.done !== true) {
          ticks += step.value;
          continue;
        }
        if (typeof step.value === 'string') rejected[step.value]++;
        else result = step.value;
        attempt = null;
      }
    },
  };
}
