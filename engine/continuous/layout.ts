import { ALIEN_SIGHT, SPEED_LIMIT } from '../constants.ts';
import { enterFields } from './fields.ts';
import type { Motion } from './motion.ts';
import { nearest } from './nearest.ts';
import { holdLimits } from './piece.ts';
import { RECORDS, SLOTS } from './state.ts';

const { TARGET, FIELD, COVER, BASE, COS, LIMIT_X, LIMIT_Y, RIM } = SLOTS;
const { CHASER, ROCK } = RECORDS;

/** Puts everything where the level has it. */
export function layOut(m: Motion): void {
  const { s, scene } = m;
  const { level, aliens } = scene;
  s[TARGET] = -1;
  s[FIELD] = -1;
  s[COVER] = -1;
  s[BASE] = -1;
  s[RIM] = -1;
  s[COS] = 1;
  m.ux[1] = level.astronaut.vx;
  m.uy[1] = level.astronaut.vy;
  if (m.recoils) {
    for (let i = 0; i < scene.targets.count; i++) {
      s[m.rocks + ROCK * i] = m.targetX[i];
      s[m.rocks + ROCK * i + 1] = m.targetY[i];
    }
  }
  for (let i = 0; i < aliens.count; i++) {
    const o = m.chasers + CHASER * i;
    s[o] = aliens.x[i] - m.originX;
    s[o + 1] = aliens.y[i] - m.originY;
    if (s[o] * s[o] + s[o + 1] * s[o + 1] >= ALIEN_SIGHT * ALIEN_SIGHT) continue;
    m.crowd.wake(i);
  }
  s[COVER] = nearest(m);
  enterFields(m);
  const limit = (v: number) => (v >= SPEED_LIMIT ? 1 : v <= -SPEED_LIMIT ? -1 : 0);
  s[LIMIT_X] = limit(m.ux[1]);
  s[LIMIT_Y] = limit(m.uy[1]);
  holdLimits(m);
}
