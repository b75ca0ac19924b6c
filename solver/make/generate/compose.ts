import type { Disc, Hold, Place } from '../../../schema/basics/index.ts';
import type { Random } from '../../random.ts';
import { type Candidate, cutHolds, verifyRun } from '../../verified-run.ts';
import type { Rejection } from './generated.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { withoutUnused } from './harden.ts';
import { distance, type Layout } from './layout.ts';
import { hasRoom, MINERAL_RADIUS } from './novae-and-minerals.ts';
import type { Route } from './route.ts';
import { ALL, ANY, findWays, sceneOf } from './scouting.ts';
import {
  ASIDE,
  bestImage,
  flightOf,
  isOnTheme,
  Site,
  type Stage,
  type Theme,
  withImages,
  withoutSingles,
} from './themes/index.ts';
import { distanceToWays, forgives, tubeOf, type Way, wayOf } from './tube.ts';

// Ways of the detour and of its slightly mistimed variations that stay open.
const DETOUR_WAYS = 6;

/** A level composed around a route. */
interface Composed {
  readonly layout: Layout;
  readonly stage: Stage;
}

/**
 * Composes what a theme calls for around a route: minerals that lead elsewhere, novae, aliens, and counterparts by symmetry. Every
 * object leaves a tube around the route open, and the route is played again with all of them; aliens that break it are dropped.
 */
export function* compose(
  { layout: bare, run }: Route,
  spec: GeneratorSpec,
  theme: Theme,
  random: Random,
): Generator<number, Composed | Rejection> {
  let layout = bare;
  let detour: Candidate | null = null;
  if (spec.tempting) {
    const found = yield* findDetour(layout, spec, run, 1, random);
    if (found === null) return 'noDetour';
    layout = found.layout;
    detour = found.run;
  }
  layout = withoutUnused(layout, run.holds, detour?.holds);
  const scene = sceneOf(layout);
  const detourWays: readonly Way[] = detour === null ? [] : tubeOf(scene, detour.holds, 1, random).slice(0, DETOUR_WAYS);
  const site = new Site(spec, random, layout, [...tubeOf(scene, run.holds, spec.tube, random), ...detourWays]);
  theme.compose(site, flightOf(scene, run.holds));
  const image = bestImage(spec.symmetry ?? theme.symmetry, site);
  if (image !== null) site.layout = withImages(site, image);
  if (image !== null && spec.symmetry !== null) site.layout = withoutSingles(site.layout, image);

  const holds = (composed: Layout) => {
    const there = sceneOf(composed);
    if (detour !== null && verifyRun(there, detour.holds, ALL) === null) return false;
    return verifyRun(there, run.holds) !== null && forgives(there, run.holds, spec.certifiedTicks, random);
  };
  let composed = site.layout;
  while (!holds(composed)) {
    const { aliens } = composed.placed;
    if (aliens.length === 0) return 'unforgiving';
    composed = { ...composed, placed: { ...composed.placed, aliens: aliens.slice(1) } };
  }
  const stage: Stage = {
    theme,
    least: theme.least(spec),
    slots: site.slots,
    figures: composed.novae,
    kept: site.kept,
    image,
    detour,
    detourWays,
  };
  return isOnTheme(stage, composed, run) ? { layout: composed, stage } : 'offTheme';
}

/** A level with minerals that lead elsewhere than its route, and a run that collects all of them. */
interface Detour {
  readonly layout: Layout;
  readonly run: Candidate;
}

// Games that leave the route, and ticks that they are followed.
const STRAYS = 60;
const FOLLOWED = 200;

// Places that are tried, and the ticks to find a run that gets there.
const PLACES = 3;
const SEARCH_EFFORT = 250_000;

// Ticks to find other runs.
const TOUR_EFFORT = 400_000;

const MINERALS = 3;

// px between two minerals: each has to be collected on its own.
const APART = 60;

// px of the grid of minerals.
const GRID = 2;

/**
 * Places minerals where a wrong turn leads: off the route, so that the run that collects all of them is another one. Games leave
 * the route at random; a search looks for a run that passes where one of them has been, and the other minerals go onto that run,
 * as far from the route as possible. Before that, runs that need no mineral to lead elsewhere are tried, and the one that leads
 * farthest from the route is taken.
 * @param wanted how many minerals lie off the route, at least
 * @returns null when no run was found
 */
function* findDetour(
  layout: Layout,
  spec: GeneratorSpec,
  route: Candidate,
  wanted: number,
  random: Random,
): Generator<number, Detour | null> {
  const scene = sceneOf(layout);
  const own = wayOf(scene, route.holds);
  const places: Disc[] = [];
  for (let i = 0; i < STRAYS; i++) {
    const leave = 1 + random.below(route.tick);
    const press = leave + random.below(60);
    const holds: Hold[] = [...cutHolds(route.holds, leave - 1), [press, press + 10 + random.below(150)]];
    const way = wayOf(scene, holds, leave + FOLLOWED);
    const mineral = toMineral(way[Math.max(0, way.length - 1 - random.below(8))]);
    if (isAside([own], mineral) && hasRoom(layout, spec, mineral)) places.push(mineral);
  }
  yield STRAYS * route.tick;
  // Minerals on a way, the first one where it is given.
  const along = (holds: readonly Hold[], way: Way, lure?: Disc): Detour | null => {
    const minerals = mineralsOn(layout, spec, way, own, lure);
    if (minerals.length < MINERALS || minerals.filter((mineral) => isAside([own], mineral)).length < wanted) return null;
    const full = { ...layout, minerals };
    const run = verifyRun(sceneOf(full), holds, ALL);
    return run === null ? null : { layout: full, run };
  };
  // Another run that completes the level will do, if it takes longer: what is longer is seldom easier.
  let [farthest, most]: [Detour | null, number] = [null, 0];
  for (const tour of yield* findWays(scene, ANY, random.next(), TOUR_EFFORT, [route])) {
    const detour = tour.tick > route.tick ? along(tour.holds, wayOf(scene, tour.holds)) : null;
    const aside = detour === null ? 0 : distanceToWays([own], detour.layout.minerals[0]);
    if (aside > most) [farthest, most] = [detour, aside];
  }
  if (farthest !== null) return farthest;
  for (let n = 0; n < PLACES && places.length > 0; n++) {
    const [lure] = places.splice(random.below(places.length), 1);
    const single = sceneOf({ ...layout, minerals: [lure] });
    const [found] = yield* findWays(single, ALL, random.next(), SEARCH_EFFORT, [route]);
    if (found === undefined) continue;
    const detour = along(found.holds, wayOf(single, found.holds), lure);
    if (detour !== null) return detour;
  }
  return null;
}

const isAside = (ways: readonly Way[], mineral: Place): boolean => distanceToWays(ways, mineral) >= ASIDE;

const toMineral = ({ x, y }: Place): Disc => ({
  x: GRID * Math.round(x / GRID),
  y: GRID * Math.round(y / GRID),
  radius: MINERAL_RADIUS,
});

/** The mineral that a run was found for, and others on its path: the farthest from the route first. */
function mineralsOn(layout: Layout, spec: GeneratorSpec, way: Way, route: Way, first?: Disc): Disc[] {
  const minerals = first === undefined ? [] : [first];
  const candidates = way
    .map(toMineral)
    .filter((disc) => hasRoom(layout, spec, disc))
    .map((disc) => ({ disc, aside: distanceToWays([route], disc) }))
    .sort((a, b) => b.aside - a.aside);
  for (const { disc } of candidates) {
    if (minerals.length < MINERALS && minerals.every((other) => distance(other, disc) >= APART)) minerals.push(disc);
  }
  return minerals;
}
