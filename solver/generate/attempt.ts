import type { Random } from '../random.ts';
import { successProbability } from '../robustness/index.ts';
import { type Candidate, verifyRun } from '../verified-run.ts';
import { compose } from './compose.ts';
import { finish } from './finish.ts';
import type { Attempt, Rejection } from './generated.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { closeShortcuts, harden, withoutUnused } from './harden.ts';
import { type Layout, layOut } from './layout.ts';
import { addNovae } from './novae.ts';
import { findRoute, type Route } from './route.ts';
import { ANY, findWays, gradeRun, sceneOf, scoutOnePress, sortByP40 } from './scouting.ts';
import { isOnTheme, PLAIN_STAGE, type Stage } from './stage.ts';
import { Site, THEMES, type Theme, withImages } from './themes/index.ts';
import { forgives, tubeOf } from './tube.ts';

// The cost of the search for a route, ticks, about.
const ROUTE_EFFORT = 500_000;

// How often a level is changed towards the wanted grade.
const ROUNDS = 12;

// Ticks to find easier runs after each change.
const EASIER_EFFORT = 300_000;

// Known runs that are kept from round to round.
const WAYS = 6;

// Runs that are graded.
const GRADED = 3;

// The cost of grading a run, in runs, about.
const GRADING = 1000;

const SAMPLES = 150;

// How far success of the kept run stays above the least that is promised, since it is measured again in the end.
const RESERVE = 0.04;

// The least radius of the black hole, px, and by how much it shrinks at a time.
const SMALLEST = 12;
const SHRINK = 2;

/**
 * Makes one attempt at a level that fulfils a spec. A run comes first and the level is built around it:
 *
 * 1. Lay out asteroids at random, and find a run through them that ends where the black hole is then placed ({@link
 *    findRoute}). A theme lays out its own asteroids and fields, and says which runs suit it.
 * 2. Add novae outside a tube around the run, which holds the run's slightly mistimed variations as well; a theme composes them
 *    ({@link compose}).
 * 3. Find other runs; the best of all says how hard the level is. While it is too easy, keep the run whose own grade is closest to
 *    what is wanted, and close what is easier ({@link harden}). Where nothing can be closed, the black hole shrinks. A theme
 *    says where novae may go, and the best run has to be of the theme.
 * 4. Remove idle objects, add minerals, measure the finished level and check everything that is claimed of it ({@link finish}).
 *
 * A level that fails any of the promises is discarded.
 */
export function* attemptLevel(random: Random, spec: GeneratorSpec, description: string): Attempt {
  const theme = spec.theme === null ? null : THEMES[spec.theme];
  const empty = theme === null ? layOut(random, spec) : arrange(random, spec, theme);
  if (empty === null) return 'noRoom';
  const route = findRoute(empty, spec, random, theme);
  yield ROUTE_EFFORT;
  if (route === null) return 'noRun';
  const surrounded = theme === null ? withNovae(route, spec, random) : yield* compose(route, spec, theme, random);
  if (typeof surrounded === 'string') return surrounded;
  const { stage } = surrounded;
  let { layout } = surrounded;

  let known: readonly Candidate[] = [route.run];
  let reason: Rejection = 'tooEasy';
  for (let round = 0; round < ROUNDS; round++) {
    const scene = sceneOf(layout);
    const still = known.filter(({ holds }) => verifyRun(scene, holds) !== null);
    const found = yield* findWays(scene, ANY, random.next(), EASIER_EFFORT);
    const all = sortByP40(scene, different([...still, ...found]));
    if (all.length === 0) return 'noRun';
    known = withOnTheme(all, WAYS, layout, stage);
    const [best] = known;
    const graded = withOnTheme(known, GRADED, layout, stage);
    const grades = graded.map((way) => gradeRun(scene, way, 1).value);
    yield GRADING * GRADED * best.tick;
    if (grades[0] > spec.grade[1]) return 'tooHard';
    const presses = scoutOnePress(scene, best);
    const isHardEnough = grades[0] >= spec.grade[0] && isOnTheme(stage, layout, best);
    if (isHardEnough && presses.count <= spec.onePress * presses.tried) {
      const generated = yield* finish(layout, spec, known, random, description, stage);
      if (typeof generated !== 'string') return generated;
      reason = generated;
      if (reason !== 'tooEasy') return reason;
    }
    const kept = keptOf(layout, spec, graded, grades, random, stage);
    if (kept === null) return 'unforgiving';
    const tube = [...tubeOf(scene, kept.holds, spec.certifiedTicks, random), ...stage.detourWays];
    const closed = closeShortcuts(layout, spec, tube, best, random, stage.slots);
    const harder = closed === layout ? harden(layout, spec, kept, known, random, stage) : closed;
    const next = harder === layout ? shrunk(layout) : harder;
    if (next === null) return reason;
    layout = stage.image === null ? next : withImages(new Site(spec, random, next, tube), stage.image);
  }
  return reason;
}

/** The start, asteroids and fields of a theme; null when they do not fit. */
function arrange(random: Random, spec: GeneratorSpec, theme: Theme): Layout | null {
  const site = new Site(spec, random);
  return theme.arrange(site) ? site.layout : null;
}

/** A level without a theme: novae around its route. */
function withNovae(route: Route, spec: GeneratorSpec, random: Random): { layout: Layout; stage: Stage } {
  const { run } = route;
  const layout = withoutUnused(route.layout, run.holds);
  const tube = tubeOf(sceneOf(layout), run.holds, spec.tube, random);
  return { layout: addNovae(layout, spec, tube, spec.novae, random), stage: PLAIN_STAGE };
}

/** The first runs, and the first that is of the theme if it comes later. */
function withOnTheme(ways: readonly Candidate[], most: number, layout: Layout, stage: Stage): readonly Candidate[] {
  const first = ways.slice(0, most);
  if (stage.theme === null || first.some((way) => isOnTheme(stage, layout, way))) return first;
  const other = ways.find((way) => isOnTheme(stage, layout, way));
  return other === undefined ? first : [...first, other];
}

/**
 * The run to keep open: of those that forgive enough and are of the theme, the one whose grade is closest to the lower half of the
 * wanted ones.
 */
function keptOf(
  layout: Layout,
  spec: GeneratorSpec,
  ways: readonly Candidate[],
  grades: readonly number[],
  random: Random,
  stage: Stage,
): Candidate | null {
  const scene = sceneOf(layout);
  const wanted = (spec.grade[0] + Math.min(spec.grade[1], spec.grade[0] + 2)) / 2;
  let kept: Candidate | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (const [i, grade] of grades.entries()) {
    const off = Math.abs(grade - wanted);
    if (off >= least || !isOnTheme(stage, layout, ways[i])) continue;
    const { p } = successProbability(scene, ways[i].holds, ANY, 40, { samples: SAMPLES, seed: 1 });
    if (p < spec.p40 + RESERVE || !forgives(scene, ways[i].holds, spec.certifiedTicks, random)) continue;
    kept = ways[i];
    least = off;
  }
  return kept;
}

/** The layout with a smaller black hole; null when it is small already. */
function shrunk(layout: Layout): Layout | null {
  const radius = layout.blackHole.radius - SHRINK;
  return radius < SMALLEST ? null : { ...layout, blackHole: { ...layout.blackHole, radius } };
}

/** Runs without those that are the same. */
function different(runs: readonly Candidate[]): Candidate[] {
  return [...new Map(runs.map((run) => [run.holds.join(' '), run])).values()];
}
