import type { Random } from '../random.ts';
import { type Candidate, verifyRun } from '../verified-run.ts';
import { findDetour } from './detour.ts';
import type { Rejection } from './generated.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { withoutUnused } from './harden.ts';
import type { Layout } from './layout.ts';
import type { Route } from './route.ts';
import { ALL, sceneOf } from './scouting.ts';
import { isOnTheme, type Stage } from './stage.ts';
import { bestImage, flightOf, Site, type Theme, withImages, withoutSingles } from './themes/index.ts';
import { forgives, tubeOf, type Way } from './tube.ts';

// Ways of the detour and of its slightly mistimed variations that stay open.
const DETOUR_WAYS = 6;

/** A level composed around a route. */
export interface Composed {
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
