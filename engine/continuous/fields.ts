import type { Motion } from './motion.ts';
import { SLOTS } from './state.ts';

const { FIELD } = SLOTS;

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
