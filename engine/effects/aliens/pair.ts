import { chaserTravel, lookNext, overlapBetween, PATIENCE, safeStep, safeStretch, smallestStride } from '../../events/index.ts';
import {
  ALERTNESS,
  addProduct,
  chaserPlaceAt,
  LONGEST_SERIES,
  type Motion,
  RECORDS,
  SLOTS,
  shift,
  valueAt,
} from '../../motion/index.ts';
import { CUBIC_BENDS, DISTANCE_ROUNDING, FLOOR, SURPLUS } from '../../tolerances.ts';

const { LENGTH_H, NEXT, START } = SLOTS;
const { CHASER } = RECORDS;
const { ASLEEP, AWAKE, GONE } = ALERTNESS;

// working memory: the places of both
const one = new Float64Array(4);
const other = new Float64Array(4);
// working memory: series
const dx = new Float64Array(LONGEST_SERIES);
const dy = new Float64Array(LONGEST_SERIES);
const guard = new Float64Array(2 * LONGEST_SERIES);

/** Whether two aliens overlap where the piece begins. */
export function overlapping({ s, chasers, scene }: Motion, i: number, j: number): boolean {
  const a = chasers + CHASER * i;
  const b = chasers + CHASER * j;
  const reach = scene.aliens.r[i] + scene.aliens.r[j];
  return (s[a] - s[b]) * (s[a] - s[b]) + (s[a + 1] - s[b + 1]) * (s[a + 1] - s[b + 1]) < reach * reach;
}

/**
 * When two aliens begin to touch: safe steps, which after PATIENCE evaluations continue by the coefficients of the guard, a
 * polynomial. After the start an overlap below FLOOR is none.
 * @param from - where to begin, s after the start of the piece
 * @returns s after the start of the piece; -1 if not before the piece ends
 */
export function pairTime(m: Motion, i: number, j: number, from: number): number {
  const { s, scene, work } = m;
  const a = m.chasers + CHASER * i;
  const b = m.chasers + CHASER * j;
  if (s[b + 4] === GONE) return -1;
  const reach = scene.aliens.r[i] + scene.aliens.r[j];
  const d = Math.sqrt((s[a] - s[b]) * (s[a] - s[b]) + (s[a + 1] - s[b + 1]) * (s[a + 1] - s[b + 1]));
  const h = s[LENGTH_H];
  if (d - chaserTravel(m, i, m.rules.alienPull, h) - chaserTravel(m, j, m.rules.alienPull, h) > reach + SURPLUS) return -1;
  work.guards++;
  const still = s[a + 4] === ASLEEP && s[b + 4] === ASLEEP;
  const horizon = Math.min(m.horizon, h);
  const pull = m.integrator.degree === 3 ? CUBIC_BENDS * m.rules.alienPull : m.rules.alienPull;
  const small = smallestStride(h);
  const floor = 2 * reach * Math.max(FLOOR, DISTANCE_ROUNDING * reach);
  let limit = horizon;
  let t = from;
  let before = t;
  for (let n = 0; ; n++) {
    m.budget.look(1);
    chaserPlaceAt(m, i, t, one);
    chaserPlaceAt(m, j, t, other);
    const x = one[0] - other[0];
    const y = one[1] - other[1];
    const vx = one[2] - other[2];
    const vy = one[3] - other[3];
    const g = x * x + y * y - reach * reach;
    if (still) return g < 0 ? t : -1;
    // (d^2)'' = 2 v^2 + 2 d a, of which the second is at most 2 |d| |a| while d stays below `far`
    const slope = 2 * (x * vx + y * vy);
    const speed = Math.sqrt(vx * vx + vy * vy) + 2 * pull * h;
    const far = Math.sqrt(x * x + y * y) + speed * h;
    const isBelow = g < 0;
    const isSteep = slope * slope > 2 * (2 * speed * speed + 4 * far * pull) * floor;
    if (isBelow && (s[START] + t === 0 || (isSteep && slope < 0) || g < -floor)) {
      if (t === from) return t;
      const time = touchBetween(m, i, j, reach, before, t);
      return limit === horizon || Math.abs((time - s[NEXT]) * slope) > floor ? time : s[NEXT];
    }
    if (t > horizon && !isBelow) return -1;
    const above = Math.max(0, g);
    let step = safeStep(above + floor, slope, 4 * far * pull);
    if (n >= PATIENCE && t + step < limit) {
      work.guards++;
      step = Math.max(step, safeStretch(guard, pairSeries(m, i, j, reach, t), above + floor, slope, 0, limit - t));
    }
    if (!(t + step < limit)) {
      if (limit === h || !(isBelow || t + safeStep(above, slope, 4 * far * pull) < limit)) return -1;
      // by the floor the step may reach beyond an event at the same instant as one that was found before
      limit = h;
      continue;
    }
    if (isSteep ? g >= 0 : g >= floor) before = t;
    t = lookNext(t, step, small, limit);
  }
}

/** When they begin to overlap, by the polynomial about `before`: close to a touch it has more digits than distances have. */
function touchBetween(m: Motion, i: number, j: number, reach: number, before: number, behind: number): number {
  m.work.roots++;
  const degree = pairSeries(m, i, j, reach, before);
  return overlapBetween(before, behind, (t) => valueAt(guard, degree, t - before));
}

/** Writes the coefficients of d² - reach² about `t` to `guard`; returns their degree. */
function pairSeries(m: Motion, i: number, j: number, reach: number, t: number): number {
  const { degree } = m.integrator;
  dx.fill(0);
  dy.fill(0);
  addAlien(m, i, 1);
  addAlien(m, j, -1);
  shift(dx, degree, t);
  shift(dy, degree, t);
  guard.fill(0);
  addProduct(dx, degree, dx, degree, 1, guard);
  addProduct(dy, degree, dy, degree, 1, guard);
  guard[0] = dx[0] * dx[0] + dy[0] * dy[0] - reach * reach;
  return 2 * degree;
}

function addAlien(m: Motion, i: number, sign: number): void {
  const { s } = m;
  const o = m.chasers + CHASER * i;
  if (s[o + 4] !== AWAKE) {
    dx[0] += sign * s[o];
    dy[0] += sign * s[o + 1];
    return;
  }
  for (let k = 0; k <= m.integrator.degree; k++) {
    dx[k] += sign * m.chaserX[i][k];
    dy[k] += sign * m.chaserY[i][k];
  }
}
