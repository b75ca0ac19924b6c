import { type Motion, SLOTS } from '../../motion/index.ts';

const { FIELD, BASE_X, BASE_Y } = SLOTS;

/** Flags the repulsors that contain her at the start. */
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

/** She was moved: she may have left fields and be in others. */
export function changeFields(m: Motion, time: number): void {
  const { s, scene, ux, uy } = m;
  const { repulsors } = scene;
  for (let i = 0; i < repulsors.count; i++) {
    const dx = repulsors.x[i] - m.originX - s[BASE_X] - ux[0];
    const dy = repulsors.y[i] - m.originY - s[BASE_Y] - uy[0];
    const inside = dx * dx + dy * dy < repulsors.r[i] * repulsors.r[i] ? 1 : 0;
    if (s[m.inside + i] === inside) continue;
    s[m.inside + i] = inside;
    m.recorder?.event({ time, type: inside === 1 ? 'enter' : 'leave', index: repulsors.index[i] });
  }
  s[FIELD] = actingField(m);
}

/** The first repulsor that contains her; -1 if there is none. */
export function actingField(m: Motion): number {
  for (let i = 0; i < m.scene.repulsors.count; i++) if (m.s[m.inside + i] === 1) return i;
  return -1;
}
