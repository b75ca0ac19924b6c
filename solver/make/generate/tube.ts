import { joinHolds, maxTicksOf, type Scene, STATE_SIZE, simulate, TICK } from '../../../engine/index.ts';
import type { Hold, Place } from '../../../schema/basics/index.ts';
import type { Random } from '../../random.ts';
import { verifyRun } from '../../verified-run.ts';
import { distance } from './layout.ts';

/** Places of her centre along a path, one every few ticks. */
export type Way = readonly Place[];

// Ticks between two places of a path; she flies about 10 px in between.
const EVERY = 4;

const DETOURS = 24;

const LOOKS = 100;

/** The path of a run up to its end or the given tick. */
export function wayOf(scene: Scene, holds: readonly Hold[], ticks: number = maxTicksOf(scene.terms)): Way {
  const run = simulate(scene, holds, { maxTime: ticks * TICK });
  const state = new Float64Array(STATE_SIZE);
  const way: Place[] = [];
  for (let tick = 0; tick * TICK < run.time; tick += EVERY) {
    run.trajectory.at(tick * TICK, state);
    way.push({ x: state[0], y: state[1] });
  }
  return way;
}

/**
 * The paths of a run and of random variations of it, with every edge shifted by up to `ticks`, as far as they reach the black
 * hole.
 */
export function tubeOf(scene: Scene, holds: readonly Hold[], ticks: number, random: Random): Way[] {
  const ways = [wayOf(scene, holds)];
  for (let i = 0; i < DETOURS; i++) {
    const shifted = shiftEach(holds, () => random.below(2 * ticks + 1) - ticks);
    if (simulate(scene, shifted).outcome === 'completed') ways.push(wayOf(scene, shifted));
  }
  return ways;
}

/**
 * Whether a run survives random shifts of every edge by exactly `ticks` either way. This is a quick test before the exact
 * certificate, at the corners, where runs fail first.
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

/** Distance from a place to the nearest place of some paths, px. */
export function distanceToWays(ways: readonly Way[], place: Place): number {
  let least = Number.POSITIVE_INFINITY;
  for (const way of ways) for (const at of way) least = Math.min(least, distance(at, place));
  return least;
}
