import type { Motion } from './motion.ts';
import { RECORDS, SLOTS } from './state.ts';

const { BASE, TARGET, MOVES, BASE_X, BASE_Y } = SLOTS;
const { ROCK } = RECORDS;

/** Places the asteroids where the level has them. */
export function layOutRocks(m: Motion): void {
  for (let i = 0; i < m.scene.targets.count; i++) {
    m.s[m.rocks + ROCK * i] = m.targetX[i];
    m.s[m.rocks + ROCK * i + 1] = m.targetY[i];
  }
}

/** Adds an asteroid that the gun holds to those that may have moved. */
export function stir({ stirred }: Motion, i: number): void {
  if (stirred.includes(i)) return;
  stirred.push(i);
  stirred.sort((a, b) => a - b);
}

/** Finds from the state, after it was replaced, which asteroids may have moved. */
export function readRocks(m: Motion): void {
  const { s, stirred, rocks, targetX, targetY } = m;
  stirred.length = 0;
  if (s[MOVES] !== 1) return;
  for (let i = 0; i < targetX.length; i++) {
    const o = rocks + ROCK * i;
    const isAtHome = s[o] === targetX[i] && s[o + 1] === targetY[i] && s[o + 2] === 0 && s[o + 3] === 0;
    if (!isAtHome || i === s[BASE] || i === s[TARGET]) stirred.push(i);
  }
}

/**
 * Indices, ascending, of at least all targets that reach nearer than `reach` px to (x, y), px from the origin, wherever recoil
 * has moved them.
 */
export function targetsAround(m: Motion, x: number, y: number, reach: number): readonly number[] {
  const { scene, stirred } = m;
  const { spatial, count } = scene.targets;
  if (spatial === null) return Array.from({ length: count }, (_, i) => i);
  const found = spatial.around(x + m.originX, y + m.originY, reach);
  if (!m.recoil) return found;
  m.budget.look((found.length + stirred.length) >> 1);
  const all: number[] = [];
  let k = 0;
  // both lists ascend
  for (const i of Int32Array.from(found).sort()) {
    while (k < stirred.length && stirred[k] < i) all.push(stirred[k++]);
    if (stirred[k] !== i) all.push(i);
  }
  while (k < stirred.length) all.push(stirred[k++]);
  return all;
}

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
