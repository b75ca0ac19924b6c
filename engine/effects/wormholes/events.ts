import { eventRule, listRims, quietAtRim } from '../../events/index.ts';
import { GOES_ON, type Motion, moveBy, SLOTS } from '../../motion/index.ts';
import { countCrossing, offerCrossing, roundingOnRim } from '../rims/index.ts';
import { inMouth, OPEN, otherMouth, preparedMouths, stateAt } from './mouths.ts';

const { BASE_X, BASE_Y, LAST_EVENT, LAST_A } = SLOTS;

/** Where in the state the one of a mouth's wormhole is. */
const slotOf = (m: Motion, mouth: number): number => m.own.wormholes + (mouth >> 1);

/** Whether crossing a mouth's rim can do anything now: into it where the wormhole is open, out of it where she is in it. */
const matters = (m: Motion, mouth: number): boolean => {
  const state = m.s[slotOf(m, mouth)];
  return state === OPEN || state === inMouth(mouth);
};

/** Her centre comes into a mouth of an open wormhole. What is listed under this is about leaving it where she is in it. */
export const enterMouth = eventRule({
  name: 'wormhole',
  list: (m) => listRims(m, enterMouth, preparedMouths(m.scene)),
  isOver: (m, mouth) => !matters(m, mouth),
  guard(m, mouth, from) {
    if (!matters(m, mouth)) return;
    offerCrossing(m, preparedMouths(m.scene), mouth, m.s[slotOf(m, mouth)] !== OPEN, enterMouth, leaveMouth, from);
  },
  quiet(m, mouth, time) {
    if (!matters(m, mouth)) return time;
    return quietAtRim(m, preparedMouths(m.scene), mouth, m.s[slotOf(m, mouth)] !== OPEN, time);
  },
  fire(m, mouth, _b, time) {
    const { s } = m;
    const { x, y } = preparedMouths(m.scene);
    const exit = otherMouth(mouth);
    countCrossing(m, time);
    m.recorder?.event({ time, type: 'effect', effect: 'wormholes', what: 'jump', index: mouth >> 1 });
    moveBy(m, x[exit] - x[mouth], y[exit] - y[mouth], time);
    s[slotOf(m, mouth)] = inMouth(exit);
    s[LAST_EVENT] = leaveMouth.kind;
    s[LAST_A] = exit;
    return GOES_ON;
  },
});

/** Her centre leaves the mouth that she is in: unless she is in the other one then, the wormhole is open again. */
export const leaveMouth = eventRule({
  name: 'mouth',
  fire(m, mouth, _b, time) {
    const { s } = m;
    countCrossing(m, time);
    const exit = otherMouth(mouth);
    s[slotOf(m, mouth)] = goesOnIn(m, exit) ? inMouth(exit) : OPEN;
    s[LAST_EVENT] = enterMouth.kind;
    s[LAST_A] = mouth;
    return GOES_ON;
  },
});

/** Whether she is in a mouth, and stays there: on its very rim it is her direction that says so. */
function goesOnIn(m: Motion, mouth: number): boolean {
  const { s, ux, uy, px, py } = m;
  const { x, y, r } = preparedMouths(m.scene);
  const dx = s[BASE_X] + ux[0] - (x[mouth] - m.originX);
  const dy = s[BASE_Y] + uy[0] - (y[mouth] - m.originY);
  const depth = r[mouth] - Math.sqrt(dx * dx + dy * dy);
  if (Math.abs(depth) > roundingOnRim(m, x[mouth], y[mouth], r[mouth])) return depth > 0;
  return dx * (ux[1] + px[1]) + dy * (uy[1] + py[1]) < 0;
}

/** She is somewhere without having come there by her own motion: no mouth that she is in now fires. */
export function stayPut(m: Motion): void {
  const mouths = preparedMouths(m.scene);
  const { s, ux, uy, originX, originY } = m;
  for (let w = 0; 2 * w < mouths.count; w++) {
    s[m.own.wormholes + w] = stateAt(mouths, w, s[BASE_X] + ux[0], s[BASE_Y] + uy[0], originX, originY);
  }
}
