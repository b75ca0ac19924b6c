import type { IndexedCircles } from '../indexed-circles.ts';
import type { Motion } from './motion.ts';
import type { Vicinity } from './neighbour-list.ts';
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

/** Of at most this many, all are examined. */
const FEW = 8;

/**
 * Indices of at least all circles that reach nearer than `reach` px to (x, y), px from the origin. They are searched for only
 * where `vicinity` does not know them.
 * @param first - circles before this index are as good as far away
 */
export function circlesAround(
  m: Motion,
  vicinity: Vicinity,
  circles: IndexedCircles,
  x: number,
  y: number,
  reach: number,
  first: number,
): ArrayLike<number> {
  const inLevelX = x + m.originX;
  const inLevelY = y + m.originY;
  if (vicinity.covers(inLevelX, inLevelY, reach)) return vicinity.found;
  return search(m, vicinity, circles, inLevelX, inLevelY, reach, first);
}

/** Apart, so that what is known is read without the memory that these functions take. */
function search(
  m: Motion,
  vicinity: Vicinity,
  circles: IndexedCircles,
  x: number,
  y: number,
  reach: number,
  first: number,
): ArrayLike<number> {
  const { spatial, count } = circles;
  const edge = (i: number): number => {
    const dx = circles.x[i] - x;
    const dy = circles.y[i] - y;
    return i < first ? Number.POSITIVE_INFINITY : Math.sqrt(dx * dx + dy * dy) - circles.r[i];
  };
  if (spatial === null) return vicinity.fill(x, y, reach, count, edge, null);
  const found = vicinity.fill(x, y, reach, count, edge, (far) => spatial.around(x, y, far));
  m.budget.look(found.length >> 2);
  return found;
}

// working memory: what `targetsAround` returns
const around: number[] = [];

/**
 * Indices, ascending, of at least all targets that reach nearer than `reach` px to (x, y), px from the origin, wherever recoil
 * has moved them. The next call overwrites them.
 */
export function targetsAround(m: Motion, x: number, y: number, reach: number): readonly number[] {
  const { stirred, targetsNear, budget } = m;
  const { targets } = m.scene;
  let found = circlesAround(m, targetsNear, targets, x, y, reach, 0);
  if (targets.spatial !== null) {
    found = Int32Array.from(found).sort();
    budget.look(stirred.length >> 1);
  }
  around.length = 0;
  let k = 0;
  // both lists ascend
  for (let n = 0; n < found.length; n++) {
    const i = found[n];
    while (stirred[k] < i) around.push(stirred[k++]);
    if (stirred[k] !== i) around.push(i);
  }
  while (k < stirred.length) around.push(stirred[k++]);
  return around;
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
  const { s, scene, ux, uy, targetsNear, stirred, originX, originY } = m;
  const { spatial, count } = scene.targets;
  if (count <= FEW) return nearestOf(m, null, count, -1);
  const x = s[BASE_X] + ux[0];
  const y = s[BASE_Y] + uy[0];
  const before = targetsNear.found;
  let known = nearestOf(m, before, before.length, -1);
  if (known < 0) known = spatial === null ? nearestOf(m, null, count, -1) : spatial.nearestCentre(originX + x, originY + y);
  // the index finds one of the nearest; our own coordinates decide which of them comes first
  const reach = Math.sqrt(distanceSquared(m, known)) * (1 + 1e-9) + 1e-6;
  const found = circlesAround(m, targetsNear, scene.targets, x, y, reach, 0);
  if (found !== before) known = nearestOf(m, found, found.length, known);
  return nearestOf(m, stirred, stirred.length, known);
}

/**
 * The nearest of some targets and one that is known.
 * @param some - indices; null for the first `count` targets
 * @param known - -1 if there is none
 */
function nearestOf(m: Motion, some: ArrayLike<number> | null, count: number, known: number): number {
  let nearest = known;
  let best = known < 0 ? Number.POSITIVE_INFINITY : distanceSquared(m, known);
  for (let k = 0; k < count; k++) {
    const i = some === null ? k : some[k];
    const d = distanceSquared(m, i);
    if (d > best || (d === best && i > nearest)) continue;
    best = d;
    nearest = i;
  }
  return nearest;
}
