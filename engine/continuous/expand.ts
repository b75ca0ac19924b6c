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
import { CONVERGENCE, SMALLEST_ORBIT } from '../tolerances.ts';

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

/** Looks that take as long as the series of a chaser. */
const LOOKS_A_CHASER = 8;

/** Longest piece of a coast among so many things that an index finds the near ones, px. */
const CROWDED_REACH = 128;

/** Shortest piece that a rock's close pass makes, s. */
const CLOSEST_PASS = 1e-8;

/** Longest piece of a rock that the gun holds in her centre while she is accelerated, s. */
const LONGEST_STAY = 1 / 240;

/** Longest piece of her who is held at the speed limit beside a steady force, s: when it lets go is looked for at its end. */
const LONGEST_HELD = 1 / 240;

/** Longest piece under a steady force alone, so that bounds over it stay tight, s. */
const LONGEST_STEADY = 4;

/** Longest piece of a rock that is dragged along a line, so that bounds over it stay tight, s. */
const LONGEST_DRAG = 4;

export function expand(m: Motion): void {
  const { s, flow, integrator, ux, uy, px, py, work } = m;
  const aliens = m.scene.aliens.count;
  const held = s[HELD] === 1;
  const kind = s[KIND];
  let awake = s[AWAKE_COUNT];
  const dragged = m.recoil && held && s[FIELD] >= 0;
  if (dragged) {
    const o = m.chasers + CHASER * aliens;
    const rock = m.rocks + ROCK * s[TARGET];
    for (let k = 0; k < ROCK; k++) s[o + k] = s[rock + k];
    s[o + 4] = AWAKE;
    awake++;
  }
  work.pieces++;
  m.budget.piece(1);

  // fixed steps end on a grid of their own rate, which the ticks are a part of
  let h = Number.POSITIVE_INFINITY;
  const { rate } = m.scene.accuracy;
  if (((kind !== COAST && kind !== STEADY) || awake > 0) && rate !== null) {
    h = untilGrid(s[START], rate);
  }
  s[DEGREE] = 1;
  s[ACCELERATION] = 0;
  if (m.flow.isSteady && (s[LIMIT_X] !== 0 || s[LIMIT_Y] !== 0)) h = Math.min(h, LONGEST_HELD);
  if ((kind === COAST || kind === STEADY) && m.crowded) {
    // where an index finds the neighbours, a long path would find them all
    const speed = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
    if (speed > 0) h = Math.min(h, CROWDED_REACH / speed);
  }
  if (kind === COAST && (s[LIMIT_X] !== 0 || s[LIMIT_Y] !== 0) && (s[FIELD] >= 0 || held)) {
    // at the limit through the very centre: out of it straight on
    h = Math.min(h, SMALLEST_ORBIT / m.rules.speedLimit);
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

/** Nothing but a steady force acts, or she passes so near to the centre of another that its direction is none: a parabola, exactly. */
function expandSteady(m: Motion, longest: number): number {
  const { s, flow, ux, uy, px, py } = m;
  s[DEGREE] = 2;
  ux[2] = flow.freeX ? flow.steadyX / 2 : 0;
  uy[2] = flow.freeY ? flow.steadyY / 2 : 0;
  px[2] = py[2] = 0;
  s[ACCELERATION] = flow.steadyStrength;
  const speed = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
  const isPass = actingForce(m) !== null;
  return Math.min(longest, isPass && speed > 0 ? SMALLEST_ORBIT / speed : LONGEST_STEADY);
}

/** On an axis that the speed limit holds it is her own velocity that stays, whatever recoil does to the base. */
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
 * Expands aliens that are awake, and the rock she drags from within a field.
 * @param longest natural length of the piece, s
 * @returns the length for which all of them hold
 */
export function expandChasers(m: Motion, longest: number): number {
  const { s, ux, uy, px, py, wx, wy } = m;
  const aliens = m.scene.aliens.count;
  for (let k = 0; k < wx.length; k++) {
    const known = k <= s[DEGREE];
    wx[k] = known ? ux[k] + (m.recoil ? px[k] : 0) : 0;
    wy[k] = known ? uy[k] + (m.recoil ? py[k] : 0) : 0;
  }
  wx[0] += s[BASE_X];
  wy[0] += s[BASE_Y];
  const drags = m.recoils && s[m.chasers + CHASER * aliens + 4] === AWAKE;
  // a fixed step depends on its length: it is known before the first is made, as it is after a restore
  let h = drags ? Math.min(longest, longestDrag(m)) : longest;
  const awake = s[AWAKE_COUNT];
  for (let k = 0; k < awake; k++) h = expandChaser(m, awakeAt(m, k), m.rules.alienPull, h);
  if (drags) h = expandDragged(m, h);
  return h;
}

/** How long a piece of the rock that she holds while she is in a field may be, s; its series begins. */
function longestDrag(m: Motion): number {
  const aliens = m.scene.aliens.count;
  beginSeries(m, aliens);
  if (m.s[MEETS] !== NOT) return LONGEST_DRAG;
  if (staysInHer(m)) return m.s[KIND] === COAST ? Number.POSITIVE_INFINITY : LONGEST_STAY;
  return untilMeeting(m, m.chaserX[aliens], m.chaserY[aliens]);
}

/** The rock that she holds while she is in a field. */
function expandDragged(m: Motion, longest: number): number {
  const aliens = m.scene.aliens.count;
  if (m.s[MEETS] === NOT && !staysInHer(m)) return expandChaser(m, aliens, m.kappa, longest);
  dragOnLine(m, m.chaserX[aliens], m.chaserY[aliens]);
  return longest;
}

/**
 * A rock that would swing through her by less than counts as a swing stays in her centre: where nothing accelerates her by more
 * than the gun accelerates it, the gun holds it there. Her series must be known.
 */
function staysInHer(m: Motion): boolean {
  const { s, wx, wy } = m;
  const o = m.chasers + CHASER * m.scene.aliens.count;
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

/** Place and velocity of a chaser into its series. */
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

/** After a restore: the series of those that chase, as they were when the piece began; where they are when the run is over. */
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

/** On her line the rock is accelerated evenly until it meets her; one that stays in her centre goes where she goes. */
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
 * A rock that is dragged past her, beside her line: its series ends short of where it could meet her, as it does at the pass of a centre. One too close for the last terms to show it must not be stepped over. Aliens touch her before.
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
