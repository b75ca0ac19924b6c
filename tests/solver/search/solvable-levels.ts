import fc from 'fast-check';
import type { Level } from '../../../schema/index.ts';
import { plainLevel } from '../../engine/plain-level.ts';

/** An asteroid between her and the black hole: one hold through its centre suffices. */
export const fallThrough = (): Level =>
  plainLevel({
    range: 250,
    asteroids: [{ x: 100, y: 0, radius: 16 }],
    blackHole: { x: 230, y: 10 },
    minerals: [
      { x: 60, y: 0, radius: 7 },
      { x: 150, y: 5, radius: 7 },
    ],
  });

/** Two asteroids beside the line: a swing is needed. */
export const swing = (): Level =>
  plainLevel({
    range: 250,
    asteroids: [
      { x: 150, y: 0, radius: 16 },
      { x: 250, y: 120, radius: 16 },
    ],
    blackHole: { x: 150, y: 330 },
    novae: [{ x: 60, y: 120, radius: 16 }],
    minerals: [{ x: 150, y: 120, radius: 7 }],
  });

const coordinate = (min: number, max: number) => fc.integer({ min, max });

/** Ordinary levels; most can be completed, some cannot. */
export const arbitraryOrdinaryLevel: fc.Arbitrary<Level> = fc
  .record({
    recoil: fc.boolean(),
    hole: fc.tuple(coordinate(80, 400), coordinate(-200, 300)),
    asteroids: fc.array(
      fc.record({ x: coordinate(40, 350), y: coordinate(-150, 250), radius: fc.constantFrom(16, 32), hot: fc.boolean() }),
      { minLength: 1, maxLength: 4 },
    ),
    novae: fc.array(fc.record({ x: coordinate(60, 400), y: coordinate(60, 300), radius: fc.constantFrom(16, 32) }), {
      maxLength: 4,
    }),
    repulsors: fc.array(fc.record({ x: coordinate(60, 400), y: coordinate(-200, 300), radius: fc.constantFrom(32, 48) }), {
      maxLength: 2,
    }),
    aliens: fc.array(fc.record({ x: coordinate(120, 400), y: coordinate(-200, -120), radius: fc.constant(25) }), {
      maxLength: 2,
    }),
    minerals: fc.array(fc.record({ x: coordinate(0, 300), y: coordinate(-100, 200), radius: fc.constant(7) }), {
      maxLength: 3,
    }),
  })
  .map(({ hole: [x, y], ...lists }) => plainLevel({ range: 250, blackHole: { x, y }, ...lists }));

/** The two levels above with everything moved a little. */
export const arbitrarySolvableLevel: fc.Arbitrary<Level> = fc
  .tuple(fc.boolean(), fc.boolean(), fc.integer({ min: -6, max: 6 }), fc.integer({ min: -6, max: 6 }))
  .map(([swings, recoil, x, y]) => {
    const level = swings ? swing() : fallThrough();
    const { blackHole } = level;
    return { ...level, recoil, blackHole: { ...blackHole, x: blackHole.x + x, y: blackHole.y + y } };
  });
