import type { Level } from '../../../schema/basics/index.ts';
import { TICK } from '../../constants.ts';
import { eventRule, listRims, quietAtRim } from '../../events/index.ts';
import type { Frame, FrameRule } from '../../frames.ts';
import { circlesOf, type IndexedCircles, type Indexing, indexed } from '../../indexed-circles.ts';
import { GOES_ON, type Motion, SLOTS, type SteadyForce } from '../../motion/index.ts';
import type { Scene } from '../../scene.ts';
import { type EngineEffect, whereAny } from '../effect.ts';
import { countCrossing, ENTERING, OUTSIDE, offerCrossing, placeInCircle } from '../rims.ts';

/** The winds of a scene: discs, and the acceleration in each, px/s². */
interface Winds extends IndexedCircles {
  readonly ax: Float64Array;
  readonly ay: Float64Array;
}

function windsOf({ winds }: Level, indexing: Indexing): Winds {
  const { count, x, y, r, index, spatial } = indexed(circlesOf(winds, [...winds.keys()]), indexing);
  return { count, x, y, r, index, spatial, ax: Float64Array.from(winds, (w) => w.ax), ay: Float64Array.from(winds, (w) => w.ay) };
}

/** The winds that `prepare` made for a compiled scene. */
const preparedWinds = (scene: Scene): Winds => scene.own.winds as Winds;

/** Upper bound of her acceleration by winds, px/s²: that of all together, since discs may overlap. */
const strongestWind = ({ winds }: Level): number => winds.reduce((sum, { ax, ay }) => sum + Math.sqrt(ax * ax + ay * ay), 0);

const { LAST_EVENT, LAST_A } = SLOTS;

/** Length of the state: the number of winds that blow on her, then a flag for each wind. */
const stateLength = ({ level }: { readonly level: { readonly winds: readonly unknown[] } }): number => 1 + level.winds.length;

const blows = (m: Motion, i: number): boolean => m.s[m.own.winds + 1 + i] === 1;

function set(m: Motion, i: number, isInside: boolean): void {
  if (blows(m, i) === isInside) return;
  m.s[m.own.winds + 1 + i] = isInside ? 1 : 0;
  m.s[m.own.winds] += isInside ? 1 : -1;
}

/** The sum of the winds that blow on her. */
const wind: SteadyForce = {
  acts: 'beside',
  strongest: strongestWind,
  add(m) {
    const { flow } = m;
    let left = m.s[m.own.winds];
    if (left === 0) return;
    const { ax, ay } = preparedWinds(m.scene);
    let x = flow.steadyX;
    let y = flow.steadyY;
    for (let i = 0; left > 0; i++) {
      if (!blows(m, i)) continue;
      x += ax[i];
      y += ay[i];
      left--;
    }
    flow.setSteady(x, y);
  },
};

/** Her centre enters a wind. An entry in the neighbour list stands for leaving the wind if she is in it. */
const enterWind = eventRule({
  name: 'wind',
  list: (m) => listRims(m, enterWind, preparedWinds(m.scene)),
  guard: (m, i, from) => offerCrossing(m, preparedWinds(m.scene), i, blows(m, i), enterWind, leaveWind, from, false),
  quiet: (m, i, time) => quietAtRim(m, preparedWinds(m.scene), i, blows(m, i), time),
  fire: (m, i, _b, time) => cross(m, i, true, time),
});

/** Her centre leaves a wind. */
const leaveWind = eventRule({
  name: 'lull',
  fire: (m, i, _b, time) => cross(m, i, false, time),
});

function cross(m: Motion, i: number, entering: boolean, time: number): number {
  const { s } = m;
  countCrossing(m, time);
  set(m, i, entering);
  s[LAST_EVENT] = entering ? leaveWind.kind : enterWind.kind;
  s[LAST_A] = i;
  m.recorder?.event({ time, type: 'effect', effect: 'winds', what: entering ? 'enter' : 'leave', index: i });
  return GOES_ON;
}

/**
 * Determines the winds at her place after she came there other than by her own motion.
 * @param time - time of the events that report changed winds, s; null at the start, where only what she enters then is reported
 */
function feelWinds(m: Motion, time: number | null): void {
  const winds = preparedWinds(m.scene);
  for (let i = 0; i < winds.count; i++) {
    const place = placeInCircle(m, winds, i);
    const isInside = place !== OUTSIDE;
    if (isInside === blows(m, i)) continue;
    set(m, i, isInside);
    if (time === null && place !== ENTERING) continue;
    const what = isInside ? 'enter' : 'leave';
    m.recorder?.event({ time: time ?? 0, type: 'effect', effect: 'winds', what, index: i });
  }
}

/** Winds in frames: while her centre is inside one, its acceleration is added to everything else that acts. */
const windFrame: FrameRule = {
  discs: preparedWinds,
  stateLength: (scene) => preparedWinds(scene).count,
  layOut(scene, s, at) {
    const winds = preparedWinds(scene);
    const { x, y } = scene.level.astronaut;
    for (let i = 0; i < winds.count; i++) s[at + i] = isInside(winds, i, x, y) ? 1 : 0;
  },
  isBusy(scene, s, at) {
    const { count } = preparedWinds(scene);
    for (let i = 0; i < count; i++) if (s[at + i] === 1) return true;
    return false;
  },
  act(frame, near, at) {
    const { scene, s, x, y } = frame;
    const winds = preparedWinds(scene);
    for (let i = 0; i < winds.count; i++) {
      if (s[at + i] === 0 || isInside(winds, i, x, y)) continue;
      s[at + i] = 0;
      tell(frame, 'leave', i);
    }
    for (let k = 0; k < near.length; k++) {
      const i = near[k];
      if (!isInside(winds, i, x, y)) continue;
      frame.ax += winds.ax[i];
      frame.ay += winds.ay[i];
      if (s[at + i] === 1) continue;
      s[at + i] = 1;
      tell(frame, 'enter', i);
    }
  },
};

const tell = (frame: Frame, what: string, index: number): void =>
  frame.tell?.({ time: frame.number * TICK, type: 'effect', effect: 'winds', what, index });

function isInside({ x, y, r }: ReturnType<typeof preparedWinds>, i: number, hersX: number, hersY: number): boolean {
  const dx = hersX - x[i];
  const dy = hersY - y[i];
  return dx * dx + dy * dy < r[i] * r[i];
}

export const winds: EngineEffect = {
  name: 'winds',
  summary: () => 'a steady acceleration while her centre is inside, added to whatever else acts on her',
  calledFor: whereAny('winds', 'wind'),
  force: wind,
  tells: {
    enter: (index) => `enters wind ${index + 1}`,
    leave: (index) => `leaves wind ${index + 1}`,
  },
  prepare: windsOf,
  circles: preparedWinds,
  frame: windFrame,
  events: [enterWind, leaveWind],
  stateLength,
  layOut: (m) => feelWinds(m, null),
  moved: feelWinds,
};
