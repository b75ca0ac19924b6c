import { untilGrid } from '../integrators/index.ts';
import { actingForce, CENTRAL, COAST, LINEAR, type Motion, SLIDE, SLOTS, STEADY, straighten } from '../motion/index.ts';
import { SMALLEST_ORBIT, SMALLEST_SWING } from '../tolerances.ts';

const { START, HELD, FIELD, KIND, SIDE, LINE_X, LINE_Y, LIMIT_X, LIMIT_Y, DEGREE, LENGTH_H, ACCELERATION, AWAKE_COUNT } = SLOTS;

/** Number of evaluations that cost as much as the series of what follows her. */
const LOOKS_A_FOLLOWER = 8;

/** Longest piece of a coast where an index finds the neighbours, px. */
const CROWDED_REACH = 128;

/** Longest piece under a steady force alone, s, so that bounds over it stay tight. */
const LONGEST_STEADY = 4;

export function expand(m: Motion): void {
  const { s, flow, integrator, ux, uy, px, py, work } = m;
  const held = s[HELD] === 1;
  const kind = s[KIND];
  const { sliding, following } = m.parts;
  const followers = following !== null && (s[AWAKE_COUNT] > 0 || m.recoil) ? following.begin(m) : 0;
  work.pieces++;
  m.budget.piece(1);

  // fixed steps end on the grid of their own rate, which includes the ticks
  let h = Number.POSITIVE_INFINITY;
  const { rate } = m.scene.accuracy;
  if (((kind !== COAST && kind !== STEADY) || followers > 0) && rate !== null) {
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
    h = sliding?.expand(m, h) ?? h;
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
  if (following !== null && followers > 0) {
    h = following.expand(m, h);
    work.forceEvaluations += followers * integrator.evaluations;
    m.budget.look(LOOKS_A_FOLLOWER * followers);
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
