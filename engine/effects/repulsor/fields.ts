import { eventRule, listRims, offer, quietAtRim } from '../../events/index.ts';
import { GOES_ON, type Motion, RECORDS, SLIDE, SLOTS } from '../../motion/index.ts';
import { SHORTEST_BOUNCE } from '../../tolerances.ts';
import { countCrossing, ENTERING, OUTSIDE, offerCrossing, placeInCircle, roundingOnRim } from '../rims.ts';
import { rimOf } from './slide.ts';
import { comeOffTime } from './slide-ends.ts';

const { FIELD, START, KIND, BASE_X, BASE_Y, RIM, LAST_EVENT, LAST_A, HELD, TARGET, LIMIT_X, LIMIT_Y, OUTER } = SLOTS;
const { ROCK } = RECORDS;

/** Flags the repulsors that contain her at the start. */
export function enterFields(m: Motion): void {
  const { s, scene, recorder } = m;
  const { repulsors } = scene;
  for (let i = 0; i < repulsors.count; i++) {
    const place = placeInCircle(m, repulsors, i);
    s[m.own.repulsor + i] = place === OUTSIDE ? 0 : 1;
    if (place === ENTERING) recorder?.event({ time: 0, type: 'enter', index: repulsors.index[i] });
  }
  s[FIELD] = actingField(m);
}

/** She was moved: she may have left fields and be in others. */
export function changeFields(m: Motion, time: number): void {
  const { s, scene } = m;
  const { repulsors } = scene;
  for (let i = 0; i < repulsors.count; i++) {
    const inside = placeInCircle(m, repulsors, i) === OUTSIDE ? 0 : 1;
    if (s[m.own.repulsor + i] === inside) continue;
    s[m.own.repulsor + i] = inside;
    m.recorder?.event({ time, type: inside === 1 ? 'enter' : 'leave', index: repulsors.index[i] });
  }
  s[FIELD] = actingField(m);
}

/** The first repulsor that contains her; -1 if there is none. */
function actingField(m: Motion): number {
  for (let i = 0; i < m.scene.repulsors.count; i++) if (m.s[m.own.repulsor + i] === 1) return i;
  return -1;
}

/** Her centre enters a field. An entry in the neighbour list stands for leaving the field if she is inside. */
export const enterField = eventRule({
  name: 'enter',
  list: (m) => listRims(m, enterField, m.scene.repulsors),
  guard(m, i, from) {
    if (m.s[RIM] === i) return;
    offerCrossing(m, m.scene.repulsors, i, m.s[m.own.repulsor + i] === 1, enterField, leaveField, from, false);
  },
  quiet: (m, i, time) => quietAtRim(m, m.scene.repulsors, i, m.s[m.own.repulsor + i] === 1, time),
  fire: (m, i, _b, time) => cross(m, i, true, time),
});

/** Her centre leaves a field. */
export const leaveField = eventRule({
  name: 'leave',
  fire: (m, i, _b, time) => cross(m, i, false, time),
});

function cross(m: Motion, i: number, entering: boolean, time: number): number {
  const { s } = m;
  countCrossing(m, time);
  // while she slides on the rim she counts as inside
  s[m.own.repulsor + i] = 1;
  if (beginsToSlide(m, i) && !entering) return GOES_ON;
  s[m.own.repulsor + i] = entering ? 1 : 0;
  s[FIELD] = actingField(m);
  s[LAST_EVENT] = entering ? leaveField.kind : enterField.kind;
  s[LAST_A] = i;
  m.recorder?.event({ time, type: entering ? 'enter' : 'leave', index: m.scene.repulsors.index[i] });
  return GOES_ON;
}

/** She comes off the rim of a field that she slides along. */
export const comeOffRim = eventRule({
  name: 'come off',
  first(m, from) {
    // later events cannot happen on this slide
    if (m.s[KIND] === SLIDE) offer(m, comeOffTime(m, from), comeOffRim.kind, 0, 0);
  },
  fire(m) {
    comeOff(m);
    return GOES_ON;
  },
});

/** At the start of a piece: she stays on the rim, or comes off it if nothing holds her any more. */
export function followRim(m: Motion): void {
  const { s } = m;
  const field = s[RIM];
  if (holdsOnRim(m, field)) return;
  if (s[FIELD] === field) comeOff(m);
  else s[RIM] = -1;
}

/** She leaves the field outwards. */
function comeOff(m: Motion): void {
  const { s, ux, uy, scene } = m;
  const field = s[RIM];
  const cx = scene.repulsors.x[field] - m.originX;
  const cy = scene.repulsors.y[field] - m.originY;
  const x = s[BASE_X] + ux[0] - cx;
  const y = s[BASE_Y] + uy[0] - cy;
  const r = Math.sqrt(x * x + y * y);
  // far enough from the rim that rounding cannot cause another crossing
  const wanted =
    (scene.repulsors.r[field] + roundingOnRim(m, scene.repulsors.x[field], scene.repulsors.y[field], scene.repulsors.r[field])) /
    r;
  ux[0] += x * wanted - x;
  uy[0] += y * wanted - y;
  s[m.own.repulsor + field] = 0;
  s[FIELD] = actingField(m);
  s[RIM] = -1;
  s[LAST_EVENT] = enterField.kind;
  s[LAST_A] = field;
  m.recorder?.event({ time: s[START], type: 'leave', index: scene.repulsors.index[field] });
}

/** This near to its centre the force outside has no reliable direction, px. */
const NO_DIRECTION = 1e-7;

/** Sets the flow of the rim that she slides along from the state at the start of the piece. */
export function setRim(m: Motion): void {
  aim(m, m.s[RIM], m.s[OUTER]);
}

function aim(m: Motion, field: number, outer: number): void {
  const { s, scene } = m;
  const rim = rimOf(m);
  const { repulsors } = scene;
  const cx = repulsors.x[field] - m.originX;
  const cy = repulsors.y[field] - m.originY;
  rim.radius = repulsors.r[field];
  rim.push = m.rules.push;
  rim.freeX = s[LIMIT_X] === 0;
  rim.freeY = s[LIMIT_Y] === 0;
  rim.qvx = rim.qvy = rim.kappa = 0;
  if (outer >= 0) {
    rim.alpha = m.rules.push;
    rim.beta = 0;
    rim.qx = repulsors.x[outer] - m.originX - cx;
    rim.qy = repulsors.y[outer] - m.originY - cy;
    return;
  }
  rim.alpha = -m.rules.pull;
  rim.beta = m.rules.pull / scene.level.range;
  const target = s[TARGET];
  if (m.recoil) {
    const o = m.rocks + ROCK * target;
    rim.qx = s[o] - cx;
    rim.qy = s[o + 1] - cy;
    rim.qvx = s[o + 2];
    rim.qvy = s[o + 3];
    rim.kappa = m.kappa;
  } else {
    rim.qx = m.targetX[target] - cx;
    rim.qy = m.targetY[target] - cy;
  }
}

/** The first field besides this one that contains her; -1 if there is none. */
function fieldBeside(m: Motion, field: number): number {
  for (let i = 0; i < m.scene.repulsors.count; i++) if (i !== field && m.s[m.own.repulsor + i] === 1) return i;
  return -1;
}

/**
 * Whether she is held on the rim of a field that contains her: it must be the field that acts inside, and from outside she must
 * be driven in more strongly than she flies out. Leaves the forces in the rim's flow.
 */
function holdsOnRim(m: Motion, field: number): boolean {
  const { s, ux, uy, px, py, scene } = m;
  const rim = rimOf(m);
  // under a steady force she bounces instead; see rimTolerance
  if (actingField(m) !== field || m.flow.isSteady) return false;
  const outer = fieldBeside(m, field);
  if (outer < 0 && (s[HELD] === 0 || s[TARGET] < 0)) return false;
  s[OUTER] = outer;
  aim(m, field, outer);
  const x = s[BASE_X] + ux[0] - (scene.repulsors.x[field] - m.originX);
  const y = s[BASE_Y] + uy[0] - (scene.repulsors.y[field] - m.originY);
  const wx = x - rim.qx;
  const wy = y - rim.qy;
  if (wx * wx + wy * wy < NO_DIRECTION * NO_DIRECTION) return false;
  rim.weigh(x, y, ux[1] + px[1], uy[1] + py[1], wx, wy);
  return rim.pressesIn > 0;
}

/**
 * Whether she begins to slide as she crosses the rim of a field that contains her. Where the force outside drives her in and
 * the push drives her out, she bounces on the rim endlessly, and her bounces keep their height; at rest across the rim she
 * slides along it. A bounce has a mean velocity along the rim, with which she goes on.
 */
function beginsToSlide(m: Motion, field: number): boolean {
  const { s, ux, uy, px, py, scene } = m;
  const rim = rimOf(m);
  const { repulsors } = scene;
  const x = s[BASE_X] + ux[0] - (repulsors.x[field] - m.originX);
  const y = s[BASE_Y] + uy[0] - (repulsors.y[field] - m.originY);
  const r = Math.sqrt(x * x + y * y);
  const across = (x * (ux[1] + px[1]) + y * (uy[1] + py[1])) / r;
  // at this speed across the rim a bounce takes too long, however strongly she is pressed back
  if (Math.abs(across) > (SHORTEST_BOUNCE * 5 * m.rules.push) / 2) return false;
  if (!holdsOnRim(m, field)) return false;
  const { pressesIn, pressesOut } = rim;
  if (2 * Math.abs(across) * (1 / pressesIn + 1 / pressesOut) > SHORTEST_BOUNCE) return false;
  if (rim.freeX && rim.freeY) {
    const nx = x / r;
    const ny = y / r;
    const outside = rim.forceX * nx + rim.forceY * ny;
    // she is faster than the mean as she comes in and slower as she goes out, by half of what the force outside adds in its
    // share of the time
    const gain = across / (pressesIn + pressesOut);
    ux[1] += gain * (rim.forceX - outside * nx) - across * nx;
    uy[1] += gain * (rim.forceY - outside * ny) - across * ny;
  }
  s[RIM] = field;
  return true;
}
