import { TICK, TICK_RATE } from '../../constants.ts';
import { crossing, farthestRockTravel, isClear } from '../../events/index.ts';
import {
  CENTRAL,
  COAST,
  centralSeries,
  type Motion,
  pairAt,
  RECORDS,
  SLOTS,
  TAYLOR_DEGREE,
  TURNS,
  taylorStep,
} from '../../motion/index.ts';

const { START, FIELD, BASE, BASE_X, BASE_Y, KIND, TURN, DEGREE, LIMIT_X, LIMIT_Y, NEXT, LENGTH_H } = SLOTS;
const { ACCELERATION, AWAKE_COUNT, CROSSED, CROSSED_BEFORE } = SLOTS;
const { TURN_NOT } = TURNS;
const { ROCK } = RECORDS;

/**
 * Orbits of width w are skipped where sqrt(w / pull) is below this, s. From pericentre to pericentre an orbit takes 2.8 to 3.7
 * times that.
 */
const SHORTEST = TICK / 8;

/** Most pieces of one search for the period; a flat orbit takes some dozens. */
const MOST_PIECES = 400;

const x = new Float64Array(TAYLOR_DEGREE + 1);
const y = new Float64Array(TAYLOR_DEGREE + 1);
const e = new Float64Array(4);
// from one pericentre to the next: time, and the rotation as cosine and sine
const turn = new Float64Array(3);
const targetX = new Float64Array(TAYLOR_DEGREE + 1);
const targetY = new Float64Array(TAYLOR_DEGREE + 1);
// what an orbit adds to the target's displacement and velocity
const orbit = new Float64Array(4);

/** Upper bound of an orbit's distance from the centre of her target, px. So near to it the pull is almost constant. */
function width(m: Motion, strength: number): number {
  const { ux, uy } = m;
  return Math.sqrt(ux[0] * ux[0] + uy[0] * uy[0]) + (ux[1] * ux[1] + uy[1] * uy[1]) / (2 * strength);
}

/** Whether she circles her target so closely that orbits are skipped; with `room`, whether this may be so soon. */
export function isTiny(m: Motion, room = 1): boolean {
  const { s, ux, uy } = m;
  // seldom more than the first of these is evaluated
  if (ux[0] * ux[0] + uy[0] * uy[0] > 1e-4 || s[KIND] !== CENTRAL || s[FIELD] >= 0 || m.flow.isSteady) return false;
  const strength = m.rules.pull + m.kappa;
  return width(m, strength) < room * strength * SHORTEST * SHORTEST;
}

/** Time to the next tick, s; at a tick 0, since the button may still change at it. */
function untilTick(time: number): number {
  const n = Math.floor(time * TICK_RATE + 1e-9);
  return (time > n / TICK_RATE ? n + 1 : n) / TICK_RATE - time;
}

/**
 * She circles the very centre of her target many times per tick. From one pericentre to the next, every orbit is the previous
 * one rotated by the same angle. So whole orbits are skipped up to the next tick, and the rotation is raised to the power of
 * their number. With recoil the target moves as she does, and the centre of both moves uniformly. The series is used at every
 * accuracy.
 */
export function skipOrbits(m: Motion): void {
  const { s, ux, uy, px, py } = m;
  if (!isTiny(m) || s[LIMIT_X] !== 0 || s[LIMIT_Y] !== 0) return;
  const left = untilTick(s[START]);
  const { kappa } = m;
  const strength = m.rules.pull + kappa;
  const a = width(m, strength);
  if (left < 4 * Math.sqrt(a / strength) || 4 * a > m.scene.level.range) return;
  const drawn = kappa / strength;
  const vx = px[1] + drawn * ux[1];
  const vy = py[1] + drawn * uy[1];
  const travel = Math.sqrt(vx * vx + vy * vy) * left;
  if (!isClear(m, travel + 2 * a, m.recoil ? farthestRockTravel(m, left) : 0)) return;
  const period = orbitPeriod(m, a, strength);
  const count = period > 0 ? Math.floor(left / period) : 0;
  if (count < 1) return;
  const skipped = count * period;
  const [x0, y0, vx0, vy0] = [ux[0], uy[0], ux[1], uy[1]];
  const [c, q] = [turn[1], turn[2]];
  const [cos, sin] = power(c, q, count);
  if (m.recoil) {
    // the first orbit adds g to the target's velocity and h to its place, the k-th both rotated k times: sums of powers of the
    // rotation
    throughOrbit(m, period, a, strength);
    const [hx, hy, gx, gy] = orbit;
    const off = (1 - c) * (1 - c) + q * q;
    const over = (re: number, im: number): [number, number] => [(re * (1 - c) - im * q) / off, (im * (1 - c) + re * q) / off];
    const [sx, sy] = over(1 - cos, -sin);
    const [tx, ty] = over(count - sx, -sy);
    const dx = px[1] * skipped + period * (gx * tx - gy * ty) + hx * sx - hy * sy;
    const dy = py[1] * skipped + period * (gx * ty + gy * tx) + hx * sy + hy * sx;
    recordMean(m, dx / skipped, dy / skipped, skipped);
    drift(m, dx, dy, px[1] + gx * sx - gy * sy, py[1] + gx * sy + gy * sx, skipped);
  } else {
    recordMean(m, 0, 0, skipped);
  }
  ux[0] = x0 * cos - y0 * sin;
  uy[0] = x0 * sin + y0 * cos;
  ux[1] = vx0 * cos - vy0 * sin;
  uy[1] = vx0 * sin + vy0 * cos;
  m.modeSeconds[m.mode] += skipped;
  s[START] += skipped;
}

/** (c + i q) to the power of n. */
function power(c: number, q: number, n: number): [number, number] {
  let [re, im] = [1, 0];
  let [bx, by] = [c, q];
  for (let left = n; left > 0; left = Math.floor(left / 2)) {
    if (left % 2 === 1) [re, im] = [re * bx - im * by, re * by + im * bx];
    [bx, by] = [bx * bx - by * by, 2 * bx * by];
  }
  return [re, im];
}

/**
 * She swings on a line through the centre of her target, which recoils: advances both by `time` s, a whole number of periods of
 * `period` s, unless something could happen meanwhile.
 * @returns whether it did
 */
function driftsBy(m: Motion, time: number, period: number): boolean {
  const { ux, uy, px, py, kappa } = m;
  const v = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
  // pulled to one side for half a period and to the other for the next half
  const gain = v > 0 ? (kappa * period) / (4 * v) : 0;
  const vx = px[1] + gain * ux[1];
  const vy = py[1] + gain * uy[1];
  const a = width(m, m.rules.pull);
  if (4 * a > m.scene.level.range || !isClear(m, Math.sqrt(vx * vx + vy * vy) * time + 2 * a, farthestRockTravel(m, time)))
    return false;
  recordMean(m, vx, vy, time);
  drift(m, vx * time, vy * time, px[1], py[1], time);
  return true;
}

/**
 * Moves her target by (dx, dy), and her with it, to where it has the velocity (vx, vy); the other asteroids drift for `time` s.
 */
function drift(m: Motion, dx: number, dy: number, vx: number, vy: number, time: number): void {
  const { s, px, py } = m;
  s[BASE_X] += dx;
  s[BASE_Y] += dy;
  px[1] = vx;
  py[1] = vy;
  for (const i of m.stirred) {
    const o = m.rocks + ROCK * i;
    if (i === s[BASE]) {
      s[o] = s[BASE_X];
      s[o + 1] = s[BASE_Y];
      s[o + 2] = vx;
      s[o + 3] = vy;
    } else {
      s[o] += s[o + 2] * time;
      s[o + 1] += s[o + 3] * time;
    }
  }
  m.near.skin = -1;
}

/** Records, for reads between two ticks, that she is in the middle of her orbit and moves with it. */
function recordMean(m: Motion, vx: number, vy: number, length: number): void {
  const { s, ux, uy, px, py, recorder } = m;
  if (recorder === null || !recorder.keeps) return;
  const kept = s.slice();
  for (let k = 0; k < ux.length; k++) ux[k] = uy[k] = px[k] = py[k] = 0;
  s[KIND] = COAST;
  s[TURN] = TURN_NOT;
  s[DEGREE] = 1;
  s[NEXT] = s[LENGTH_H] = length;
  s[ACCELERATION] = 0;
  px[1] = vx;
  py[1] = vy;
  recorder.piece(m, length);
  s.set(kept);
}

/** Number of evaluations that cost as much as a piece of an orbit. */
const LOOKS_A_PIECE = 3;

/**
 * Expands her orbit about the centre, and the motion of a target that recoils at `kappa`; returns for how long they hold, s.
 */
function expandOrbit(m: Motion, a: number, strength: number, beta: number, kappa: number): number {
  m.budget.look(LOOKS_A_PIECE);
  centralSeries(x, y, -strength, beta, targetX, targetY, kappa);
  const d = Math.sqrt(x[0] * x[0] + y[0] * y[0]);
  const v2 = x[1] * x[1] + y[1] * y[1];
  const toCentre = (2 * d) / (Math.sqrt(v2) + Math.sqrt(v2 + 2 * strength * d));
  return taylorStep(x, y, 1e-17 * a, 0.6 * toCentre);
}

/** Advances her target through one orbit as if it rested at the start; writes displacement and velocity to `orbit`. */
function throughOrbit(m: Motion, period: number, a: number, strength: number): void {
  x[0] = m.ux[0];
  y[0] = m.uy[0];
  x[1] = m.ux[1];
  y[1] = m.uy[1];
  orbit.fill(0);
  for (let time = 0; time < period; ) {
    targetX[0] = orbit[0];
    targetY[0] = orbit[1];
    targetX[1] = orbit[2];
    targetY[1] = orbit[3];
    const h = Math.min(expandOrbit(m, a, strength, m.rules.pull / m.scene.level.range, m.kappa), period - time);
    pairAt(targetX, targetY, TAYLOR_DEGREE, h, orbit, 0);
    pairAt(x, y, TAYLOR_DEGREE, h, e, 0);
    x[0] = e[0];
    y[0] = e[1];
    x[1] = e[2];
    y[1] = e[3];
    m.work.forceEvaluations++;
    if (time + h === time) return;
    time += h;
  }
}

/** The time from one pericentre to the next, s, or 0 if none is found; writes the rotation to `turn`. */
function orbitPeriod(m: Motion, a: number, strength: number): number {
  const beta = m.rules.pull / m.scene.level.range;
  x[0] = m.ux[0];
  y[0] = m.uy[0];
  x[1] = m.ux[1];
  y[1] = m.uy[1];
  const shortest = Math.sqrt(a / strength);
  let fromX = 0;
  let fromY = 0;
  let found = 0;
  let time = 0;
  let approaches = false;
  for (let n = 0; n < MOST_PIECES; n++) {
    const h = expandOrbit(m, a, strength, beta, 0);
    if (!(h > 0)) return 0;
    const inward = (t: number) => {
      pairAt(x, y, TAYLOR_DEGREE, t, e, 0);
      return -(e[0] * e[2] + e[1] * e[3]);
    };
    m.work.forceEvaluations++;
    if (inward(h) < 0) {
      // near a circle rounding makes turning points of its own
      if (approaches && (found === 0 || time + h > shortest)) {
        const t = crossing(0, h, inward);
        pairAt(x, y, TAYLOR_DEGREE, t, e, 0);
        if (found === 1) {
          const both = Math.sqrt((fromX * fromX + fromY * fromY) * (e[0] * e[0] + e[1] * e[1]));
          turn[0] = time + t;
          turn[1] = (fromX * e[0] + fromY * e[1]) / both;
          turn[2] = (fromX * e[1] - fromY * e[0]) / both;
          return turn[0];
        }
        found = 1;
        fromX = e[0];
        fromY = e[1];
        time = -t;
      }
      approaches = false;
      pairAt(x, y, TAYLOR_DEGREE, h, e, 0);
    } else {
      approaches = true;
    }
    time += h;
    x[0] = e[0];
    y[0] = e[1];
    x[1] = e[2];
    y[1] = e[3];
  }
  return 0;
}

/**
 * She swings on a line through the centre, faster than the ticks. After two crossings everything but the time is as before, so
 * whole periods are skipped up to the next tick.
 */
export function skipPeriods(m: Motion): void {
  const { s } = m;
  const period = s[CROSSED] > 0 ? s[START] - s[CROSSED_BEFORE] : 0;
  if (s[CROSSED_BEFORE] > 0 && period > 0 && s[AWAKE_COUNT] === 0) {
    const skipped = Math.floor(untilTick(s[START]) / period) - 1;
    if (skipped > 0 && (!m.recoil || driftsBy(m, skipped * period, period))) {
      s[START] += skipped * period;
      m.modeSeconds[m.mode] += skipped * period;
      s[CROSSED] += skipped * period;
    }
  }
  s[CROSSED_BEFORE] = s[CROSSED];
  s[CROSSED] = s[START];
}
