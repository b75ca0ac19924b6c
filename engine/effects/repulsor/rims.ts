import { eventRule, listRims, offer, quietAtRim } from '../../events/index.ts';
import { GOES_ON, type Motion, SLIDE, SLOTS } from '../../motion/index.ts';
import { countCrossing, offerCrossing, roundingOnRim } from '../rims/index.ts';
import { comeOffTime } from './come-off.ts';
import { actingField } from './fields.ts';
import { beginsToSlide, holdsOnRim } from './slide.ts';

const { START, KIND, FIELD, BASE_X, BASE_Y, RIM, LAST_EVENT, LAST_A } = SLOTS;

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
