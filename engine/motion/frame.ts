import { keepLine } from './line.ts';
import type { Motion } from './motion.ts';
import { SLOTS } from './state.ts';

const { BASE, BASE_X, BASE_Y } = SLOTS;

/** Moves the origin of the frame to a point, or to a target and its velocity. */
export function rebase(m: Motion, base: number, x: number, y: number, vx: number, vy: number): void {
  const { s, ux, uy, px, py } = m;
  if (s[BASE] === base && s[BASE_X] === x && s[BASE_Y] === y) return;
  keepLine(m, base, x, y);
  ux[0] += s[BASE_X] - x;
  uy[0] += s[BASE_Y] - y;
  ux[1] += px[1] - vx;
  uy[1] += py[1] - vy;
  s[BASE] = base;
  s[BASE_X] = x;
  s[BASE_Y] = y;
  px[1] = vx;
  py[1] = vy;
}
