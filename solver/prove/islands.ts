import { objectName } from '../../schema/basics/index.ts';
import type { About, Proof } from './proof.ts';
import { exitOf, mouthDiscs } from './rims.ts';
import { distance, surelyLess } from './rounding.ts';
import { px, subject } from './say.ts';
import { ALL_ACCURACIES, CONTINUOUS, type Setting, type Thing } from './setting.ts';

/**
 * `out-of-range`: the object is farther than the range plus the reach of her box from every asteroid whose range she can enter.
 * Those asteroids are found by a search over a graph ({@link reachable}): she can pass between two asteroids only if their
 * ranges overlap, where recoil may shift each of them and, in `arcade`, one frame's flight may bridge a gap; wormholes join the
 * discs around their mouths. The certificate lists what is reachable, and the checker tests that the list is closed: nothing
 * outside it can be entered from inside. Rests on the lemmas `way`, `reach`, `jump`, `drift` and `mouths`.
 */
export function proveOutOfRange(setting: Setting, about: About, goal: Thing): Proof | null {
  const { level, drift, jump, maxTime } = setting;
  // An object that she touches at the instant in which she is lost counts.
  if (!surelyLess(goal.touch, distance(goal, { x: 0, y: 0 }))) return null;
  const { asteroids: reached, mouths } = setting.reached;
  let nearest = -1;
  let least = Number.POSITIVE_INFINITY;
  for (const i of reached) {
    const a = level.asteroids[i];
    const d = distance({ x: a.x - level.astronaut.x, y: a.y - level.astronaut.y }, goal);
    const reach = level.range + drift[i] + goal.touch;
    if (!surelyLess(reach, d)) return null;
    if (d >= least) continue;
    least = d;
    nearest = i;
  }
  const discs = mouthDiscs(level);
  for (const mouth of mouths) {
    const { x, y, radius } = discs[exitOf(mouth)];
    const exit = { x: x - level.astronaut.x, y: y - level.astronaut.y };
    if (!surelyLess(radius + jump + goal.touch, distance(exit, goal))) return null;
  }
  const all = reached.length === level.asteroids.length;
  const limit = level.range + goal.touch;
  const whom = all ? 'the nearest asteroid' : 'the nearest asteroid she can reach';
  return {
    code: 'out-of-range',
    about,
    reason:
      nearest < 0
        ? `${subject(about)} is out of reach: no asteroid is in range of the start, so she is lost as the run begins`
        : `${subject(about)} is ${px(least)} from ${whom}, ${objectName('asteroid', nearest)}; she is lost beyond ${px(level.range)}, and her collision box touches it ` +
          `from at most ${px(goal.touch)}: move it, or add an asteroid ${all ? '' : 'that she can reach '}within ${px(limit)} of it`,
    covers: jump > 0 ? ALL_ACCURACIES : CONTINUOUS,
    maxTime: level.recoil ? maxTime : null,
    certificate: { kind: 'out-of-range', asteroids: reached, ...(discs.length > 0 ? { mouths } : {}) },
  };
}
