import type { Place } from '../../../../schema/basics/index.ts';

/** Directions in a full turn: every 3.75 degrees. */
export const TURN = 96;

// The cosine and sine of 3.75 degrees. Directions follow by multiplication, so they are the same on every machine.
const COS = 0.9978589232386035;
const SIN = 0.06540312923014306;

/** Unit vectors, clockwise on screen, from the positive x axis. */
export const DIRECTIONS: readonly Place[] = (() => {
  const all: Place[] = [{ x: 1, y: 0 }];
  for (let i = 1; i < TURN; i++) {
    const { x, y } = all[i - 1];
    all.push({ x: x * COS - y * SIN, y: x * SIN + y * COS });
  }
  return all;
})();

/** The index of the direction that is closest to a vector. */
export function directionOf(dx: number, dy: number): number {
  let best = 0;
  let most = Number.NEGATIVE_INFINITY;
  for (let i = 0; i < TURN; i++) {
    const along = DIRECTIONS[i].x * dx + DIRECTIONS[i].y * dy;
    if (along > most) [best, most] = [i, along];
  }
  return best;
}

/** The signed number of directions from one to another the short way round, from -TURN / 2 to TURN / 2. */
export function stepsBetween(from: number, to: number): number {
  const steps = (to - from + TURN) % TURN;
  return steps > TURN / 2 ? steps - TURN : steps;
}
