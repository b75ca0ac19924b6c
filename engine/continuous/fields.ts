import type { Motion } from './motion.ts';
import { SLOTS } from './state.ts';

const { FIELD, RIM, RIM_TIME, RIM_COUNT, RIM_HOLD } = SLOTS;

/** Two crossings of a rim nearer than this may be sliding along it, s. */
const SLIDING = 1 / 480;

/** Marks the repulsors that contain her at the start. */
export function enterFields(m: Motion): void {
  const { s, scene } = m;
  const { repulsors } = scene;
  for (let i = 0; i < repulsors.count; i++) {
    const dx = repulsors.x[i] - m.originX;
    const dy = repulsors.y[i] - m.originY;
    s[m.inside + i] = dx * dx + dy * dy < repulsors.r[i] * repulsors.r[i] ? 1 : 0;
  }
  s[FIELD] = actingField(m);
}

/** The first repulsor that contains her; -1 where there is none. */
export function actingField(m: Motion): number {
  for (let i = 0; i < m.scene.repulsors.count; i++) if (m.s[m.inside + i] === 1) return i;
  return -1;
}

/**
 * Where the gun pulls into a field that pushes out she slides along its rim: in and out without end. Rims crossed again
 * and again in no time are left unwatched for a moment, which keeps her on the rim to about 1e-4 px.
 */
export function watchForSliding(m: Motion, field: number, time: number): void {
  const { s } = m;
  const again = s[RIM] === field && time - s[RIM_TIME] < SLIDING;
  s[RIM_COUNT] = again ? s[RIM_COUNT] + 1 : 0;
  s[RIM] = field;
  s[RIM_TIME] = time;
  s[RIM_HOLD] = s[RIM_COUNT] >= 16 ? time + SLIDING : 0;
}
