import fc from 'fast-check';
import { expect, it } from 'vitest';
import { compile } from '../../engine/index.ts';
import { type Level, resolveLevel } from '../../schema/index.ts';
import { createSearch, proveImpossible, verifyProof } from '../../solver/index.ts';

const whole = (min: number, max: number) => fc.integer({ min, max });
const circle = (x: fc.Arbitrary<number>, y: fc.Arbitrary<number>, ...radii: number[]) =>
  fc.record({ x, y, radius: fc.constantFrom(...radii) });

/** At rest before an asteroid, with others beside the line, hazards at both its ends, and more where she comes when another pulls her. */
const boundLevel: fc.Arbitrary<Level> = fc
  .record({
    near: circle(whole(40, 90), fc.constant(0), 16, 32),
    others: fc.array(circle(whole(100, 220), whole(-130, 130), 16, 32), { minLength: 1, maxLength: 2 }),
    back: circle(whole(-90, -50), whole(-20, 20), 16, 32),
    front: circle(whole(130, 260), whole(-20, 20), 32),
    novae: fc.array(circle(whole(80, 260), whole(-140, 140), 32), { minLength: 2, maxLength: 9 }),
    blackHole: circle(whole(150, 320), whole(-160, 160), 18),
    recoil: fc.boolean(),
  })
  .map(({ near, others, back, front, novae, blackHole, recoil }) =>
    resolveLevel({
      version: 1,
      name: 'bound to a line',
      astronaut: { x: 0, y: 0 },
      blackHole,
      recoil,
      asteroids: [near, ...others],
      novae: [back, front, ...novae],
    }),
  );

it('no run is found where the line ends in a dead end, or where recoil is said to add up to little', () => {
  let deadEnds = 0;
  let swings = 0;
  let completed = 0;
  let unverified = 0;
  fc.assert(
    fc.property(boundLevel, (level) => {
      const proof = proveImpossible(level, { accuracy: 'precise' });
      const search = createSearch(compile(level), { seed: 1 });
      if (proof?.certificate.kind !== 'line-trap') {
        search.advance(5_000);
        completed += search.solutions.length > 0 ? 1 : 0;
        expect(proof === null || search.solutions.length === 0).toBe(true);
        return;
      }
      // the checker looks at other squares: where a cone is tight it may not agree, and then nothing is claimed
      if (!verifyProof(level, proof).ok) {
        unverified++;
        return;
      }
      const { front, back } = proof.certificate;
      if (front.by.kind === 'dead-end' || back.by.kind === 'dead-end') deadEnds++;
      else if (level.recoil) swings++;
      search.advance(30_000);
      expect(search.solutions).toEqual([]);
    }),
    { numRuns: 600 },
  );
  // the property says something only where all of it happens
  expect(deadEnds).toBeGreaterThan(5);
  expect(swings).toBeGreaterThan(5);
  expect(completed).toBeGreaterThan(5);
  expect(unverified).toBeLessThan(5);
});
