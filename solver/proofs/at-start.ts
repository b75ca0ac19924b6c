import { boxCircleGap } from '../../engine/index.ts';
import type { Circle } from '../../schema/index.ts';
import type { About, Proof, ThingRef } from './proof.ts';
import { distance, margin, surelyLess } from './rounding.ts';
import { px, subject, thing } from './say.ts';
import { ALL_ACCURACIES, CONTINUOUS, type Setting, type Thing } from './setting.ts';

const START = { x: 0, y: 0 };

/** No asteroid in range of the start: she is lost at time 0, before she can do anything. */
export function proveNothingInRange(setting: Setting, about: About, goal: Thing): Proof | null {
  const { level } = setting;
  const { astronaut, asteroids, range } = level;
  const away = asteroids.map((a) => distance(a, astronaut));
  // touched in the same instant, the black hole wins
  if (!away.every((d) => surelyLess(range, d)) || !surelyLess(goal.touch, distance(goal, START))) return null;
  const where =
    asteroids.length === 0
      ? 'there is no asteroid at all'
      : `the nearest asteroid is ${px(away.reduce((a, b) => Math.min(a, b)))} away`;
  return {
    code: 'nothing-in-range',
    about,
    reason:
      `no asteroid is in range of the start: she is lost farther than ${px(range)} from every asteroid, and ${where}; ` +
      `so she is lost at once and ${subject(about)} is never touched: put an asteroid within ${px(range)} of the start, or move the start`,
    covers: ALL_ACCURACIES,
    maxTime: null,
    certificate: { kind: 'nothing-in-range' },
  };
}

/** The box as it stands at time 0 overlaps a hazard. `arcade` turns it first where she presses in the first frame, and asks for the black hole before. */
export function proveStartsInHazard(setting: Setting, about: About, goal: Thing): Proof | null {
  const hazard = hazardAtStart(setting);
  if (hazard === null) return null;
  const clear = surelyLess(goal.touch, distance(goal, START));
  // a mineral touched in the instant of the end still counts; the black hole doesn't, but in `arcade`
  if (!clear && about.kind === 'mineral') return null;
  return {
    code: 'starts-in-hazard',
    about,
    reason: `the run is over at once: her box overlaps ${thing(hazard.ref)} as it stands at the start: move the start or ${thing(hazard.ref)}`,
    covers: clear && hazard.anyTurn ? ALL_ACCURACIES : CONTINUOUS,
    maxTime: null,
    certificate: { kind: 'starts-in-hazard', hazard: hazard.ref },
  };
}

interface HazardAtStart {
  readonly ref: ThingRef;
  /** whether it overlaps her box however that is turned */
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
