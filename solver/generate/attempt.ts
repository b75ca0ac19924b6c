import type { Random } from '../random.ts';
import { verifyRun } from '../verified-run.ts';
import { finish } from './finish.ts';
import type { Attempt } from './generated.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { closeShortcuts, harden, withoutUnused } from './harden.ts';
import { type Layout, layOut } from './layout.ts';
import { addNovae } from './novae.ts';
import { findRoute } from './route.ts';
import { ANY, findWays, gradeRun, sceneOf, scoutOnePress, sortByP40 } from './scouting.ts';
import { tubeOf } from './tube.ts';

// The cost of the search for a route, ticks, about.
const ROUTE_EFFORT = 500_000;

// How often a level that is too easy gets more novae.
const ROUNDS = 8;

// The cost of grading, in runs, about.
const GRADING = 1000;

/**
 * Makes one attempt at a level that fulfils a spec. The run comes first and the level is built around it:
 *
 * 1. Lay out asteroids at random, and find a run through them that ends where the black hole is then placed ({@link
 *    findRoute}).
 * 2. Add novae outside a tube around the run, which holds the run's slightly mistimed variations as well.
 * 3. Put novae onto easier paths and onto those that random play finds, until the grade is as wanted ({@link harden}).
 * 4. Add minerals, measure the finished level and check everything that is claimed of it ({@link finish}).
 *
 * A level that fails any of the promises is discarded.
 */
export function* attemptLevel(random: Random, spec: GeneratorSpec, description: string): Attempt {
  const empty = layOut(random, spec);
  if (empty === null) return null;
  const route = findRoute(empty, spec, random);
  yield ROUTE_EFFORT;
  if (route === null) return null;
  const intended = route.run;
  let layout: Layout = withoutUnused(route.layout, intended.holds);

  const tube = tubeOf(sceneOf(layout), intended.holds, spec.tube, random);
  layout = addNovae(layout, spec, tube, spec.novae, random);
  for (let round = 0; round < ROUNDS; round++) {
    layout = closeShortcuts(layout, spec, tube, intended, random);
    const scene = sceneOf(layout);
    const found = yield* findWays(scene, ANY, random.next());
    const ways = sortByP40(scene, [...found, ...(verifyRun(scene, intended.holds) === null ? [] : [intended])]);
    if (ways.length === 0) return null;
    const grade = gradeRun(scene, ways[0], random.next());
    yield GRADING * ways[0].tick;
    if (grade.value > spec.grade[1]) return null;
    const presses = scoutOnePress(scene, ways[0]);
    if (grade.value >= spec.grade[0] && presses.count <= spec.onePress * presses.tried) {
      const generated = yield* finish(layout, spec, ways, random, description);
      if (generated !== null) return generated;
    }
    const harder = harden(layout, spec, intended, ways, random);
    if (harder === layout) return null;
    layout = harder;
  }
  return null;
}
