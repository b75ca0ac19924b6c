import { boxCircleGap } from '../../engine/index.ts';
import type { Circle } from '../../schema/basics/index.ts';
import type { About, Proof, ThingRef } from './proof.ts';
import { distance, margin, surelyLess } from './rounding.ts';
import { px, subject, thing } from './say.ts';
import { ALL_ACCURACIES, CONTINUOUS, type Setting, type Thing } from './setting.ts';

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
