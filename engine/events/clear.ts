import { type Motion, SLOTS } from '../motion/index.ts';
import { refresh } from './neighbourhood.ts';

const { BASE_X, BASE_Y, TARGET, AWAKE_COUNT } = SLOTS;

/** Objects farther away than this are not examined, px. */
const FARTHEST = 150;

/** Whether nothing but the pull of her target can matter before she is `far` px away and asteroids have moved by `rocks` px. */
export function isClear(m: Motion, far: number, rocks: number): boolean {
  const { s, near, parts, ux, uy } = m;
  if (s[AWAKE_COUNT] > 0 || far + rocks > FARTHEST) return false;
  const px = s[BASE_X] + ux[0];
  const py = s[BASE_Y] + uy[0];
  const reach = far + rocks;
  if (m.recoil || !near.covers(px, py, reach, s[TARGET])) refresh(m, px, py, reach);
  const gone = Math.sqrt((px - near.x) * (px - near.x) + (py - near.y) * (py - near.y)) + reach;
  for (let i = 0; i < near.count; i++) {
    const { isOver } = parts.byKind[near.kind[i]];
    if (isOver?.(m, near.index[i])) continue;
    if (near.slack[i] <= gone) return false;
  }
  return true;
}
