import { eventRule, justFired, listRims, offer, quietWithin, rimTime } from '../../events/index.ts';
import { GOES_ON, type Motion, moveBy, placeCircle, SLOTS } from '../../motion/index.ts';
import { SURPLUS } from '../../tolerances.ts';
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
    const { x, y, r } = preparedMouths(m.scene);
    const entering = m.s[slotOf(m, mouth)] === OPEN;
    const { kind } = entering ? enterMouth : leaveMouth;
    placeCircle(m, x[mouth], y[mouth], m.originX, m.originY);
    offer(m, rimTime(m, r[mouth], entering, 0, from, justFired(m, kind, mouth)), kind, mouth, 0);
  },
  quiet(m, mouth, time) {
    if (!matters(m, mouth)) return time;
    const { path } = m;
    const { x, y, r } = preparedMouths(m.scene);
    const dx = path.x + m.originX - x[mouth];
    const dy = path.y + m.originY - y[mouth];
    const d = Math.sqrt(dx * dx + dy * dy);
    const entering = m.s[slotOf(m, mouth)] === OPEN;
    const gap = (entering ? d - r[mouth] : r[mouth] - d) - SURPLUS;
    return quietWithin(m, gap, entering ? (dx * path.vx + dy * path.vy) / d : -path.speed, time);
  },
  fire(m, mouth, _b, time) {
    const { s } = m;
    const { x, y } = preparedMouths(m.scene);
    const exit = otherMouth(mouth);
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
  fire(m, mouth) {
    const { s } = m;
    const { x, y, r } = preparedMouths(m.scene);
    const exit = otherMouth(mouth);
    const dx = placeX(m) - x[exit];
    const dy = placeY(m) - y[exit];
    s[slotOf(m, mouth)] = dx * dx + dy * dy < r[exit] * r[exit] ? inMouth(exit) : OPEN;
    s[LAST_EVENT] = enterMouth.kind;
    s[LAST_A] = mouth;
    return GOES_ON;
  },
});

const placeX = (m: Motion): number => m.originX + m.s[BASE_X] + m.ux[0];
const placeY = (m: Motion): number => m.originY + m.s[BASE_Y] + m.uy[0];

/** She is somewhere without having come there by her own motion: no mouth that she is in now fires. */
export function stayPut(m: Motion): void {
  const mouths = preparedMouths(m.scene);
  for (let w = 0; 2 * w < mouths.count; w++) m.s[m.own.wormholes + w] = stateAt(mouths, w, placeX(m), placeY(m));
}
