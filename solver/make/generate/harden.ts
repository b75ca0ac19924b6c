import { compile, findWarnings, simulate } from '../../../engine/index.ts';
import type { Disc, Hold } from '../../../schema/basics/index.ts';
import type { Random } from '../../random.ts';
import { type Candidate, verifyRun } from '../../verified-run.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import type { Layout } from './layout.ts';
import { toLevel } from './level-file.ts';
import { narrowWay } from './narrow.ts';
import { blockWay } from './novae.ts';
import { ALL, luckyWays, sceneOf, scoutOnePress } from './scouting.ts';
import type { Stage } from './stage.ts';
import { tubeOf, type Way, wayOf } from './tube.ts';

// Paths of random play that are closed per round.
const LUCKY = 3;

// Novae that are added per round to narrow a path.
const NARROWINGS = 2;

/**
 * Makes a level harder: closes the paths that are easier than the intended one, and narrows that one to the least that has to
 * stay open. Returns the same layout when nothing can be done.
 */
export function harden(
  layout: Layout,
  spec: GeneratorSpec,
  intended: Candidate,
  ways: readonly Candidate[],
  random: Random,
  stage: Stage,
): Layout {
  const scene = sceneOf(layout);
  const open = [...tubeOf(scene, intended.holds, spec.certifiedTicks, random), ...stage.detourWays];
  const easier = ways.slice(0, Math.max(0, ways.indexOf(intended))).map(({ holds }) => wayOf(scene, holds));
  let harder = layout;
  for (const way of [...easier, ...luckyWays(scene, LUCKY, random)]) {
    harder = blockWay(harder, spec, open, way, random, stage.slots) ?? harder;
  }
  // Narrowing the intended path helps only where it is the easiest one.
  if (easier.length > 0 && harder !== layout) return harder;
  for (let i = 0; i < NARROWINGS; i++) harder = narrowWay(harder, spec, intended, open[0], random, stage) ?? harder;
  return harder;
}

/** Removes the cold asteroids that neither a run nor the detour targets or needs to stay in range. */
export function withoutUnused(layout: Layout, holds: readonly Hold[], detour: readonly Hold[] | null = null): Layout {
  const level = toLevel(layout);
  const unused = new Set(
    findWarnings(
      level,
      [holds, ...(detour === null ? [] : [detour])].map((one) => simulate(compile(level, 'arcade'), one)),
    )
      .filter(({ code }) => code === 'unused-asteroid')
      .map(({ pointer }) => Number(pointer.split('/')[2])),
  );
  const lean = { ...layout, asteroids: layout.asteroids.filter((_, i) => !unused.has(i)) };
  if (detour !== null && verifyRun(sceneOf(lean), detour, ALL) === null) return layout;
  return verifyRun(sceneOf(lean), holds) === null ? layout : lean;
}

/** Puts novae on the paths of single presses while too many of them win and there is room. */
export function closeShortcuts(
  layout: Layout,
  spec: GeneratorSpec,
  free: readonly Way[],
  run: Candidate,
  random: Random,
  slots: readonly Disc[],
): Layout {
  let closed = layout;
  for (let i = 0; i < 3; i++) {
    const scene = sceneOf(closed);
    const { count, tried, example } = scoutOnePress(scene, run);
    if (example === null || count <= spec.onePress * tried) break;
    const next = blockWay(closed, spec, free, wayOf(scene, example), random, slots);
    if (next === null) break;
    closed = next;
  }
  return closed;
}
