import { GUN_PULL, REPULSOR_PUSH } from '../constants.ts';
import { holdOnLine } from '../effects/gun/index.ts';
import { followRim, setRim } from '../effects/repulsor/index.ts';
import {
  bendLine,
  CENTRAL,
  COAST,
  findLine,
  LINEAR,
  LINES,
  MEETINGS,
  type Motion,
  RECORDS,
  rebase,
  SLIDE,
  SLOTS,
  sideOf,
  stir,
  straighten,
  TURNS,
} from '../motion/index.ts';
import { SMALLEST_ORBIT, SMALLEST_SWING } from '../tolerances.ts';
import { expand } from './expand.ts';
import { locate } from './locate.ts';

const {
  HELD,
  TARGET,
  FIELD,
  KIND,
  TURN,
  COS,
  SIN,
  SIDE,
  LINE_X,
  LINE_Y,
  LIMIT_X,
  LIMIT_Y,
  RIM,
  LINE,
  LINE_STEEP,
  LINE_SLOPE,
  MEETS,
} = SLOTS;
const { NONE } = LINES;
const { NOT } = MEETINGS;
const { TURN_NOT, TURN_TO_BASE, TURN_TO_TARGET } = TURNS;
const { ROCK } = RECORDS;

/** Chooses frame and flow at the start of a piece, expands it, and locates the first event. */
export function begin(m: Motion): void {
  const { s, scene, ux, uy } = m;
  if (s[RIM] >= 0) followRim(m);
  const held = s[HELD] === 1;
  const target = s[TARGET];
  const field = s[FIELD];
  if (field >= 0) {
    if (held && m.recoil) stir(m, target);
    rebase(m, -1, scene.repulsors.x[field] - m.originX, scene.repulsors.y[field] - m.originY, 0, 0);
  } else if (held && m.recoil) {
    stir(m, target);
    const o = m.rocks + ROCK * target;
    rebase(m, target, s[o], s[o + 1], s[o + 2], s[o + 3]);
  } else if (held) {
    rebase(m, target, m.targetX[target], m.targetY[target], 0, 0);
  }

  if (s[RIM] >= 0) {
    s[KIND] = SLIDE;
    s[LINE] = NONE;
    s[MEETS] = NOT;
    s[TURN] = held ? TURN_TO_TARGET : TURN_NOT;
    proceed(m);
    return;
  }
  if ((field >= 0 || held) && s[LINE] === NONE) findLine(m);
  if (s[LINE] !== NONE) bendLine(m);
  const onLine = s[LINE] !== NONE;
  if (onLine) straighten(m, 1);

  s[KIND] = COAST;
  s[TURN] = TURN_NOT;
  s[MEETS] = NOT;
  const x = ux[0];
  const y = uy[0];
  const vx = ux[1];
  const vy = uy[1];
  const d = Math.sqrt(x * x + y * y);
  const v = Math.sqrt(vx * vx + vy * vy);
  const free = s[LIMIT_X] === 0 && s[LIMIT_Y] === 0;
  // how far from the centre she could get under the pull with the energy she has
  const swing = held && field < 0 ? d + (v * v) / (2 * GUN_PULL) : Number.POSITIVE_INFINITY;
  if (swing < (onLine && !m.recoil ? SMALLEST_SWING : SMALLEST_ORBIT)) {
    for (let k = 0; k < 2; k++) ux[k] = uy[k] = 0;
  } else if ((field >= 0 || held) && (d > 0 || v > 0) && (free || d > SMALLEST_ORBIT)) {
    if (free && onLine) {
      s[KIND] = LINEAR;
      s[SIDE] = sideOf(m);
    } else {
      s[KIND] = CENTRAL;
    }
    if (held && field < 0 && s[KIND] === LINEAR) {
      s[COS] = -s[SIDE] * s[LINE_X];
      s[SIN] = -s[SIDE] * s[LINE_Y];
    } else if (held && field < 0) {
      s[TURN] = TURN_TO_BASE;
    }
  }
  if (held && field >= 0 && !holdOnLine(m)) s[TURN] = TURN_TO_TARGET;
  proceed(m);
}

/** The next piece of the same flow. */
export function proceed(m: Motion): void {
  setFlow(m);
  expand(m);
  locate(m);
}

/** Sets the flow from the state: after a restore it must be what it was. */
export function setFlow(m: Motion): void {
  const { s, flow, scene, ux, uy } = m;
  flow.kind = s[KIND];
  flow.freeX = s[LIMIT_X] === 0;
  flow.freeY = s[LIMIT_Y] === 0;
  if (flow.kind === SLIDE) {
    setRim(m);
    return;
  }
  const inField = s[FIELD] >= 0;
  const kappa = inField ? 0 : m.kappa;
  flow.alpha = inField ? REPULSOR_PUSH : -(GUN_PULL + kappa);
  flow.beta = inField ? 0 : GUN_PULL / scene.level.range;
  if (flow.kind !== LINEAR) return;
  flow.range = inField ? 0 : scene.level.range;
  flow.extra = inField ? REPULSOR_PUSH : -kappa;
  flow.steep = s[LINE_STEEP] === 1;
  flow.slope = s[LINE_SLOPE];
  flow.outX = s[SIDE] * s[LINE_X];
  flow.outY = s[SIDE] * s[LINE_Y];
  flow.moveTo(ux[0], uy[0]);
}
