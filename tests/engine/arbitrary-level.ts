import fc from 'fast-check';
import { type Circle, type Hold, type Level, NO_OBJECTS } from '../../schema/index.ts';

type Point = readonly [x: number, y: number];

// not fc.double, which is uniform over bit patterns and so gives mostly numbers close to 0
const even = (min: number, max: number) => fc.integer({ min: 0, max: 2 ** 31 - 1 }).map((k) => min + ((max - min) * k) / 2 ** 31);

/** Any double between the limits, most of them tiny. */
const anyDouble = (min: number, max: number) => fc.double({ min, max, noNaN: true, noDefaultInfinity: true });

const coordinate = fc.oneof(
  { weight: 6, arbitrary: fc.integer({ min: -300, max: 300 }) },
  { weight: 4, arbitrary: even(-400, 400) },
  // exact ties and touches
  { weight: 2, arbitrary: fc.constantFrom(0, -0, 16, 32, 34, 150, 250, -150, -250) },
  { weight: 1, arbitrary: anyDouble(-1e9, 1e9) },
  { weight: 1, arbitrary: fc.constantFrom(5e-324, -5e-324, 1e-160, 1e9, -1e9) },
);

const point: fc.Arbitrary<Point> = fc.tuple(coordinate, coordinate);

/**
 * px. Recoil is 1 / diameter px/s2: a much smaller asteroid would jump around at the speed limit.
 */
const SMALLEST_RADIUS = 1e-3;

const radius = fc.oneof(
  { weight: 6, arbitrary: fc.constantFrom(7, 16, 18, 25, 32, 48) },
  { weight: 2, arbitrary: even(1, 200) },
  { weight: 1, arbitrary: fc.constantFrom(SMALLEST_RADIUS, 0.5, 1e6) },
);

const velocity = fc.oneof(
  { weight: 4, arbitrary: fc.constant(0) },
  { weight: 3, arbitrary: even(-120, 120) },
  { weight: 1, arbitrary: fc.constantFrom(1000, -1000, 5e-324, -0) },
);

/** px/s2 */
const wind = fc.record({ ax: even(-100, 100), ay: fc.constantFrom(0, -20, 20, 100) });

const list = <T>(item: fc.Arbitrary<T>, most: number) => fc.array(item, { maxLength: most });

/**
 * Any level that the schema accepts, with a bias to difficult ones: objects of every kind on top of each other and of her
 * (distances of exactly 0), exact ties and touches, radii from a thousandth to a million px, any range, recoil on and off,
 * starts at rest or at the speed limit.
 */
export const arbitraryLevel: fc.Arbitrary<Level> = fc.array(point, { minLength: 1, maxLength: 5 }).chain((shared) => {
  const place = fc.oneof({ weight: 1, arbitrary: fc.constantFrom(...shared) }, { weight: 2, arbitrary: point });
  const circle: fc.Arbitrary<Circle> = fc.tuple(place, radius).map(([[x, y], r]) => ({ id: null, x, y, radius: r }));
  const level = fc.record({
    name: fc.constant('arbitrary'),
    description: fc.constant(''),
    astronaut: fc.tuple(place, velocity, velocity).map(([[x, y], vx, vy]) => ({ x, y, vx, vy })),
    blackHole: circle.map(({ x, y, radius: r }) => ({ x, y, radius: r })),
    range: fc.oneof(
      { weight: 4, arbitrary: fc.constant(250) },
      { weight: 4, arbitrary: even(200, 2000) },
      { weight: 1, arbitrary: fc.constantFrom(5e-324, 1, 1e6) },
    ),
    recoil: fc.boolean(),
    asteroids: list(
      fc.tuple(circle, fc.boolean()).map(([c, hot]) => ({ ...c, hot })),
      6,
    ),
    novae: list(circle, 3),
    repulsors: list(circle, 4),
    aliens: list(circle, 4),
    minerals: list(circle, 5),
    winds: list(
      fc.tuple(circle, wind).map(([c, blows]) => ({ ...c, ...blows })),
      3,
    ),
    wormholes: list(
      fc.tuple(circle, place).map(([c, [toX, toY]]) => ({ ...c, toX, toY })),
      2,
    ),
    runs: fc.constant([]),
  });
  return level.map((objects): Level => ({ ...NO_OBJECTS, ...objects }));
});

/** A level in which a run lasts for a while: no hazard near her start, an asteroid in range, ordinary sizes. */
export const arbitraryPlayableLevel: fc.Arbitrary<Level> = fc
  .record({
    name: fc.constant('playable'),
    description: fc.constant(''),
    astronaut: fc.record({ x: even(-20, 20), y: even(-20, 20), vx: even(-40, 40), vy: even(-40, 40) }),
    blackHole: fc.constant({ x: 900, y: 900, radius: 18 }),
    range: even(400, 2000),
    recoil: fc.boolean(),
    asteroids: fc.array(
      fc
        .tuple(even(-300, 300), even(-300, 300), fc.constantFrom(16, 32))
        .map(([x, y, r]) => ({ id: null, x, y, radius: r, hot: Math.abs(x) + Math.abs(y) > 350 })),
      { minLength: 1, maxLength: 5 },
    ),
    novae: list(away(16), 2),
    repulsors: list(away(48), 3),
    aliens: list(away(25), 4),
    minerals: list(
      fc.tuple(even(-80, 80), even(-80, 80)).map(([x, y]) => ({ id: null, x, y, radius: 7 })),
      4,
    ),
    winds: list(
      fc
        .tuple(even(-200, 200), even(-200, 200), even(20, 120), wind)
        .map(([x, y, radius, blows]) => ({ id: null, x, y, radius, ...blows })),
      2,
    ),
    wormholes: list(
      fc
        .tuple(even(-150, 150), even(-150, 150), even(-300, 300), even(-300, 300), even(10, 40))
        .map(([x, y, toX, toY, radius]) => ({ id: null, x, y, toX, toY, radius })),
      2,
    ),
    runs: fc.constant([]),
  })
  .map((objects): Level => ({ ...NO_OBJECTS, ...objects }));

function away(r: number): fc.Arbitrary<Circle> {
  return fc
    .tuple(even(90, 400), even(60, 400), fc.boolean(), fc.boolean())
    .map(([x, y, left, up]) => ({ id: null, x: left ? -x : x, y: up ? -y : y, radius: r }));
}

/** Holds as users may write them: in any order, overlapping, touching, empty. */
export const arbitraryHolds = (lastTick: number): fc.Arbitrary<Hold[]> =>
  fc.array(
    fc.tuple(fc.nat(lastTick), fc.nat(lastTick)).map(([a, b]): Hold => (a <= b ? [a, b] : [b, a])),
    { maxLength: 6 },
  );
