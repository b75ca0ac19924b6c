import fc from 'fast-check';
import { type Circle, type Level, NO_OBJECTS } from '../../schema/index.ts';
import { arbitraryRules } from './arbitrary-rules.ts';

type Point = readonly [x: number, y: number];

/** Places that objects share. Steps of 20 px make equal distances, touches and rims through centres frequent. */
const coordinate = fc.oneof(
  { weight: 4, arbitrary: fc.integer({ min: -8, max: 8 }).map((k) => 20 * k) },
  { weight: 2, arbitrary: fc.integer({ min: -160, max: 160 }) },
  { weight: 1, arbitrary: fc.integer({ min: -160_000, max: 160_000 }).map((k) => k / 1000) },
);

const point: fc.Arbitrary<Point> = fc.tuple(coordinate, coordinate);

/** From the centre of a circle of this radius to her centre as her box touches it exactly, upright. */
const touchingAt = (radius: number): fc.Arbitrary<Point> =>
  fc.constantFrom([radius + 10, 0], [-radius - 10, 0], [0, radius + 16], [0, -radius - 16]);

const velocity = fc.oneof(
  { weight: 2, arbitrary: fc.constant(0) },
  { weight: 3, arbitrary: fc.integer({ min: -60, max: 60 }) },
  { weight: 1, arbitrary: fc.constantFrom(-1000, -20, 20, 1000) },
);

/** A list of objects, empty half of the time, so that no effect needs another one. */
const list = <T>(item: fc.Arbitrary<T>, most: number) =>
  fc.oneof({ weight: 1, arbitrary: fc.constant<T[]>([]) }, { weight: 1, arbitrary: fc.array(item, { maxLength: most }) });

/** The rules of a level, often with a speed limit that she reaches. */
const rules = fc
  .tuple(
    fc.oneof({ weight: 1, arbitrary: fc.constant({}) }, { weight: 1, arbitrary: arbitraryRules }),
    fc.option(fc.integer({ min: 10, max: 60 }), { freq: 2 }),
  )
  .map(([own, speedLimit]) => (speedLimit === null ? own : { ...own, speedLimit }));

/**
 * A level that mixes all effects, under any rules: objects of every kind share places with each other and with her, touch her
 * exactly at the start or have their rim in her centre, and a low speed limit is frequent. Hazards are few, so that runs last.
 */
export const arbitraryMixedLevel: fc.Arbitrary<Level> = fc
  .tuple(fc.array(point, { minLength: 2, maxLength: 4 }), point)
  .chain(([shared, start]) => {
    const place = fc.oneof({ weight: 2, arbitrary: fc.constantFrom(start, ...shared) }, { weight: 3, arbitrary: point });
    const circle = (...radii: readonly number[]): fc.Arbitrary<Circle> =>
      fc.constantFrom(...radii).chain((radius) => {
        const touching = touchingAt(radius).map(([x, y]): Point => [start[0] + x, start[1] + y]);
        const rim = fc
          .constantFrom<Point>([radius, 0], [-radius, 0], [0, radius], [0, -radius])
          .map(([x, y]): Point => [start[0] + x, start[1] + y]);
        return fc
          .oneof({ weight: 8, arbitrary: place }, { weight: 1, arbitrary: touching }, { weight: 1, arbitrary: rim })
          .map(([x, y]) => ({ id: null, x, y, radius }));
      });
    return fc.record({
      name: fc.constant('mixed'),
      description: fc.constant(''),
      astronaut: fc.tuple(velocity, velocity).map(([vx, vy]) => ({ x: start[0], y: start[1], vx, vy })),
      blackHole: fc.oneof(
        { weight: 1, arbitrary: circle(18).map(({ x, y, radius }) => ({ x, y, radius })) },
        { weight: 3, arbitrary: fc.constant({ x: 900, y: 900, radius: 18 }) },
      ),
      range: fc.constantFrom(100, 200, 250, 400, 1000),
      recoil: fc.boolean(),
      asteroids: fc.array(
        fc.tuple(circle(16, 32, 4), fc.integer({ min: 0, max: 7 })).map(([c, n]) => ({ ...c, hot: n === 0 })),
        { minLength: 1, maxLength: 5 },
      ),
      novae: list(circle(7, 16), 1),
      repulsors: list(circle(20, 32, 48), 3),
      aliens: list(circle(7, 10), 3),
      minerals: list(circle(7), 3),
      winds: list(
        fc
          .tuple(circle(20, 60, 100, 400), fc.integer({ min: -40, max: 40 }), fc.constantFrom(0, -20, 20, 39, -7))
          .map(([c, ax, ay]) => ({ ...c, ax, ay })),
        2,
      ),
      wormholes: list(
        fc.tuple(circle(20, 25, 40), place).map(([c, [toX, toY]]) => ({ ...c, toX, toY })),
        3,
      ),
      rules,
      runs: fc.constant([]),
    });
  })
  .map((objects): Level => ({ ...NO_OBJECTS, ...objects }));
