import { ALIEN_PULL } from '../../constants.ts';
import { overlapBetween } from '../bracket.ts';
import { offer } from '../first-event.ts';
import { FLOOR, lookNext, PATIENCE, safeStep, safeStretch, smallestStride } from '../march.ts';
import type { Motion } from '../motion.ts';
import { alienTravel } from '../neighbourhood.ts';
import { alienPlaceAt } from '../places.ts';
import { addProduct, shift, valueAt } from '../polynomial.ts';
import { ALERTNESS, EVENTS, RECORDS, SLOTS } from '../state.ts';
import { LONGEST_SERIES } from '../taylor.ts';

const { LENGTH_H } = SLOTS;
const { PAIR } = EVENTS;
const { CHASER } = RECORDS;
const { ASLEEP, AWAKE, GONE } = ALERTNESS;

/** The cubic of a Runge-Kutta step may bend by this much more than the strongest pull, see {@link dragRungeKutta}. */
const CUBIC_BENDS = 5 / 3;

const dx = new Float64Array(LONGEST_SERIES);
const dy = new Float64Array(LONGEST_SERIES);
const guard = new Float64Array(2 * LONGEST_SERIES);

/**
 * Two aliens that come to touch before the piece ends explode: a march of safe steps, after PATIENCE looks by the
 * coefficients of the guard, which is a polynomial. An overlap below FLOOR may be overlooked.
 * @param from s from its start
 */
export function considerPair(m: Motion, i: number, j: number, from: number): void {
  const { s, scene, work } = m;
  const a = m.chasers + CHASER * i;
  const b = m.chasers + CHASER * j;
  if (s[b + 4] === GONE) return;
  const reach = scene.aliens.r[i] + scene.aliens.r[j];
  const d = Math.sqrt((s[a] - s[b]) * (s[a] - s[b]) + (s[a + 1] - s[b + 1]) * (s[a + 1] - s[b + 1]));
  const h = s[LENGTH_H];
  if (d - alienTravel(m, i, h) - alienTravel(m, j, h) > reach + 1e-6) return;
  work.guards++;
  const e = m.e;
  const still = s[a + 4] === ASLEEP && s[b + 4] === ASLEEP;
  const horizon = Math.min(m.horizon, h);
  const pull = m.integrator.degree === 3 ? CUBIC_BENDS * ALIEN_PULL : ALIEN_PULL;
  const small = smallestStride(h);
  const floor = 2 * reach * FLOOR;
  let t = from;
  let before = t;
  for (let n = 0; ; n++) {
    m.budget.look(1);
    alienPlaceAt(m, i, t, 0);
    alienPlaceAt(m, j, t, 4);
    const x = e[0] - e[4];
    const y = e[1] - e[5];
    const vx = e[2] - e[6];
    const vy = e[3] - e[7];
    const g = x * x + y * y - reach * reach;
    if (g < 0) {
      offer(m, t === from ? t : touchBetween(m, i, j, reach, before, t), PAIR, i, j);
      return;
    }
    if (still) return;
    // (d^2)'' = 2 v^2 + 2 d a >= -2 |d| |a| while d stays below `far`
    const slope = 2 * (x * vx + y * vy);
    const far = Math.sqrt(x * x + y * y) + (Math.sqrt(vx * vx + vy * vy) + 2 * pull * h) * h;
    let step = safeStep(g + floor, slope, 4 * far * pull);
    if (n >= PATIENCE && t + step < horizon) {
      work.guards++;
      step = Math.max(step, safeStretch(guard, pairSeries(m, i, j, reach, t), g + floor, slope, 0, horizon - t));
    }
    if (!(t + step < horizon)) return;
    before = t;
    t = lookNext(t, step, small, horizon);
  }
}

/** When they begin to overlap, by the polynomial about `before`: close to a touch there it has more digits than distances have. */
function touchBetween(m: Motion, i: number, j: number, reach: number, before: number, behind: number): number {
  m.work.roots++;
  const degree = pairSeries(m, i, j, reach, before);
  return overlapBetween(before, behind, (t) => valueAt(guard, degree, t - before));
}

/** Into `guard` the coefficients of d^2 - reach^2 about `t`; returns their degree. */
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
