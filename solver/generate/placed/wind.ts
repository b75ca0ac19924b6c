import { APART, distance, type PlacedKind } from './placed-kind.ts';

/** px/s2: the least that one blows, and the most on each axis. What is stronger than the gun close by leaves nothing to steer. */
const BREEZE = 10;
const GUST = 24;

/** Discs that lie over other things, but not over each other. */
export const wind = {
  kind: 'wind',
  list: 'winds',
  isSolid: false,
  make({ between, inPlay, isClear, others }) {
    const made = { ...inPlay(), radius: between(0, 1) === 0 ? 64 : 96, ax: between(-GUST, GUST), ay: between(-GUST, GUST) };
    if (distance({ x: made.ax, y: made.ay }, { x: 0, y: 0 }) < BREEZE || !isClear(made)) return null;
    return others.every((other) => distance(other, made) >= other.radius + made.radius + APART) ? made : null;
  },
} as const satisfies PlacedKind;
