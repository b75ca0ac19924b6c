import { COAST, SLIDE, STEADY } from './flow.ts';
import { ontoLine } from './line.ts';
import type { Motion } from './motion.ts';
import { pairAt } from './polynomial.ts';
import { settleSlide } from './rim-piece.ts';
import { ALERTNESS, LINES, RECORDS, SLOTS, TURNS } from './state.ts';

const { TARGET, BASE, BASE_X, BASE_Y, KIND, TURN, COS, SIN, DEGREE, LINE, LINE_STEEP, LINE_SLOPE } = SLOTS;
const { TURN_NOT, TURN_TO_TARGET } = TURNS;
const { CHASER, ROCK } = RECORDS;
const { AWAKE } = ALERTNESS;
const { NONE, FAST } = LINES;

/** e[0..3]: u and its velocity after `t`; e[4..7]: the base's displacement and velocity. */
function settleAt(m: Motion, t: number): void {
  const { s, e } = m;
  const { settle } = m.integrator;
  if (settle === null || s[KIND] === COAST || s[KIND] === STEADY) pairAt(m.ux, m.uy, s[DEGREE], t, e, 0);
  else if (s[KIND] === SLIDE) settleSlide(m, t, e);
  else settle(m.flow, m.ux, m.uy, t, e);
  if (m.recoil) pairAt(m.px, m.py, s[DEGREE], t, e, 4);
  keepBounds(m);
}

/** e[0..7] as {@link settleAt} has it, e[8..9] as {@link directionAt}: evaluated once where the piece itself says both. */
export function settleAndTurnAt(m: Motion, t: number): void {
  directionAt(m, t);
  if (m.integrator.settle === null && m.s[TURN] !== TURN_NOT) keepBounds(m);
  else settleAt(m, t);
}

/** What settled stays within the speed limit and on its line. */
function keepBounds(m: Motion): void {
  const { s, e, recoil } = m;
  if (!recoil) e[4] = e[5] = e[6] = e[7] = 0;
  const { speedLimit } = m.rules;
  // a fixed step may overshoot the speed limit by what its velocity errs
  const vx = e[2] + e[6];
  const vy = e[3] + e[7];
  if (vx > speedLimit || vx < -speedLimit) e[2] = (vx > 0 ? speedLimit : -speedLimit) - e[6];
  if (vy > speedLimit || vy < -speedLimit) e[3] = (vy > 0 ? speedLimit : -speedLimit) - e[7];
  if (s[LINE] === NONE) return;
  const steep = s[LINE_STEEP] === 1;
  ontoLine(steep, s[LINE_SLOPE], e, 0);
  if (s[LINE] === FAST && recoil) ontoLine(steep, s[LINE_SLOPE], e, 4);
}

/** e[8], e[9]: direction of the box's x axis after `t`; where it turns, e[0..7] as {@link placeAt} has it. */
export function directionAt(m: Motion, t: number): void {
  const { s, e } = m;
  e[8] = s[COS];
  e[9] = s[SIN];
  if (s[TURN] === TURN_NOT) return;
  placeAt(m, t);
  let dx = -e[0];
  let dy = -e[1];
  let dvx = -e[2];
  let dvy = -e[3];
  if (s[TURN] === TURN_TO_TARGET) {
    lookAt(m, t);
    dx = e[8];
    dy = e[9];
    dvx = e[10];
    dvy = e[11];
  }
  let d = Math.sqrt(dx * dx + dy * dy);
  if (d === 0) {
    // in the very centre: the way she will look as soon as she has left it
    dx = dvx;
    dy = dvy;
    d = Math.sqrt(dx * dx + dy * dy);
  }
  e[8] = d > 0 ? dx / d : s[COS];
  e[9] = d > 0 ? dy / d : s[SIN];
}

/** e[0..3]: u and its velocity on the piece as it was located; e[4..7]: the base's displacement. */
export function placeAt(m: Motion, t: number): void {
  const { s, e } = m;
  pairAt(m.ux, m.uy, s[DEGREE], t, e, 0);
  if (m.recoil) pairAt(m.px, m.py, s[DEGREE], t, e, 4);
}

/** e[0..3]: place (relative to the origin) and velocity of a target after `t`. */
export function rockAt(m: Motion, i: number, t: number): void {
  const { s, e } = m;
  if (!m.recoil) {
    e[0] = m.targetX[i];
    e[1] = m.targetY[i];
    e[2] = 0;
    e[3] = 0;
    return;
  }
  const dragged = m.chaserX.length - 1;
  if (i === s[BASE]) {
    pairAt(m.px, m.py, s[DEGREE], t, e, 0);
    e[0] += s[BASE_X];
    e[1] += s[BASE_Y];
  } else if (i === s[TARGET] && s[m.chasers + CHASER * dragged + 4] === AWAKE) {
    pairAt(m.chaserX[dragged], m.chaserY[dragged], m.integrator.degree, t, e, 0);
  } else {
    const o = m.rocks + ROCK * i;
    e[0] = s[o] + s[o + 2] * t;
    e[1] = s[o + 1] + s[o + 3] * t;
    e[2] = s[o + 2];
    e[3] = s[o + 3];
  }
}

/** e[8..11]: the target's place minus hers, and its velocity, after `t`; e[0..7] are kept. */
export function lookAt(m: Motion, t: number): void {
  const { s, e } = m;
  const ux = e[0];
  const uy = e[1];
  const vx = e[2];
  const vy = e[3];
  rockAt(m, s[TARGET], t);
  e[8] = e[0] - s[BASE_X] - ux;
  e[9] = e[1] - s[BASE_Y] - uy;
  e[10] = e[2] - vx;
  e[11] = e[3] - vy;
  e[0] = ux;
  e[1] = uy;
  e[2] = vx;
  e[3] = vy;
}

export function alienPlaceAt(m: Motion, i: number, t: number, at: number): void {
  const { s, e } = m;
  const o = m.chasers + CHASER * i;
  if (s[o + 4] === AWAKE) {
    pairAt(m.chaserX[i], m.chaserY[i], m.integrator.degree, t, e, at);
    return;
  }
  e[at] = s[o];
  e[at + 1] = s[o + 1];
  e[at + 2] = 0;
  e[at + 3] = 0;
}
