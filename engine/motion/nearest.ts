import type { Motion } from './motion.ts';
import { targetsAround } from './rocks.ts';
import { RECORDS, SLOTS } from './state.ts';

const { BASE_X, BASE_Y } = SLOTS;
const { ROCK } = RECORDS;

/** Squared distance of a target at the start of the piece, computed in the frame's own coordinates to keep their digits. */
export function distanceSquared(m: Motion, i: number): number {
  const { s } = m;
  const rx = m.recoil ? s[m.rocks + ROCK * i] : m.targetX[i];
  const ry = m.recoil ? s[m.rocks + ROCK * i + 1] : m.targetY[i];
  const dx = rx - s[BASE_X] - m.ux[0];
  const dy = ry - s[BASE_Y] - m.uy[0];
  return dx * dx + dy * dy;
}

/** The nearest target; the first of several equally near ones; -1 if there is none. */
export function nearest(m: Motion): number {
  const { s, scene, ux, uy, budget } = m;
  const { spatial, count } = scene.targets;
  let best = Number.POSITIVE_INFINITY;
  let nearest = -1;
  if (spatial !== null) {
    // the index finds one of the nearest; our own coordinates decide which of them comes first
    const x = s[BASE_X] + ux[0];
    const y = s[BASE_Y] + uy[0];
    const known = spatial.nearestCentre(m.originX + s[BASE_X] + ux[0], m.originY + s[BASE_Y] + uy[0]);
    const reach = Math.sqrt(distanceSquared(m, known)) * (1 + 1e-9) + 1e-6;
    const found = targetsAround(m, x, y, reach);
    budget.look(found.length >> 2);
    for (const i of found) {
      const d = distanceSquared(m, i);
      if (d > best || (d === best && i > nearest)) continue;
      best = d;
      nearest = i;
    }
    return nearest;
  }
  for (let i = 0; i < count; i++) {
    const d = distanceSquared(m, i);
    if (d < best) {
      best = d;
      nearest = i;
    }
  }
  return nearest;
}
