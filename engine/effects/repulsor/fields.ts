import { type Motion, SLOTS } from '../../motion/index.ts';
import { ENTERING, OUTSIDE, placeInCircle } from '../rims/index.ts';

const { FIELD } = SLOTS;

/** Flags the repulsors that contain her at the start. */
export function enterFields(m: Motion): void {
  const { s, scene, recorder } = m;
  const { repulsors } = scene;
  for (let i = 0; i < repulsors.count; i++) {
    const place = placeInCircle(m, repulsors, i);
    s[m.own.repulsor + i] = place === OUTSIDE ? 0 : 1;
    if (place === ENTERING) recorder?.event({ time: 0, type: 'enter', index: repulsors.index[i] });
  }
  s[FIELD] = actingField(m);
}

/** She was moved: she may have left fields and be in others. */
export function changeFields(m: Motion, time: number): void {
  const { s, scene } = m;
  const { repulsors } = scene;
  for (let i = 0; i < repulsors.count; i++) {
    const inside = placeInCircle(m, repulsors, i) === OUTSIDE ? 0 : 1;
    if (s[m.own.repulsor + i] === inside) continue;
    s[m.own.repulsor + i] = inside;
    m.recorder?.event({ time, type: inside === 1 ? 'enter' : 'leave', index: repulsors.index[i] });
  }
  s[FIELD] = actingField(m);
}

/** The first repulsor that contains her; -1 if there is none. */
export function actingField(m: Motion): number {
  for (let i = 0; i < m.scene.repulsors.count; i++) if (m.s[m.own.repulsor + i] === 1) return i;
  return -1;
}
