import { CONVERGENCE, LONGEST_TAYLOR, SMALLEST_ORBIT } from '../tolerances.ts';
import { chaserSeries } from './chaser-series.ts';
import { COAST } from './flow.ts';
import { movesAlong, straightenBody } from './line.ts';
import { awakeAt, type Following, type Motion } from './motion.ts';
import { pairAt } from './polynomial.ts';
import { taylorStep } from './power-series.ts';
import { ALERTNESS, MEETINGS, RECORDS, SLOTS } from './state.ts';

const { HELD, TARGET, FIELD, BASE_X, BASE_Y, KIND, LINE_X, LINE_Y, DEGREE, LENGTH_H, ACCELERATION, MEETS, AWAKE_COUNT, OUTCOME } =
  SLOTS;
const { CHASER, ROCK } = RECORDS;
const { ASLEEP, AWAKE } = ALERTNESS;
const { NOT, AHEAD, BEHIND } = MEETINGS;

/** Shortest piece at a close pass of an asteroid, s. */
const CLOSEST_PASS = 1e-8;

/** Longest piece of an asteroid that the gun holds in her centre while she is accelerated, s. */
const LONGEST_STAY = 1 / 240;

/** Longest piece of an asteroid that is dragged along a line, s, so that bounds over it stay tight. */
const LONGEST_DRAG = 4;

/** Chasers that are awake, and the asteroid that she drags from within a field, which comes after all chasers. */
export const FOLLOWERS: Following = {
  begin(m) {
    const { s } = m;
    const awake = s[AWAKE_COUNT];
    if (!m.recoil || s[HELD] === 0 || s[FIELD] < 0) return awake;
    const o = m.chasers + CHASER * m.chaserCount;
    const rock = m.rocks + ROCK * s[TARGET];
    for (let k = 0; k < ROCK; k++) s[o + k] = s[rock + k];
    s[o + 4] = AWAKE;
    return awake + 1;
  },
  expand(m, longest) {
    const { s, ux, uy, px, py, wx, wy } = m;
    for (let k = 0; k < wx.length; k++) {
      const known = k <= s[DEGREE];
      wx[k] = known ? ux[k] + (m.recoil ? px[k] : 0) : 0;
      wy[k] = known ? uy[k] + (m.recoil ? py[k] : 0) : 0;
    }
    wx[0] += s[BASE_X];
    wy[0] += s[BASE_Y];
    const drags = m.recoils && s[m.chasers + CHASER * m.chaserCount + 4] === AWAKE;
    // a fixed step depends on its length, so the length is determined before the first step, as it is after a restore
    let h = drags ? Math.min(longest, longestDrag(m)) : longest;
    const awake = s[AWAKE_COUNT];
    for (let k = 0; k < awake; k++) h = expandOne(m, awakeAt(m, k), m.chaserPull, h);
    return drags ? expandDragged(m, h) : h;
  },
  restore(m) {
    const { s, chaserX, chaserY } = m;
    if (s[AWAKE_COUNT] === 0 && !m.recoils) return;
    FOLLOWERS.expand(m, s[LENGTH_H]);
    if (s[OUTCOME] === 0) return;
    for (let k = 0; k < s[AWAKE_COUNT]; k++) {
      const i = awakeAt(m, k);
      chaserX[i].fill(0, 1);
      chaserY[i].fill(0, 1);
    }
  },
  arrive(m, t) {
    const { s } = m;
    const awake = s[AWAKE_COUNT];
    for (let k = 0; k < awake; k++) arriveOne(m, awakeAt(m, k), t);
    const drag = m.chasers + CHASER * m.chaserCount;
    if (!m.recoils || s[drag + 4] !== AWAKE) return;
    arriveOne(m, m.chaserCount, t);
    const rock = m.rocks + ROCK * s[TARGET];
    for (let k = 0; k < ROCK; k++) s[rock + k] = s[drag + k];
    if (movesAlong(m, s[TARGET])) straightenBody(m, rock);
    s[drag + 4] = ASLEEP;
  },
};

/** Longest piece of the asteroid that she holds while she is in a field, s; begins its series. */
function longestDrag(m: Motion): number {
  const dragged = m.chaserCount;
  beginSeries(m, dragged);
  if (m.s[MEETS] !== NOT) return LONGEST_DRAG;
  if (staysInHer(m)) return m.s[KIND] === COAST ? Number.POSITIVE_INFINITY : LONGEST_STAY;
  return untilMeeting(m, m.chaserX[dragged], m.chaserY[dragged]);
}

/** Expands the asteroid that she holds while she is in a field. */
function expandDragged(m: Motion, longest: number): number {
  const dragged = m.chaserCount;
  if (m.s[MEETS] === NOT && !staysInHer(m)) return expandOne(m, dragged, m.kappa, longest);
  dragOnLine(m, m.chaserX[dragged], m.chaserY[dragged]);
  return longest;
}

/**
 * An asteroid that would swing through her by less than counts as a swing stays in her centre: where nothing accelerates her
 * more than the gun accelerates the asteroid, the gun holds it there. Her series must be known.
 */
function staysInHer(m: Motion): boolean {
  const { s, wx, wy } = m;
  const o = m.chasers + CHASER * m.chaserCount;
  const dx = wx[0] - s[o];
  const dy = wy[0] - s[o + 1];
  const d = Math.sqrt(dx * dx + dy * dy);
  if (d > SMALLEST_ORBIT) return false;
  const vx = wx[1] - s[o + 2];
  const vy = wy[1] - s[o + 3];
  const { kappa } = m;
  if (d + (vx * vx + vy * vy) / (2 * kappa) > SMALLEST_ORBIT) return false;
  return s[KIND] === COAST || 4 * (wx[2] * wx[2] + wy[2] * wy[2]) <= kappa * kappa;
}

/** Expands a body that accelerates at `pull` px/s² towards her. */
function expandOne(m: Motion, i: number, pull: number, longest: number): number {
  beginSeries(m, i);
  const { chase, tolerance } = m.integrator;
  const qx = m.chaserX[i];
  const qy = m.chaserY[i];
  if (chase !== null) return Math.min(longest, chase(qx, qy, m.wx, m.wy, pull, longest, i === m.chaserCount));
  chaserSeries(qx, qy, m.wx, m.wy, pull);
  return Math.min(longest, taylorStep(qx, qy, tolerance, Math.min(longest, LONGEST_TAYLOR)));
}

/** Copies place and velocity of a chaser to its series. */
function beginSeries(m: Motion, i: number): void {
  const { s, chaserX, chaserY, wx } = m;
  const o = m.chasers + CHASER * i;
  if (chaserX[i].length === 0) {
    chaserX[i] = new Float64Array(wx.length);
    chaserY[i] = new Float64Array(wx.length);
  }
  const qx = chaserX[i];
  const qy = chaserY[i];
  qx[0] = s[o];
  qy[0] = s[o + 1];
  qx[1] = s[o + 2];
  qy[1] = s[o + 3];
}

/** On her line the asteroid is accelerated uniformly until it meets her; one that stays in her centre moves as she does. */
function dragOnLine(m: Motion, qx: Float64Array, qy: Float64Array): void {
  const { s, wx, wy } = m;
  if (s[MEETS] !== AHEAD && s[MEETS] !== BEHIND) {
    qx.set(wx);
    qy.set(wy);
    return;
  }
  const a = (-s[MEETS] * m.kappa) / 2;
  qx[2] = a * s[LINE_X];
  qy[2] = a * s[LINE_Y];
  qx.fill(0, 3);
  qy.fill(0, 3);
}

/**
 * An asteroid that is dragged past her, beside her line. Its series ends before it could meet her, as at the pass of a centre:
 * a pass so close that the last terms do not show it must not be stepped over. Chasers that kill touch her before that.
 */
function untilMeeting(m: Motion, qx: Float64Array, qy: Float64Array): number {
  const { wx, wy } = m;
  const dx = wx[0] - qx[0];
  const dy = wy[0] - qy[0];
  const vx = wx[1] - qx[1];
  const vy = wy[1] - qy[1];
  const d = Math.sqrt(dx * dx + dy * dy);
  const v2 = vx * vx + vy * vy;
  if (d === 0 && v2 === 0) return CLOSEST_PASS;
  const time = (2 * d) / (Math.sqrt(v2) + Math.sqrt(v2 + 2 * (m.s[ACCELERATION] + m.kappa) * d));
  return Math.max(CLOSEST_PASS, CONVERGENCE * time);
}

/** Moves a follower to where it is after `t`. */
function arriveOne(m: Motion, i: number, t: number): void {
  const { s } = m;
  const qx = m.chaserX[i];
  const qy = m.chaserY[i];
  const o = m.chasers + CHASER * i;
  pairAt(qx, qy, m.integrator.degree, t, s, o);
  // the series begins here too, in case it is read before the next piece is made
  qx[0] = s[o];
  qy[0] = s[o + 1];
}
