import { eventRule, listRims, quietAtRim } from '../../events/index.ts';
import { GOES_ON, type Motion, moveBy, SLOTS } from '../../motion/index.ts';
import { countCrossing, offerCrossing, roundingOnRim } from '../rims/index.ts';
import { inMouth, OPEN, otherMouth, preparedMouths, stateAt } from './mouths.ts';

const { BASE_X, BASE_Y, LAST_EVENT, LAST_A } = SLOTS;

/** Index in the state of a mouth's wormhole. */
const slotOf = (m: Motion, mouth: number): number => m.own.wormholes + (mouth >> 1);

/** Whether crossing a mouth's rim has an effect now: entering it if the wormhole is open, leaving it if she is in it. */
const matters = (m: Motion, mouth: number): boolean => {
  const state = m.s[slotOf(m, mouth)];
  return state === OPEN || state === inMouth(mouth);
};

/**
 * Her centre enters a mouth of an open wormhole. An entry in the neighbour list stands for leaving the mouth if she is in it.
 */
export const enterMouth = eventRule({
  name: 'wormhole',
  list: (m) => listRims(m, enterMouth, preparedMouths(m.scene)),
  isOver: (m, mouth) => !matters(m, mouth),
  guard(m, mouth, from) {
    if (!matters(m, mouth)) return;
    offerCrossing(m, preparedMouths(m.scene), mouth, m.s[slotOf(m, mouth)] !== OPEN, enterMouth, leaveMouth, from, true);
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
    // fixed steps, or a chatter between rims, may have put her beside the rim
    const late = Math.abs(depthIn(m, mouth));
    moveBy(m, x[exit] - x[mouth], y[exit] - y[mouth], time);
    stayPut(m, late);
    s[slotOf(m, mouth)] = inMouth(exit);
    s[LAST_EVENT] = leaveMouth.kind;
    s[LAST_A] = exit;
    return GOES_ON;
  },
});

/** Her centre leaves the mouth that she is in. The wormhole is open again, unless she is then in its other mouth. */
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

/** Whether she is in a mouth and stays in it; on its very rim her direction decides. */
function goesOnIn(m: Motion, mouth: number): boolean {
  const { s, ux, uy, px, py } = m;
  const { x, y, r } = preparedMouths(m.scene);
  const dx = s[BASE_X] + ux[0] - (x[mouth] - m.originX);
  const dy = s[BASE_Y] + uy[0] - (y[mouth] - m.originY);
  const depth = depthIn(m, mouth);
  if (Math.abs(depth) > roundingOnRim(m, x[mouth], y[mouth], r[mouth])) return depth > 0;
  return dx * (ux[1] + px[1]) + dy * (uy[1] + py[1]) < 0;
}

/** How far inside the rim of a mouth she is, px. */
function depthIn(m: Motion, mouth: number): number {
  const { s, ux, uy } = m;
  const { x, y, r } = preparedMouths(m.scene);
  const dx = s[BASE_X] + ux[0] - (x[mouth] - m.originX);
  const dy = s[BASE_Y] + uy[0] - (y[mouth] - m.originY);
  return r[mouth] - Math.sqrt(dx * dx + dy * dy);
}

/** She starts: no mouth that contains her fires now. */
export const startInMouths = (m: Motion): void => stayPut(m, null);

/** She was moved to a place: no mouth that contains it, or on whose rim it is, fires now. */
export const arriveInMouths = (m: Motion): void => stayPut(m, 0);

/** @param late - as for {@link stateAt} */
function stayPut(m: Motion, late: number | null): void {
  const mouths = preparedMouths(m.scene);
  const { s, ux, uy, originX, originY } = m;
  for (let w = 0; 2 * w < mouths.count; w++) {
    s[m.own.wormholes + w] = stateAt(mouths, w, s[BASE_X] + ux[0], s[BASE_Y] + uy[0], originX, originY, late);
  }
}
