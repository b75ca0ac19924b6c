import { joinHolds } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Moment } from '../../search/explore/index.ts';
import { cutHolds } from '../../verified-run.ts';

/** The part of holds before a tick. */
export const upTo = (holds: readonly Hold[], tick: number): Hold[] => (tick === 0 ? [] : cutHolds(joinHolds(holds), tick - 1));

/** Whether a run passes through the state that other holds lead to. */
export const leadsThrough = (run: readonly Hold[], holds: readonly Hold[], tick: number): boolean =>
  commonTicks(run, holds, tick) >= tick;

/** For how many ticks two sorted and disjoint lists of holds say the same, at most `tick`. */
export function commonTicks(a: readonly Hold[], b: readonly Hold[], tick: number): number {
  const [edges, others] = [a.flat(), b.flat()];
  for (let i = 0; i < edges.length || i < others.length; i++) {
    if (edges[i] !== others[i]) {
      return Math.min(tick, edges[i] ?? Number.POSITIVE_INFINITY, others[i] ?? Number.POSITIVE_INFINITY);
    }
  }
  return tick;
}

/** Holds that lead to a state and then go on as a run did after another tick, some ticks earlier or later. */
export function continued({ holds, tick }: Moment, onward: readonly Hold[], from: number, shift: number): Hold[] {
  const later = onward
    .filter(([, release]) => release > from)
    .map(([press, release]): Hold => {
      const at = Math.max(0, press - from + (press > from ? shift : 0));
      return [tick + at, tick + Math.max(at + 1, release - from + shift)];
    });
  return joinHolds([...holds, ...later]);
}
