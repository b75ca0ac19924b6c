import { createRandom } from '../random.ts';
import { attemptLevel } from './attempt.ts';
import type { Attempt, Generated } from './generated.ts';
import { type GeneratorOptions, specOf } from './generator-spec.ts';

/** A level in the making, to be advanced as long as one likes. */
export interface LevelGenerator {
  /** Layouts begun and ticks simulated so far. */
  readonly effort: { readonly attempts: number; readonly ticks: number };
  /** null until a level fulfils everything that was asked for */
  readonly result: Generated | null;
  /** Works on for about so many simulated ticks, or until there is a result. The same seed gives the same level however it is split. */
  advance(ticks: number): void;
}

// what an attempt costs besides what it simulates, in ticks, so that attempts that fail at once come to an end, too
const OVERHEAD = 1000;

/**
 * Makes a level from a seed: lays out asteroids at random, finds a run, closes easier ways with novae until it is as hard as wanted,
 * adds minerals. A layout that comes to nothing is thrown away and the next one begun.
 * @throws RangeError for a size or a difficulty that can't be
 */
export function createGenerator(options: GeneratorOptions): LevelGenerator {
  const spec = specOf(options);
  const random = createRandom(options.seed);
  const description = `Generated from seed ${options.seed}.`;
  let attempts = 0;
  let ticks = 0;
  let result: Generated | null = null;
  let attempt: Attempt | null = null;
  return {
    get effort() {
      return { attempts, ticks };
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
        result = step.value;
        attempt = null;
      }
    },
  };
}
