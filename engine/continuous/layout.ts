import type { Effect } from '../effects/index.ts';
import { type Motion, SLOTS } from '../motion/index.ts';

const { TARGET, FIELD, COVER, BASE, COS, RIM } = SLOTS;

/** Places everything where the level has it. */
export function layOut(m: Motion, effects: readonly Effect[]): void {
  const { s } = m;
  const { astronaut } = m.scene.level;
  const { speedLimit } = m.rules;
  s[TARGET] = -1;
  s[FIELD] = -1;
  s[COVER] = -1;
  s[BASE] = -1;
  s[RIM] = -1;
  s[COS] = 1;
  // first, since her direction decides on which side of a rim she starts
  m.ux[1] = Math.min(speedLimit, Math.max(-speedLimit, astronaut.vx));
  m.uy[1] = Math.min(speedLimit, Math.max(-speedLimit, astronaut.vy));
  for (const effect of effects) effect.layOut?.(m);
}
