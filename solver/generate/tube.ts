import { joinHolds, type Scene, STATE_SIZE, simulate, TICK } from '../../engine/index.ts';
import type { Hold, Place } from '../../schema/index.ts';
import type { Random } from '../random.ts';
import { DEFAULT_MAX_TICKS, verifyRun } from '../verified-run.ts';
import { distance } from './layout.ts';

/** Places of her centre along a way, one for every few ticks. */
export type Way = readonly Place[];

// ticks between two places of a way: she flies some 10 px in between
const EVERY = 4;

const DETOURS = 24;

const LOOKS = 100;

/** Where a run leads, up to its end or for so many ticks. */
export function wayOf(scene: Scene, holds: readonly Hold[], ticks: number = DEFAULT_MAX_TICKS): Way {
  const run = simulate(scene, holds, { maxTime: ticks * TICK });
  const state = new Float64Array(STATE_SIZE);
  const way: Place[] = [];
  for (let tick = 0; tick * TICK < run.time; tick += EVERY) {
    run.trajectory.at(tick * TICK, state);
    way.push({ x: state[0], y: state[1] });
  }
  return way;
}

/** The ways of a run and of the same run with every edge off by up to so many ticks, as far as those reach the black hole. */
export function tubeOf(scene: Scene, holds: readonly Hold[], ticks: number, random: Random): Way[] {
  const ways = [wayOf(scene, holds)];
  for (let i = 0; i < DETOURS; i++) {
    const shifted = shiftEach(holds, () => random.below(2 * ticks + 1) - ticks);
    if (simulate(scene, shifted).outcome === 'completed') ways.push(wayOf(scene, shifted));
  }
  return ways;
}

/**
 * Whether a run stands random shifts of every edge by so many ticks to one side or the other: a quick look before the exact certificate,
 * at the corners, where it breaks first.
 */
export function forgives(scene: Scene, holds: readonly Hold[], ticks: number, random: Random): boolean {
  for (let i = 0; i < LOOKS; i++) {
    const corner = shiftEach(holds, () => (random.below(2) === 0 ? ticks : -ticks));
    if (verifyRun(scene, corner) === null) return false;
  }
  return true;
}

const shiftEach = (holds: readonly Hold[], off: () => number): Hold[] =>
  joinHolds(holds.map(([press, release]) => [Math.max(0, press + off()), Math.max(0, release + off())] as const));

/** Distance from a place to the nearest of some ways, px; within half a step of a way. */
export function distanceToWays(ways: readonly Way[], place: Place): number {
  let least = Number.POSITIVE_INFINITY;
  for (const way of ways) for (const at of way) least = Math.min(least, distance(at, place));
  return least;
}
