import fc from 'fast-check';
import { type Circle, type Hold, type Level, NO_OBJECTS } from '../../schema/index.ts';
import { someRules } from './some-rules.ts';

const whole = (min: number, max: number) => fc.integer({ min, max });
const circle = (reach: number, radii: readonly number[]): fc.Arbitrary<Circle> =>
  fc
    .tuple(whole(-reach, reach), whole(-reach, reach), fc.constantFrom(...radii))
    .map(([x, y, radius]) => ({ id: null, x, y, radius }));

/**
 * A small level in which nearly everything is near, so that proofs and completing runs are both common and differ by a few px.
 * In half of them she rests at the start; with and without recoil, fields and aliens.
 */
export const crowdedLevel: fc.Arbitrary<Level> = whole(60, 260).chain((reach) =>
  fc
    .record({
      name: fc.constant('crowded'),
      description: fc.constant(''),
      astronaut: fc.oneof(
        fc.constant({ x: 0, y: 0, vx: 0, vy: 0 }),
        fc.tuple(whole(-80, 80), whole(-80, 80)).map(([vx, vy]) => ({ x: 0, y: 0, vx, vy })),
      ),
      blackHole: circle(reach, [18, 10, 40]),
      range: fc.oneof(fc.constant(250), whole(80, 300)),
      recoil: fc.boolean(),
      asteroids: fc.array(
        fc.tuple(circle(reach, [16, 32]), fc.integer({ min: 0, max: 3 })).map(([c, n]) => ({ ...c, hot: n === 0 })),
        { minLength: 1, maxLength: 4 },
      ),
      novae: fc.array(circle(reach, [16, 32]), { maxLength: 8 }),
      repulsors: fc.oneof(fc.constant([]), fc.array(circle(reach, [32, 48]), { maxLength: 2 })),
      aliens: fc.oneof(fc.constant([]), fc.array(circle(reach, [25]), { maxLength: 2 })),
      minerals: fc.array(circle(reach, [7]), { maxLength: 5 }),
      runs: fc.constant([]),
    })
    .map((objects): Level => ({ ...NO_OBJECTS, ...objects })),
);

/** Some presses within 15 s. */
export const someHolds: fc.Arbitrary<Hold[]> = fc.array(
  fc.tuple(whole(0, 900), whole(1, 240)).map(([press, length]): Hold => [press, press + length]),
  { maxLength: 5 },
);

const strength = fc.oneof(fc.constant(0), whole(-100, 100));

/** The same with winds and wormholes, which may lie over each other, over her and over everything else. */
export const windyLevel: fc.Arbitrary<Level> = crowdedLevel.chain((level) =>
  fc
    .record({
      winds: fc.array(
        fc.tuple(circle(260, [20, 60, 150]), strength, strength).map(([c, ax, ay]) => ({ ...c, ax, ay })),
        { maxLength: 3 },
      ),
      wormholes: fc.array(
        fc.tuple(circle(260, [8, 24, 50]), whole(-260, 260), whole(-260, 260)).map(([c, toX, toY]) => ({ ...c, toX, toY })),
        { maxLength: 2 },
      ),
    })
    .map((more) => ({ ...level, ...more })),
);

/** Any of these levels, under the original's rules or any others. */
export const anyLevel: fc.Arbitrary<Level> = fc.oneof(
  { weight: 2, arbitrary: crowdedLevel },
  { weight: 1, arbitrary: windyLevel },
  {
    weight: 2,
    arbitrary: fc.tuple(fc.oneof(crowdedLevel, windyLevel), someRules).map(([level, rules]) => ({ ...level, rules })),
  },
);
