import type { Effect } from '../effects/index.ts';
import { farthestRockTravel, ownTravel, refresh, sortNeighbours } from '../events/index.ts';
import {
  actingForce,
  beginLine,
  bendLine,
  CENTRAL,
  type CentralForce,
  COAST,
  findLine,
  keepSteadyLine,
  LINEAR,
  LINES,
  MEETINGS,
  type Motion,
  ONSETS,
  PIECE_END,
  placeAt,
  SLIDE,
  SLOTS,
  STEADY,
  sideOf,
  straighten,
  TURNS,
} from '../motion/index.ts';
import { SMALLEST_ORBIT, SMALLEST_SWING } from '../tolerances.ts';
import { closestPass, expand } from './expand.ts';

const { HELD, KIND, TURN, SIDE, LINE_X, LINE_Y, LIMIT_X, LIMIT_Y, RIM, LINE, LINE_STEEP, LINE_SLOPE, MEETS } = SLOTS;
const { STEADY_X, STEADY_Y, TARGET, FIELD, COVER, BASE, COS, FROM, NEXT, EVENT, ONSET, BASE_X, BASE_Y } = SLOTS;
const { LENGTH_H } = SLOTS;
const { NONE } = LINES;
const { NOT } = MEETINGS;
const { TURN_NOT, TURN_TO_TARGET } = TURNS;

/** Chooses frame and flow at the start of a piece, expands it, and locates the first event. */
export function begin(m: Motion): void {
  const { s, ux, uy, parts } = m;
  const { beforePiece, turn } = parts;
  for (let k = 0; k < beforePiece.length; k++) beforePiece[k](m);
  const force = actingForce(m);
  force?.centre(m);
  addSteadyForces(m);
  const { isSteady } = m.flow;
  if (s[RIM] >= 0) {
    s[KIND] = SLIDE;
    s[LINE] = NONE;
    s[MEETS] = NOT;
    s[TURN] = s[HELD] === 1 ? TURN_TO_TARGET : TURN_NOT;
    start(m, force);
    return;
  }
  if (force !== null && s[LINE] === NONE) findLine(m);
  if (s[LINE] !== NONE) bendLine(m);
  if (isSteady && s[LINE] !== NONE) keepSteadyLine(m);
  // at rest in the very centre, a stronger steady force drives her out along its own direction
  const isStill = ux[0] === 0 && uy[0] === 0 && ux[1] === 0 && uy[1] === 0;
  if (isSteady && force !== null && isStill && s[LINE] === NONE) beginLine(m, m.flow.steadyX, m.flow.steadyY);
  const onLine = s[LINE] !== NONE;
  if (onLine) straighten(m, 1);

  s[KIND] = isSteady ? STEADY : COAST;
  s[TURN] = TURN_NOT;
  s[MEETS] = NOT;
  if (force !== null) {
    const d = Math.sqrt(ux[0] * ux[0] + uy[0] * uy[0]);
    const v = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
    const free = s[LIMIT_X] === 0 && s[LIMIT_Y] === 0;
    if (force.swing(m, d, v) < (onLine && !m.recoil ? SMALLEST_SWING : SMALLEST_ORBIT)) {
      for (let k = 0; k < 2; k++) ux[k] = uy[k] = 0;
      s[KIND] = COAST;
    } else if ((d > 0 || v > 0 || (isSteady && onLine)) && ((free && (onLine || !isSteady)) || d > closestPass(m))) {
      const isLinear = free && onLine;
      s[KIND] = isLinear ? LINEAR : CENTRAL;
      if (isLinear) s[SIDE] = sideOf(m);
    }
  }
  for (let k = 0; k < turn.length; k++) turn[k](m);
  start(m, force);
}

/** Begins the first piece of a flow. */
function start(m: Motion, force: CentralForce | null): void {
  setCentralForce(m, force);
  expand(m);
  locate(m);
}

/** Adds up the steady forces that act on her and keeps their sum in the state. */
function addSteadyForces(m: Motion): void {
  const { s, flow, parts } = m;
  const { steady } = parts;
  if (steady.length === 0) return;
  flow.setSteady(0, 0);
  for (let k = 0; k < steady.length; k++) steady[k].add(m);
  s[STEADY_X] = flow.steadyX;
  s[STEADY_Y] = flow.steadyY;
}

/** Begins the next piece of the same flow. */
export function proceed(m: Motion): void {
  if (m.flow.kind === LINEAR) m.flow.moveTo(m.ux[0], m.uy[0]);
  expand(m);
  locate(m);
}

/** Sets the flow from the state. After a restore it must be the same as before. */
export function setFlow(m: Motion): void {
  m.flow.setSteady(m.s[STEADY_X], m.s[STEADY_Y]);
  setCentralForce(m, actingForce(m));
}

/** The same without the steady forces. */
function setCentralForce(m: Motion, force: CentralForce | null): void {
  const { s, flow, parts, ux, uy } = m;
  flow.kind = s[KIND];
  flow.freeX = s[LIMIT_X] === 0;
  flow.freeY = s[LIMIT_Y] === 0;
  if (flow.kind === SLIDE) {
    parts.sliding?.set(m);
    return;
  }
  force?.set(m);
  if (flow.kind !== LINEAR) return;
  flow.steep = s[LINE_STEEP] === 1;
  flow.slope = s[LINE_SLOPE];
  flow.outX = s[SIDE] * s[LINE_X];
  flow.outY = s[SIDE] * s[LINE_Y];
  flow.moveTo(ux[0], uy[0]);
}

/** Places everything where the level has it. */
export function layOut(m: Motion, effects: readonly Effect[]): void {
  const { s } = m;
  const { astronaut } = m.scene.level;
  const { speedLimit } = m.rules;
  s[TARGET] = -1;
  s[FIELD] = -1;
  s[COVER] = -1;
  s[BASE] = -1;
  s[RIM] = -1;
  s[COS] = 1;
  // first, since her direction decides on which side of a rim she starts
  m.ux[1] = Math.min(speedLimit, Math.max(-speedLimit, astronaut.vx));
  m.uy[1] = Math.min(speedLimit, Math.max(-speedLimit, astronaut.vy));
  for (const effect of effects) effect.layOut?.(m);
}

/** How far she and asteroids get on a coast without an end of its own, before an event that comes for certain, px. */
function endlessReach(m: Motion, speed: number): number {
  const { latest } = m.parts;
  let end = Number.POSITIVE_INFINITY;
  for (let k = 0; k < latest.length; k++) end = Math.min(end, latest[k].latest?.(m) ?? end);
  return ownTravel(m, speed, end) + (m.recoil ? farthestRockTravel(m, end) : 0);
}

/** Locates the first event in (FROM, LENGTH_H] of the piece; the natural end if nothing happens before. */
export function locate(m: Motion): void {
  const { s, her, base, near, path, parts } = m;
  s[NEXT] = s[LENGTH_H];
  s[EVENT] = PIECE_END;
  s[ONSET] = ONSETS.COMES;
  const from = s[FROM];
  // the path stays within `reach` of its start
  placeAt(m, 0);
  const x = s[BASE_X] + her[0];
  const y = s[BASE_Y] + her[1];
  const vx = her[2] + (m.recoil ? base[2] : 0);
  const vy = her[3] + (m.recoil ? base[3] : 0);
  const h = s[LENGTH_H];
  const speed = Math.sqrt(vx * vx + vy * vy);
  const travel = ownTravel(m, speed, h);
  const rocks = m.recoil ? farthestRockTravel(m, h) : 0;
  const reach = travel + rocks;

  const { first, always, byKind } = parts;
  for (let k = 0; k < first.length; k++) first[k].first?.(m, from);
  const far = h === Number.POSITIVE_INFINITY ? endlessReach(m, speed) : reach;
  if (m.recoil || !near.covers(x, y, far, s[TARGET])) refresh(m, x, y, far);
  const gone = near.distance(x, y) + far;
  if (near.isRough && near.hasTwoWithin(gone)) sortNeighbours(m);
  m.budget.look((near.count + m.stirred.length) >> 4);
  for (let i = 0; i < near.count; i++) {
    if (near.slack[i] > gone) continue;
    byKind[near.kind[i]].guard?.(m, near.index[i], from);
  }
  path.x = x;
  path.y = y;
  path.vx = vx;
  path.vy = vy;
  path.speed = speed;
  path.travel = travel;
  path.reach = reach;
  for (let k = 0; k < always.length; k++) always[k].always?.(m, from);
}
