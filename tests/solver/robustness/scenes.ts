import fc from 'fast-check';
import { type AccuracyName, compile, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { createSearch, type Goal, verifyRun } from '../../../solver/index.ts';
import { arbitrarySolvableLevel } from '../search/solvable-levels.ts';

export const ANY: Goal = { minerals: 'any' };

export interface Found {
  readonly scene: Scene;
  /** It meets `goal`, except for one in three, which are moved at random. */
  readonly holds: readonly Hold[];
  readonly goal: Goal;
}

const few = (most: number) => fc.oneof(fc.integer({ min: 1, max: 2 }), fc.integer({ min: 1, max: most }));

/** A scene with a run found in it, cut into more holds and moved at random, so that runs with all kinds of slack occur. */
export const arbitraryRun = (accuracy: AccuracyName = 'arcade', mostHolds = 2): fc.Arbitrary<Found> =>
  fc
    .record({
      level: arbitrarySolvableLevel,
      seed: fc.nat(1000),
      goal: fc.constantFrom<Goal>(ANY, ANY, { minerals: 1 }),
      pause: fc.option(fc.record({ at: few(60), ticks: few(8) })),
      moved: fc.constantFrom(0, 0, 1, 3),
    })
    .map(({ level, seed, goal, pause, moved }): Found | null => {
      const scene = compile(level, accuracy);
      const search = createSearch(scene, { goal, seed });
      for (let i = 0; i < 20 && search.solutions.length === 0; i++) search.advance(2000);
      const found = search.solutions[0]?.holds;
      if (found === undefined || found.length === 0) return null;
      const holds = found.map(([press, release]): Hold => [press + moved, release + 20]);
      const [press, release] = holds[0];
      // A short pause brings edges so close together that shifts change their order.
      if (pause !== null && press + pause.at + pause.ticks < release && holds.length < mostHolds) {
        holds.splice(0, 1, [press, press + pause.at], [press + pause.at + pause.ticks, release]);
      }
      return holds.length > mostHolds ? null : { scene, holds, goal };
    })
    .filter((found): found is Found => found !== null);

/** The slow and certain way: every run alone, by the one judge. */
export const succeeds = ({ scene, goal }: Found, holds: readonly Hold[]): boolean => verifyRun(scene, holds, goal) !== null;
