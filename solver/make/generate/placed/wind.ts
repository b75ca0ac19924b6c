import { APART, distance, type PlacedKind } from './placed-kind.ts';

/**
 * The least strength of a wind, and the most on each axis, px/s². A wind stronger than the nearby gun would leave nothing to
 * steer.
 */
const BREEZE = 10;
const GUST = 24;

/** Winds may lie over other objects, but not over each other. */
export const wind = {
  kind: 'wind',
  list: 'winds',
  isUsual: false,
  isSolid: false,
  turn: 5,
  make({ between, inPlay, isClear, others }) {
    const made = { ...inPlay(), radius: between(0, 1) === 0 ? 64 : 96, ax: between(-GUST, GUST), ay: between(-GUST, GUST) };
    if (distance({ x: made.ax, y: made.ay }, { x: 0, y: 0 }) < BREEZE || !isClear(made)) return null;
    return others.every((other) => distance(other, made) >= other.radius + made.radius + APART) ? made : null;
  },
} as const satisfies PlacedKind;
