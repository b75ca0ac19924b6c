import fc, { type Arbitrary } from 'fast-check';

/** Evenly distributed numbers; those of `fc.double` are mostly close to 0. */
export const real = (min: number, max: number): Arbitrary<number> =>
  fc.integer({ min: 0, max: 2 ** 30 }).map((n) => min + ((max - min) * n) / 2 ** 30);
