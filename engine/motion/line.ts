import { RADIAL, RADIAL_ROUNDING } from '../tolerances.ts';
import type { Motion } from './motion.ts';
import { LINES, RECORDS, SLOTS } from './state.ts';

const { BASE, BASE_X, BASE_Y, LINE_X, LINE_Y, LIMIT_X, LIMIT_Y, LINE, LINE_STEEP, LINE_SLOPE, LINE_AT_X, LINE_AT_Y, LINE_COUNT } =
  SLOTS;
const { ROCK } = RECORDS;
const { NONE, LOOSE, FAST } = LINES;

/**
 * Motion on a line through the centre of the force. That she is on such a line is part of the state; it is not derived from
 * rounded coordinates again and again. Only a force that does not act along the line, or the speed limit on one axis, can turn
 * her off it. A line is steep (its main axis is y) or not (x). The coordinate along the main axis is the motion; the other one
 * is always `slope` times as much, with
 * |slope| <= 1. So neither place nor velocity across the line can grow, and projecting onto the line twice changes no bit.
 */

/** Projects a place and a velocity, out[at..at+3], onto the line through the origin. */
export function ontoLine(steep: boolean, slope: number, out: Float64Array, at: number): void {
  if (steep) {
    out[at] = out[at + 1] * slope;
    out[at + 2] = out[at + 3] * slope;
  } else {
    out[at + 1] = out[at] * slope;
    out[at + 3] = out[at + 2] * slope;
  }
}

/** Projects her place and velocity and the rest of her piece onto her line, and the base's displacement along it. */
export function straighten(m: Motion, degree: number): void {
  const { s, ux, uy, px, py } = m;
  const slope = s[LINE_SLOPE];
  const steep = s[LINE_STEEP] === 1;
  const [main, other] = steep ? [uy, ux] : [ux, uy];
  for (let k = 0; k <= degree; k++) other[k] = main[k] * slope;
  if (s[LINE] !== FAST || !m.recoil) return;
  const [along, across] = steep ? [py, px] : [px, py];
  for (let k = 0; k <= degree; k++) across[k] = along[k] * slope;
}

/** Projects a body onto the line: place from the motion's origin and velocity, in s[at..at+3]. */
export function straightenBody(m: Motion, at: number): void {
  const { s } = m;
  const slope = s[LINE_SLOPE];
  if (s[LINE_STEEP] === 1) {
    s[at] = s[LINE_AT_X] + (s[at + 1] - s[LINE_AT_Y]) * slope;
    s[at + 2] = s[at + 3] * slope;
  } else {
    s[at + 1] = s[LINE_AT_Y] + (s[at] - s[LINE_AT_X]) * slope;
    s[at + 3] = s[at + 2] * slope;
  }
}

/** Whether recoil moves this target along her line. */
export function movesAlong(m: Motion, target: number): boolean {
  return m.s[LINE] === FAST && m.s[m.lines + target] === m.s[LINE_COUNT];
}

/** Whether a target's centre is on her line and stays on it. */
export function holdsTarget(m: Motion, target: number): boolean {
  const { s } = m;
  if (s[LINE] !== FAST) return false;
  if (!m.recoil) return isNear(m, m.targetX[target], m.targetY[target], 0, 0);
  if (movesAlong(m, target)) return true;
  const o = m.rocks + ROCK * target;
  if (!isNear(m, s[o], s[o + 1], s[o + 2], s[o + 3])) return false;
  s[m.lines + target] = s[LINE_COUNT];
  return true;
}

/** Whether a place (px from the motion's origin) and its velocity are on the line, as far as rounding can tell. */
function isNear(m: Motion, x: number, y: number, vx: number, vy: number): boolean {
  const { s } = m;
  const slope = s[LINE_SLOPE];
  const dx = x - s[LINE_AT_X];
  const dy = y - s[LINE_AT_Y];
  const steep = s[LINE_STEEP] === 1;
  const aside = steep ? dx - dy * slope : dy - dx * slope;
  const size = Math.abs(x) + Math.abs(y) + Math.abs(s[LINE_AT_X]) + Math.abs(s[LINE_AT_Y]);
  return Math.abs(aside) <= RADIAL + RADIAL_ROUNDING * size && isAlong(steep, slope, vx, vy);
}

function isAlong(steep: boolean, slope: number, vx: number, vy: number): boolean {
  const aside = steep ? vx - vy * slope : vy - vx * slope;
  return Math.abs(aside) <= RADIAL_ROUNDING * (Math.abs(vx) + Math.abs(vy));
}

/** The frame gets another base: she stays on her line if the base is on it. */
function keepLine(m: Motion, base: number, x: number, y: number): void {
  const { s } = m;
  if (s[LINE] === NONE) return;
  const stays = s[LINE] === FAST && (base >= 0 ? holdsTarget(m, base) : isNear(m, x, y, 0, 0));
  if (!stays) s[LINE] = NONE;
}

/**
 * A force begins to act: finds out whether she is on a line through its centre. She is if she rests, or if her path leads
 * through the centre as far as rounding can tell.
 */
export function findLine(m: Motion): void {
  const { s, ux, uy } = m;
  const x = ux[0];
  const y = uy[0];
  const vx = ux[1];
  const vy = uy[1];
  // also 0 where its square underflows
  const v = Math.sqrt(vx * vx + vy * vy);
  if (v === 0) {
    if (x !== 0 || y !== 0) beginLine(m, x, y);
    return;
  }
  const size = Math.abs(s[BASE_X]) + Math.abs(s[BASE_Y]) + Math.abs(x) + Math.abs(y);
  if (Math.abs(x * vy - y * vx) > (RADIAL + RADIAL_ROUNDING * size) * v) return;
  // close to the centre, the velocity gives the line more exactly than the place
  if (Math.abs(x) + Math.abs(y) > 1e-6) beginLine(m, x, y);
  else beginLine(m, vx, vy);
}

/** Puts her on the line through the base in the direction (x, y). */
export function beginLine(m: Motion, x: number, y: number): void {
  const { s, px, py } = m;
  const steep = Math.abs(y) > Math.abs(x);
  const slope = steep ? x / y : y / x;
  const main = 1 / Math.sqrt(1 + slope * slope);
  s[LINE_STEEP] = steep ? 1 : 0;
  s[LINE_SLOPE] = slope;
  s[LINE_X] = steep ? slope * main : main;
  s[LINE_Y] = steep ? main : slope * main;
  s[LINE_AT_X] = s[BASE_X];
  s[LINE_AT_Y] = s[BASE_Y];
  s[LINE_COUNT]++;
  s[LINE] = isAlong(steep, slope, px[1], py[1]) ? FAST : LOOSE;
  if (s[LINE] === FAST && s[BASE] >= 0 && m.recoil) s[m.lines + s[BASE]] = s[LINE_COUNT];
}

/** The speed limit holds one axis alone: this turns her off a line that is oblique to both axes. */
export function bendLine(m: Motion): void {
  const { s } = m;
  if (s[LIMIT_X] === 0 && s[LIMIT_Y] === 0) return;
  const slope = Math.abs(s[LINE_SLOPE]);
  if (s[LINE] === LOOSE || (slope !== 0 && slope !== 1)) s[LINE] = NONE;
}

/** A steady force turns her off her line, unless it acts along it. */
export function keepSteadyLine(m: Motion): void {
  const { s, flow } = m;
  if (!isAlong(s[LINE_STEEP] === 1, s[LINE_SLOPE], flow.steadyX, flow.steadyY)) s[LINE] = NONE;
}

/** On which side of the origin she is along the line, +1 or -1; in the origin, the side she is moving to. */
export function sideOf(m: Motion): number {
  const steep = m.s[LINE_STEEP] === 1;
  const along = steep ? m.uy : m.ux;
  const steady = steep ? m.flow.steadyY : m.flow.steadyX;
  return along[0] < 0 || (along[0] === 0 && (along[1] < 0 || (along[1] === 0 && steady < 0))) ? -1 : 1;
}

/** Moves the origin of the frame to a point, or to a target and its velocity. */
export function rebase(m: Motion, base: number, x: number, y: number, vx: number, vy: number): void {
  const { s, ux, uy, px, py } = m;
  if (s[BASE] === base && s[BASE_X] === x && s[BASE_Y] === y) return;
  keepLine(m, base, x, y);
  ux[0] += s[BASE_X] - x;
  uy[0] += s[BASE_Y] - y;
  ux[1] += px[1] - vx;
  uy[1] += py[1] - vy;
  s[BASE] = base;
  s[BASE_X] = x;
  s[BASE_Y] = y;
  px[1] = vx;
  py[1] = vy;
}
