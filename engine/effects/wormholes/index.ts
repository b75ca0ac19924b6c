import type { Level } from '../../../schema/basics/index.ts';
import { TICK } from '../../constants.ts';
import { eventRule, listRims, quietAtRim } from '../../events/index.ts';
import type { FrameRule } from '../../frames.ts';
import { circlesOf, type IndexedCircles, type Indexing, indexed } from '../../indexed-circles.ts';
import { GOES_ON, type Motion, moveBy, SLOTS } from '../../motion/index.ts';
import type { Scene } from '../../scene.ts';
import { type EngineEffect, whereAny } from '../effect.ts';
import { countCrossing, offerCrossing, roundingOnRim } from '../rims.ts';

/** All mouths of a scene, as discs: the mouth of wormhole `w` at (x, y) is disc 2 w, the one at (toX, toY) is disc 2 w + 1. */
function mouthsOf(level: Level, indexing: Indexing): IndexedCircles {
  const discs = level.wormholes.flatMap(({ x, y, toX, toY, radius }) => [
    { x, y, radius },
    { x: toX, y: toY, radius },
  ]);
  return indexed(circlesOf(discs, [...discs.keys()]), indexing);
}

/** The mouths that `prepare` made for a compiled scene. */
const preparedMouths = (scene: Scene): IndexedCircles => scene.own.wormholes as IndexedCircles;

/** The other mouth of the same wormhole. */
const otherMouth = (mouth: number): number => mouth ^ 1;

/** State of a wormhole that is open: neither of its mouths counts as containing her. */
const OPEN = 0;

/** State of a wormhole while she is in a mouth, so that it does not fire. */
const inMouth = (mouth: number): number => 1 + (mouth & 1);

/** Margin of a place on a rim in addition to the rounding of coordinates, px: the rounding of the time at which she came there. */
const LATE = 1e-12;

/** Relative rounding of a place on a rim: it was computed from both mouths and from the way to the first. */
const ROUNDING = 1e-14;

/**
 * State of a wormhole for her place, if she came there other than by her own motion or has just been in a mouth of it.
 * @param originX - x of the origin that the place is relative to, px
 * @param originY - y of that origin, px
 * @param late - how far from a rim she may be and still count as inside, in addition to rounding, px; null if only what contains
 * her counts. A wormhole puts her on the rim of its other mouth, and other mouths may have the same rim
 */
function stateAt(
  { x, y, r }: IndexedCircles,
  wormhole: number,
  atX: number,
  atY: number,
  originX: number,
  originY: number,
  late: number | null,
): number {
  for (let mouth = 2 * wormhole; mouth <= 2 * wormhole + 1; mouth++) {
    const cx = x[mouth] - originX;
    const cy = y[mouth] - originY;
    const far = Math.abs(cx) + Math.abs(cy) + Math.abs(atX) + Math.abs(atY) + r[mouth];
    const within = r[mouth] + (late === null ? 0 : late + LATE + ROUNDING * far);
    if ((atX - cx) * (atX - cx) + (atY - cy) * (atY - cy) < within * within) return inMouth(mouth);
  }
  return OPEN;
}

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
const enterMouth = eventRule({
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
const leaveMouth = eventRule({
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
const startInMouths = (m: Motion): void => stayPut(m, null);

/** She was moved to a place: no mouth that contains it, or on whose rim it is, fires now. */
const arriveInMouths = (m: Motion): void => stayPut(m, 0);

/** @param late - as for {@link stateAt} */
function stayPut(m: Motion, late: number | null): void {
  const mouths = preparedMouths(m.scene);
  const { s, ux, uy, originX, originY } = m;
  for (let w = 0; 2 * w < mouths.count; w++) {
    s[m.own.wormholes + w] = stateAt(mouths, w, s[BASE_X] + ux[0], s[BASE_Y] + uy[0], originX, originY, late);
  }
}

/** Wormholes in frames: while her centre is inside a mouth of an open one, she is moved at the end of the frame. */
const wormholeFrame: FrameRule = {
  discs: preparedMouths,
  stateLength: (scene) => preparedMouths(scene).count / 2,
  layOut(scene, s, at) {
    const mouths = preparedMouths(scene);
    const { x, y } = scene.level.astronaut;
    for (let w = 0; 2 * w < mouths.count; w++) s[at + w] = stateAt(mouths, w, x, y, 0, 0, null);
  },
  isBusy(scene, s, at) {
    const count = preparedMouths(scene).count / 2;
    for (let w = 0; w < count; w++) if (s[at + w] !== OPEN) return true;
    return false;
  },
  act(frame, near, at) {
    const { scene, s } = frame;
    const mouths = preparedMouths(scene);
    const { x, y } = frame;
    for (let w = 0; 2 * w < mouths.count; w++) if (s[at + w] !== OPEN) s[at + w] = stateAt(mouths, w, x, y, 0, 0, null);
    for (const mouth of near) {
      const w = mouth >> 1;
      if (s[at + w] !== OPEN) continue;
      const dx = x - mouths.x[mouth];
      const dy = y - mouths.y[mouth];
      if (!(dx * dx + dy * dy < mouths.r[mouth] * mouths.r[mouth])) continue;
      const exit = otherMouth(mouth);
      frame.x += mouths.x[exit] - mouths.x[mouth];
      frame.y += mouths.y[exit] - mouths.y[mouth];
      for (let other = 0; 2 * other < mouths.count; other++) s[at + other] = stateAt(mouths, other, frame.x, frame.y, 0, 0, 0);
      s[at + w] = inMouth(exit);
      frame.tell?.({ time: frame.number * TICK, type: 'effect', effect: 'wormholes', what: 'jump', index: w });
      return;
    }
  },
};

export const wormholes: EngineEffect = {
  name: 'wormholes',
  summary: () => 'when her centre enters one mouth, she goes on from the other, with her velocity and angle',
  calledFor: whereAny('wormholes', 'wormhole'),
  jumps: true,
  tells: { jump: (index) => `goes through wormhole ${index + 1}` },
  prepare: mouthsOf,
  circles: preparedMouths,
  frame: wormholeFrame,
  events: [enterMouth, leaveMouth],
  stateLength: ({ level }) => level.wormholes.length,
  layOut: startInMouths,
  moved: arriveInMouths,
};
