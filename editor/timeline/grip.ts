import type { Hold } from '../../schema/index.ts';
import { type Scale, toX } from './scale.ts';

/** Part of a hold that is taken hold of. */
export interface Grip {
  readonly index: number;
  readonly part: 'press' | 'body' | 'release';
}

/** px of screen: how wide an edge is to the pointer, and how much of that lies inside the bar at most. `timeline.css` has the same. */
const EDGE = { fine: { width: 14, inside: 6 }, coarse: { width: 44, inside: 22 } } as const;

/** Never more of a bar than this belongs to one of its edges: its middle moves it, however short it is. */
const SHARE = 1 / 3;

/** What a pointer at `x` takes: the nearest edge that is near enough, else the bar it is on; null: the empty lane. */
export function gripAt(holds: readonly Hold[], scale: Scale, x: number, pointer: keyof typeof EDGE): Grip | null {
  const { width, inside: most } = EDGE[pointer];
  let best: Grip | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (const [index, [press, release]] of holds.entries()) {
    const left = toX(scale, press);
    const right = toX(scale, release);
    const inside = Math.min(most, (right - left) * SHARE);
    // px into the bar, seen from either edge
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
