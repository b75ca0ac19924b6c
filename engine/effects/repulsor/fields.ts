import { type Motion, SLOTS } from '../../motion/index.ts';

const { FIELD, BASE_X, BASE_Y, RIM_TIME, CHATTER } = SLOTS;

/** Two crossings of rims nearer than this come in quick succession, s. */
const QUICK = 1 / 4000;

/** A chatter at most so many crossings ahead is kept in mind. */
const MOST = 15;

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

/** She is somewhere else: she may have left fields, and be in others. */
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

/** The first repulsor that contains her; -1 where there is none. */
export function actingField(m: Motion): number {
  for (let i = 0; i < m.scene.repulsors.count; i++) if (m.s[m.inside + i] === 1) return i;
  return -1;
}

/** Keeps count of crossings of rims in quick succession: where several rims meet she may be thrown to and fro without end. */
export function countCrossing(m: Motion, time: number): void {
  const { s } = m;
  s[CHATTER] = time - s[RIM_TIME] < QUICK ? Math.min(MOST, s[CHATTER] + 1) : Math.max(0, s[CHATTER] - 1);
  s[RIM_TIME] = time;
}
