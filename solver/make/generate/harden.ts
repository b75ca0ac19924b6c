import { boxOf, compile, findWarnings, simulate } from '../../../engine/index.ts';
import { type Disc, type Hold, rulesOf } from '../../../schema/basics/index.ts';
import { successProbability } from '../../measure/robustness/index.ts';
import type { Random } from '../../random.ts';
import { type Candidate, verifyRun } from '../../verified-run.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { fits, type Layout, NOVA_MARGIN } from './layout.ts';
import { toLevel } from './level-file.ts';
import { blockWay } from './novae-and-minerals.ts';
import { ALL, ANY, luckyWays, sceneOf, scoutOnePress } from './scouting.ts';
import type { Stage } from './themes/index.ts';
import { distanceToWays, forgives, tubeOf, type Way, wayOf } from './tube.ts';

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

const RADIUS = 16;

// Ticks by which the edges of mistimed runs are shifted, at most, and px from their ways to a nova on each axis, at most.
const MISTIMED = 5;
const OFF = 24;

// Places that are tried for one nova.
const PLACES = 40;

const SAMPLES = 100;

// px beyond what her box needs, within which novae are tried beside the path.
const NEAR = 30;

// How far success must stay above the wanted value, because it is measured again, and more precisely, in the end.
const RESERVE = 0.06;

/**
 * Adds one nova beside a run's path: the one that reduces success under timing noise of 40 ms most, without going below the
 * wanted success or breaking the certificate.
 * @returns the layout, or null when there is no such place
 */
function narrowWay(
  layout: Layout,
  spec: GeneratorSpec,
  run: Candidate,
  way: Way,
  random: Random,
  { slots, detour }: Stage,
): Layout | null {
  const p40 = (grown: Layout) => successProbability(sceneOf(grown), run.holds, ANY, 40, { samples: SAMPLES, seed: 1 }).p;
  const now = p40(layout);
  const least = RADIUS + boxOf(rulesOf(layout)).halfDiagonal + 1;
  const isBeside = (nova: Disc): boolean => {
    const away = distanceToWays([way], nova) - nova.radius + RADIUS;
    return away >= least && away <= least + NEAR && fits(layout, spec, nova, undefined, NOVA_MARGIN);
  };
  const narrowed: { readonly layout: Layout; readonly p: number }[] = [];
  const weigh = (nova: Disc): void => {
    if (!isBeside(nova)) return;
    const grown = { ...layout, novae: [...layout.novae, nova] };
    const p = p40(grown);
    if (p < now - 0.01 && p >= spec.p40 + RESERVE) narrowed.push({ layout: grown, p });
  };
  const beside = slots.filter(isBeside);
  for (let i = 0; i < PLACES && beside.length > 0; i++) weigh(beside.splice(random.below(beside.length), 1)[0]);
  // otherwise where mistimed runs pass, since a nova elsewhere changes nothing
  if (narrowed.length === 0) {
    const mistimed = tubeOf(sceneOf(layout), run.holds, MISTIMED, random);
    for (let i = 0; i < PLACES; i++) {
      const passes = mistimed[random.below(mistimed.length)];
      const { x, y } = passes[random.below(passes.length)];
      const off = () => random.below(2 * OFF + 1) - OFF;
      weigh({ x: Math.round(x) + off(), y: Math.round(y) + off(), radius: RADIUS });
    }
  }
  narrowed.sort((a, b) => a.p - b.p);
  const isOpen = (grown: Layout) => {
    const scene = sceneOf(grown);
    if (detour !== null && verifyRun(scene, detour.holds, ALL) === null) return false;
    return forgives(scene, run.holds, spec.certifiedTicks, random);
  };
  return narrowed.find((grown) => isOpen(grown.layout))?.layout ?? null;
}
