import { boxCircleGap } from '../../engine/index.ts';
import { type Circle, objectName } from '../../schema/basics/index.ts';
import type { About, Proof, ThingRef } from './proof.ts';
import { distance, margin, surelyLess } from './rounding.ts';
import { px, subject, thing } from './say.ts';
import { ALL_ACCURACIES, CONTINUOUS, exitOf, mouthDiscs, type Setting, type Thing } from './setting.ts';

const START = { x: 0, y: 0 };

/**
 * `nothing-in-range`: no asteroid is in range of the start, so she is lost at time 0, before any input counts. The checker
 * measures the same distances with the level alone. Rests on the lemmas `reach` and `order`.
 */
export function proveNothingInRange(setting: Setting, about: About, goal: Thing): Proof | null {
  const { level } = setting;
  const { astronaut, asteroids, range } = level;
  const away = asteroids.map((a) => distance(a, astronaut));
  // An object that she touches at time 0 counts before she is lost.
  if (!away.every((d) => surelyLess(range, d)) || !surelyLess(goal.touch, distance(goal, START))) return null;
  const where =
    asteroids.length === 0
      ? 'the level has no asteroid'
      : `the nearest asteroid is ${px(away.reduce((a, b) => Math.min(a, b)))} away`;
  return {
    code: 'nothing-in-range',
    about,
    reason:
      `no asteroid is in range of the start: she is lost when she is farther than ${px(range)} from every asteroid, and ${where}; ` +
      `so the run is over as it begins, and she never touches ${subject(about)}: put an asteroid within ${px(range)} of the start, or move the start`,
    covers: ALL_ACCURACIES,
    maxTime: null,
    certificate: { kind: 'nothing-in-range' },
  };
}

/**
 * `starts-in-hazard`: her box overlaps a hazard at time 0. The witness is that hazard. `arcade` is covered only where the
 * hazard overlaps her box at any angle and the object is not touched, because a press in the first frame turns the box and
 * `arcade` tests the black hole before hazards. Rests on the lemmas `reach`, `order` and `upright`.
 */
export function proveStartsInHazard(setting: Setting, about: About, goal: Thing): Proof | null {
  const hazard = hazardAtStart(setting);
  if (hazard === null) return null;
  const clear = surelyLess(goal.touch, distance(goal, START));
  // A mineral that she touches in the instant of the end still counts; the black hole counts only in `arcade`.
  if (!clear && about.kind === 'mineral') return null;
  return {
    code: 'starts-in-hazard',
    about,
    reason: `the run is over as it begins: at the start her collision box overlaps ${thing(hazard.ref)}: move the start or ${thing(hazard.ref)}`,
    covers: clear && hazard.anyTurn ? ALL_ACCURACIES : CONTINUOUS,
    maxTime: null,
    certificate: { kind: 'starts-in-hazard', hazard: hazard.ref },
  };
}

interface HazardAtStart {
  readonly ref: ThingRef;
  /** Whether it overlaps her box at any angle. */
  readonly anyTurn: boolean;
}

function hazardAtStart({ level: { astronaut, novae, asteroids, aliens }, box, leastHalf }: Setting): HazardAtStart | null {
  const overlaps = (kind: ThingRef['kind'], list: readonly Circle[]): HazardAtStart[] =>
    list.flatMap(({ x, y, radius }, index) => {
      const dx = x - astronaut.x;
      const dy = y - astronaut.y;
      const slack = margin(dx, dy) + margin(radius, 0);
      if (boxCircleGap(box, dx, dy, 1, 0, radius) > -slack) return [];
      return [{ ref: { kind, index }, anyTurn: Math.sqrt(dx * dx + dy * dy) < radius + leastHalf - slack }];
    });
  const hot = overlaps('asteroid', asteroids).filter(({ ref }) => asteroids[ref.index].hot);
  const all = [...overlaps('nova', novae), ...hot, ...overlaps('alien', aliens)];
  return all.find(({ anyTurn }) => anyTurn) ?? all[0] ?? null;
}

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
