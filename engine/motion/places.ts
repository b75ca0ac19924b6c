import { CENTRAL, COAST, SLIDE, STEADY } from './flow.ts';
import { ontoLine } from './line.ts';
import type { Motion } from './motion.ts';
import { pairAt } from './polynomial.ts';
import { ALERTNESS, LINES, RECORDS, SLOTS, TURNS } from './state.ts';

const { TARGET, BASE, BASE_X, BASE_Y, KIND, TURN, COS, SIN, DEGREE, LIMIT_X, LIMIT_Y, LINE, LINE_STEEP, LINE_SLOPE } = SLOTS;
const { TURN_NOT, TURN_TO_TARGET } = TURNS;
const { CHASER, ROCK } = RECORDS;
const { AWAKE } = ALERTNESS;
const { NONE, FAST } = LINES;

/** Writes the states of her and the base after `t` to `m.her` and `m.base`. */
function arriveAt(m: Motion, t: number): void {
  const { s, her } = m;
  const { arrive } = m.integrator;
  if (arrive === null || s[KIND] === COAST || s[KIND] === STEADY) pairAt(m.ux, m.uy, s[DEGREE], t, her, 0);
  else if (s[KIND] === SLIDE) m.parts.sliding?.arrive(m, t, her);
  else arrive(m.flow, m.ux, m.uy, t, her);
  if (m.recoil) {
    pairAt(m.px, m.py, s[DEGREE], t, m.base, 0);
    if (arrive !== null && s[KIND] === CENTRAL) holdLimits(m, t);
  }
  keepBounds(m);
}

/** Writes the states of her and the base after `t`, and her box's direction, to `m.her`, `m.base` and `m.facing`. */
export function arriveAndTurnAt(m: Motion, t: number): void {
  directionAt(m, t);
  if (m.integrator.arrive === null && m.s[TURN] !== TURN_NOT) keepBounds(m);
  else arriveAt(m, t);
}

/**
 * Fixed steps take no account of the base: an axis that the speed limit holds keeps its velocity, however recoil moves the
 * base.
 */
function holdLimits(m: Motion, t: number): void {
  const { s, her, base } = m;
  const { speedLimit } = m.rules;
  if (s[LIMIT_X] !== 0) {
    her[0] = m.ux[0] + (s[LIMIT_X] * speedLimit * t - base[0]);
    her[2] = s[LIMIT_X] * speedLimit - base[2];
  }
  if (s[LIMIT_Y] !== 0) {
    her[1] = m.uy[0] + (s[LIMIT_Y] * speedLimit * t - base[1]);
    her[3] = s[LIMIT_Y] * speedLimit - base[3];
  }
}

/** Keeps what {@link arriveAt} found within the speed limit and on her line. */
function keepBounds(m: Motion): void {
  const { s, her, base, recoil } = m;
  // four stores: `fill` would cost more than everything else here
  if (!recoil) base[0] = base[1] = base[2] = base[3] = 0;
  const { speedLimit } = m.rules;
  // a fixed step may exceed the speed limit by the error of its velocity
  const vx = her[2] + base[2];
  const vy = her[3] + base[3];
  if (vx > speedLimit || vx < -speedLimit) her[2] = (vx > 0 ? speedLimit : -speedLimit) - base[2];
  if (vy > speedLimit || vy < -speedLimit) her[3] = (vy > 0 ? speedLimit : -speedLimit) - base[3];
  if (s[LINE] === NONE) return;
  const steep = s[LINE_STEEP] === 1;
  ontoLine(steep, s[LINE_SLOPE], her, 0);
  if (s[LINE] === FAST && recoil) ontoLine(steep, s[LINE_SLOPE], base, 0);
}

/**
 * Writes her box's direction after `t` to `m.facing`; if the box turns, also `m.her` and `m.base` as {@link placeAt} gives
 * them.
 */
export function directionAt(m: Motion, t: number): void {
  const { s, her, facing, toTarget } = m;
  facing[0] = s[COS];
  facing[1] = s[SIN];
  if (s[TURN] === TURN_NOT) return;
  placeAt(m, t);
  let dx = -her[0];
  let dy = -her[1];
  let dvx = -her[2];
  let dvy = -her[3];
  if (s[TURN] === TURN_TO_TARGET) {
    lookAt(m, t);
    dx = toTarget[0];
    dy = toTarget[1];
    dvx = toTarget[2];
    dvy = toTarget[3];
  }
  let d = Math.sqrt(dx * dx + dy * dy);
  if (d === 0) {
    // in the very centre: the direction that she has as soon as she has left it
    dx = dvx;
    dy = dvy;
    d = Math.sqrt(dx * dx + dy * dy);
  }
  facing[0] = d > 0 ? dx / d : s[COS];
  facing[1] = d > 0 ? dy / d : s[SIN];
}

/** Writes the states of her and, with recoil, of the base after `t` to `m.her` and `m.base`, as the polynomial gives them. */
export function placeAt(m: Motion, t: number): void {
  const { s } = m;
  pairAt(m.ux, m.uy, s[DEGREE], t, m.her, 0);
  if (m.recoil) pairAt(m.px, m.py, s[DEGREE], t, m.base, 0);
}

/** Writes place (relative to the origin) and velocity of a target after `t` to out[0..3]. */
export function rockAt(m: Motion, i: number, t: number, out: Float64Array): void {
  const { s } = m;
  if (!m.recoil) {
    out[0] = m.targetX[i];
    out[1] = m.targetY[i];
    out[2] = 0;
    out[3] = 0;
    return;
  }
  const dragged = m.chaserX.length - 1;
  if (i === s[BASE]) {
    pairAt(m.px, m.py, s[DEGREE], t, out, 0);
    out[0] += s[BASE_X];
    out[1] += s[BASE_Y];
  } else if (i === s[TARGET] && s[m.chasers + CHASER * dragged + 4] === AWAKE) {
    pairAt(m.chaserX[dragged], m.chaserY[dragged], m.integrator.degree, t, out, 0);
  } else {
    const o = m.rocks + ROCK * i;
    out[0] = s[o] + s[o + 2] * t;
    out[1] = s[o + 1] + s[o + 3] * t;
    out[2] = s[o + 2];
    out[3] = s[o + 3];
  }
}

/** Writes the vector from her to the target after `t` to `m.toTarget`; `m.her` must hold her place. */
export function lookAt(m: Motion, t: number): void {
  const { s, her, toTarget } = m;
  rockAt(m, s[TARGET], t, toTarget);
  toTarget[0] = toTarget[0] - s[BASE_X] - her[0];
  toTarget[1] = toTarget[1] - s[BASE_Y] - her[1];
  toTarget[2] -= her[2];
  toTarget[3] -= her[3];
}

/** Writes place (relative to the origin) and velocity of a chaser after `t` to out[0..3]. */
export function chaserPlaceAt(m: Motion, i: number, t: number, out: Float64Array): void {
  const { s } = m;
  const o = m.chasers + CHASER * i;
  if (s[o + 4] === AWAKE) {
    pairAt(m.chaserX[i], m.chaserY[i], m.integrator.degree, t, out, 0);
    return;
  }
  out[0] = s[o];
  out[1] = s[o + 1];
  out[2] = 0;
  out[3] = 0;
}
