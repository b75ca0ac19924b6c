import type { Hold } from '../schema/index.ts';
import type { Simulation } from './simulation.ts';

/**
 * The holds in time order with those that overlap or touch joined: the button is one bit, so what is held twice is held.
 * @param holds half-open [press, release) intervals in ticks
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
 * Plays a script from where the simulation stands until the run ends or `maxTicks` is reached.
 * @param holds sorted and disjoint, as `joinHolds` gives them
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
