import { eventRule, listRims, quietAtRim } from '../../events/index.ts';
import { GOES_ON, type Motion, SLOTS, type SteadyForce } from '../../motion/index.ts';
import { countCrossing, ENTERING, OUTSIDE, offerCrossing, placeInCircle } from '../rims/index.ts';
import { preparedWinds, strongestWind } from './discs.ts';

const { LAST_EVENT, LAST_A } = SLOTS;

/** Length of the state: the number of winds that blow on her, then a flag for each wind. */
export const stateLength = ({ level }: { readonly level: { readonly winds: readonly unknown[] } }): number =>
  1 + level.winds.length;

const blows = (m: Motion, i: number): boolean => m.s[m.own.winds + 1 + i] === 1;

function set(m: Motion, i: number, isInside: boolean): void {
  if (blows(m, i) === isInside) return;
  m.s[m.own.winds + 1 + i] = isInside ? 1 : 0;
  m.s[m.own.winds] += isInside ? 1 : -1;
}

/** The sum of the winds that blow on her. */
export const wind: SteadyForce = {
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
export const enterWind = eventRule({
  name: 'wind',
  list: (m) => listRims(m, enterWind, preparedWinds(m.scene)),
  guard: (m, i, from) => offerCrossing(m, preparedWinds(m.scene), i, blows(m, i), enterWind, leaveWind, from, false),
  quiet: (m, i, time) => quietAtRim(m, preparedWinds(m.scene), i, blows(m, i), time),
  fire: (m, i, _b, time) => cross(m, i, true, time),
});

/** Her centre leaves a wind. */
export const leaveWind = eventRule({
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
export function feelWinds(m: Motion, time: number | null): void {
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
