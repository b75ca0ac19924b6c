import { untilGrid } from '../integrators/index.ts';
import {
  ALERTNESS,
  actingForce,
  awakeAt,
  CENTRAL,
  COAST,
  expandSlide,
  LINEAR,
  MEETINGS,
  type Motion,
  RECORDS,
  SLIDE,
  SLOTS,
  STEADY,
  straighten,
} from '../motion/index.ts';
import { CONVERGENCE, SMALLEST_ORBIT, SMALLEST_SWING } from '../tolerances.ts';

const {
  START,
  HELD,
  TARGET,
  FIELD,
  BASE_X,
  BASE_Y,
  KIND,
  SIDE,
  LINE_X,
  LINE_Y,
  LIMIT_X,
  LIMIT_Y,
  DEGREE,
  LENGTH_H,
  ACCELERATION,
  MEETS,
  AWAKE_COUNT,
  OUTCOME,
} = SLOTS;
const { CHASER, ROCK } = RECORDS;
const { AWAKE } = ALERTNESS;
const { NOT, AHEAD, BEHIND } = MEETINGS;

/** Number of evaluations that cost as much as the series of a chaser. */
const LOOKS_A_CHASER = 8;

/** Longest piece of a coast where an index finds the neighbours, px. */
const CROWDED_REACH = 128;

/** Shortest piece at a close pass of an asteroid, s. */
const CLOSEST_PASS = 1e-8;

/** Longest piece of an asteroid that the gun holds in her centre while she is accelerated, s. */
const LONGEST_STAY = 1 / 240;

/** Longest piece under a steady force alone, s, so that bounds over it stay tight. */
const LONGEST_STEADY = 4;

/** Longest piece of an asteroid that is dragged along a line, s, so that bounds over it stay tight. */
const LONGEST_DRAG = 4;

export function expand(m: Motion): void {
  const { s, flow, integrator, ux, uy, px, py, work } = m;
  const held = s[HELD] === 1;
  const kind = s[KIND];
  let awake = s[AWAKE_COUNT];
  const dragged = m.recoil && held && s[FIELD] >= 0;
  if (dragged) {
    const o = m.chasers + CHASER * m.chaserCount;
    const rock = m.rocks + ROCK * s[TARGET];
    for (let k = 0; k < ROCK; k++) s[o + k] = s[rock + k];
    s[o + 4] = AWAKE;
    awake++;
  }
  work.pieces++;
  m.budget.piece(1);

  // fixed steps end on the grid of their own rate, which includes the ticks
  let h = Number.POSITIVE_INFINITY;
  const { rate } = m.scene.accuracy;
  if (((kind !== COAST && kind !== STEADY) || awake > 0) && rate !== null) {
    h = untilGrid(s[START], rate);
  }
  s[DEGREE] = 1;
  s[ACCELERATION] = 0;
  if ((kind === COAST || kind === STEADY) && m.crowded) {
    // where an index finds the neighbours, a long path would find them all
    const speed = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
    if (speed > 0) h = Math.min(h, CROWDED_REACH / speed);
  }
  if (kind === COAST && isLimited(m) && (s[FIELD] >= 0 || held)) {
    // at the speed limit through the very centre: she leaves it straight on
    const speed = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
    if (speed > 0) h = Math.min(h, closestPass(m) / speed);
  }
  if (kind === STEADY) {
    h = expandSteady(m, h);
  } else if (kind === SLIDE) {
    s[DEGREE] = integrator.degree;
    h = expandSlide(m, h);
  } else if (kind !== COAST) {
    s[DEGREE] = integrator.degree;
    const kappa = m.recoil && s[FIELD] < 0 ? m.kappa : 0;
    const drags = m.recoil && kind === CENTRAL;
    h = integrator.expand(flow, ux, uy, h, drags ? px : null, drags ? py : null, kappa);
    if (drags) keepLimits(m);
    if (m.recoil && kind === LINEAR) recoilOnLine(m, kappa);
    if (kind === LINEAR) straighten(m, s[DEGREE]);
    s[ACCELERATION] = integrator.acceleration(flow, ux, uy, h);
    work.forceEvaluations += integrator.evaluations;
  }
  if (awake > 0) {
    h = expandChasers(m, h);
    work.forceEvaluations += awake * integrator.evaluations;
    m.budget.look(LOOKS_A_CHASER * awake);
  }
  s[LENGTH_H] = h;
}

const isLimited = ({ s }: Motion): boolean => s[LIMIT_X] !== 0 || s[LIMIT_Y] !== 0;

/** She is as good as at the speed limit when only this part of it is missing. */
const NEARLY = 1e-6;

/** Whether an axis is held at the speed limit, or is as fast: released there, she must not be driven into it again by less force. */
function isNearLimit(m: Motion): boolean {
  const { ux, uy, px, py } = m;
  const fast = (1 - NEARLY) * m.rules.speedLimit;
  return isLimited(m) || Math.abs(ux[1] + (m.recoil ? px[1] : 0)) >= fast || Math.abs(uy[1] + (m.recoil ? py[1] : 0)) >= fast;
}

/**
 * Within this of the centre of a force that she does not pass on a line, the force has no direction, px. At the speed limit the
 * force reverses there and releases her: a piece across the centre delays that.
 */
export const closestPass = (m: Motion): number => (isNearLimit(m) ? SMALLEST_SWING : SMALLEST_ORBIT);

/** Only a steady force acts, or she passes so near to another force's centre that this has no direction: an exact parabola. */
function expandSteady(m: Motion, longest: number): number {
  const { s, flow, ux, uy, px, py } = m;
  s[DEGREE] = 2;
  ux[2] = flow.freeX ? flow.steadyX / 2 : 0;
  uy[2] = flow.freeY ? flow.steadyY / 2 : 0;
  px[2] = py[2] = 0;
  s[ACCELERATION] = flow.steadyStrength;
  const speed = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
  const isPass = actingForce(m) !== null;
  return Math.min(longest, isPass && speed > 0 ? closestPass(m) / speed : LONGEST_STEADY);
}

/** On an axis that the speed limit holds, her own velocity stays, whatever recoil does to the base. */
function keepLimits(m: Motion): void {
  const { s, ux, uy, px, py } = m;
  for (let k = 2; k <= s[DEGREE]; k++) {
    if (s[LIMIT_X] !== 0) ux[k] = -px[k];
    if (s[LIMIT_Y] !== 0) uy[k] = -py[k];
  }
}

/** On a line through the centre the target's recoil is constant. */
function recoilOnLine(m: Motion, kappa: number): void {
  const { s, px, py } = m;
  const a = (kappa * s[SIDE]) / 2;
  px[2] = a * s[LINE_X];
  py[2] = a * s[LINE_Y];
  for (let k = 3; k <= s[DEGREE]; k++) px[k] = py[k] = 0;
}

/**
 * Expands the chasers that are awake, and the asteroid that she drags from within a field.
 * @param longest - natural length of the piece, s
 * @returns the length for which all of them hold, s
 */
export function expandChasers(m: Motion, longest: number): number {
  const { s, ux, uy, px, py, wx, wy } = m;
  const dragged = m.chaserCount;
  for (let k = 0; k < wx.length; k++) {
    const known = k <= s[DEGREE];
    wx[k] = known ? ux[k] + (m.recoil ? px[k] : 0) : 0;
    wy[k] = known ? uy[k] + (m.recoil ? py[k] : 0) : 0;
  }
  wx[0] += s[BASE_X];
  wy[0] += s[BASE_Y];
  const drags = m.recoils && s[m.chasers + CHASER * dragged + 4] === AWAKE;
  // a fixed step depends on its length, so the length is determined before the first step, as it is after a restore
  let h = drags ? Math.min(longest, longestDrag(m)) : longest;
  const awake = s[AWAKE_COUNT];
  for (let k = 0; k < awake; k++) h = expandChaser(m, awakeAt(m, k), m.chaserPull, h);
  if (drags) h = expandDragged(m, h);
  return h;
}

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
  if (m.s[MEETS] === NOT && !staysInHer(m)) return expandChaser(m, dragged, m.kappa, longest);
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

function expandChaser(m: Motion, i: number, pull: number, longest: number): number {
  beginSeries(m, i);
  return Math.min(longest, m.integrator.chase(m.chaserX[i], m.chaserY[i], m.wx, m.wy, pull, longest));
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

/** After a restore: expands the chasers as they were when the piece began; if the run is over, copies where they are. */
export function restoreChasers(m: Motion): void {
  const { s, chaserX, chaserY } = m;
  if (s[AWAKE_COUNT] === 0 && !m.recoils) return;
  expandChasers(m, s[LENGTH_H]);
  if (s[OUTCOME] === 0) return;
  for (let k = 0; k < s[AWAKE_COUNT]; k++) {
    const i = awakeAt(m, k);
    chaserX[i].fill(0, 1);
    chaserY[i].fill(0, 1);
  }
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
