import { TICK_RATE } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { isWhole, type LiveProof } from '../core/proof/index.ts';
import { type Scale, toX } from './scale.ts';

/** How far a run gets. */
export interface Reached {
  /** Ticks until its end, with a fraction; infinite if it was not simulated to its end. */
  readonly until: number;
  /** Whether the run ends without completing the level. */
  readonly isBroken: boolean;
}

export const reachedBy = (proof: LiveProof): Reached => {
  const isPlayed = isWhole(proof);
  return {
    until: isPlayed ? proof.run.time * TICK_RATE : Number.POSITIVE_INFINITY,
    isBroken: isPlayed && proof.run.outcome !== 'completed',
  };
};

/** Whether the run ends before the hold begins. */
export const isMissed = ([press]: Hold, { until }: Reached): boolean => press >= until;

/** Whether the run fails during the hold. */
export const isCut = (hold: Hold, { until, isBroken }: Reached): boolean =>
  isBroken && !isMissed(hold, { until, isBroken }) && hold[1] > until;

/** `3 holds, 1 not reached` */
export function holdsInWords(holds: readonly Hold[], reached: Reached): string {
  const missed = holds.filter((hold) => isMissed(hold, reached)).length;
  const all = `${holds.length} ${holds.length === 1 ? 'hold' : 'holds'}`;
  return missed === 0 ? all : `${all}, ${missed} not reached`;
}

/** The part of a hold that the pointer grabs. */
export interface Grip {
  readonly index: number;
  readonly part: 'press' | 'body' | 'release';
}

/**
 * px of screen: how wide an edge is to the pointer, and how much of that lies inside the bar at most. `timeline.css` repeats
 * these.
 */
const EDGE = { fine: { width: 14, inside: 6 }, coarse: { width: 44, inside: 22 } } as const;

/** At most this share of a bar belongs to each edge, so that its middle can move even a short bar. */
const SHARE = 1 / 3;

/** What a pointer at `x` grabs: the nearest edge within reach, else the bar under it; null: the empty lane. */
export function gripAt(holds: readonly Hold[], scale: Scale, x: number, pointer: keyof typeof EDGE): Grip | null {
  const { width, inside: most } = EDGE[pointer];
  let best: Grip | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (const [index, [press, release]] of holds.entries()) {
    const left = toX(scale, press);
    const right = toX(scale, release);
    const inside = Math.min(most, (right - left) * SHARE);
    // px into the bar, measured from either edge
    for (const [part, depth] of [
      ['press', x - left],
      ['release', right - x],
    ] as const) {
      const distance = Math.abs(depth);
      if (distance > (depth > 0 ? inside : width - inside) || distance >= least) continue;
      least = distance;
      best = { index, part };
    }
    if (best === null && x > left && x < right) best = { index, part: 'body' };
  }
  return best;
}
