import type { Hold } from '../schema/basics/index.ts';
import type { Simulation } from './simulation.ts';

/**
 * Sorts holds by time and joins those that overlap or touch. The button is one bit, so holding it twice is holding it once.
 * Empty holds are dropped.
 *
 * @param holds - half-open intervals [press, release) in ticks of 1/60 s, in any order
 * @returns new holds, sorted and disjoint
 */
export function joinHolds(holds: readonly Hold[]): Hold[] {
  const sorted = holds.filter(([press, release]) => release > press).sort((a, b) => a[0] - b[0]);
  const joined: [number, number][] = [];
  for (const [press, release] of sorted) {
    const last = joined[joined.length - 1];
    if (last !== undefined && press <= last[1]) last[1] = Math.max(last[1], release);
    else joined.push([press, release]);
  }
  return joined;
}

/**
 * Plays holds on a simulation, from its current tick until the run ends or `maxTicks` is reached.
 *
 * @param simulation - the simulation; it is advanced
 * @param holds - half-open intervals [press, release) in ticks from the start of the run, sorted and disjoint as {@link
 * joinHolds} gives them
 * @param maxTicks - the tick at which to stop, counted from the start of the run
 * @throws {@link WorkLimitReached} when the simulation's budget is used up
 */
export function playScript(simulation: Simulation, holds: readonly Hold[], maxTicks: number): void {
  for (const [press, release] of holds) {
    if (simulation.ending !== null || press >= maxTicks) break;
    if (press > simulation.tick) simulation.advance(press - simulation.tick, false);
    const until = Math.min(release, maxTicks);
    if (simulation.ending === null && until > simulation.tick) simulation.advance(until - simulation.tick, true);
  }
  if (simulation.ending === null && simulation.tick < maxTicks) simulation.advance(maxTicks - simulation.tick, false);
}
