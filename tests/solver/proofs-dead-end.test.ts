import fc from 'fast-check';
import { expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { type Level, resolveLevel } from '../../schema/index.ts';
import { createSearch, proofPicture, proveImpossible, verifyProof } from '../../solver/index.ts';
import { expectDeep } from '../depth.ts';
import { someHolds } from './proofs-crowded.ts';

const whole = (min: number, max: number) => fc.integer({ min, max });
const circle = (x: fc.Arbitrary<number>, y: fc.Arbitrary<number>, ...radii: number[]) =>
  fc.record({ x, y, radius: fc.constantFrom(...radii) });

/**
 * She rests in front of an asteroid, with others beside the line, hazards at both its ends, and more hazards where another
 * asteroid pulls her.
 */
const boundLevel: fc.Arbitrary<Level> = fc
  .record({
    near: circle(whole(40, 90), fc.constant(0), 16, 32),
    others: fc.array(circle(whole(100, 220), whole(-130, 130), 16, 32), { minLength: 1, maxLength: 2 }),
    back: circle(whole(-90, -50), whole(-20, 20), 16, 32),
    front: circle(whole(130, 260), whole(-20, 20), 32),
    novae: fc.array(circle(whole(80, 260), whole(-140, 140), 32), { minLength: 2, maxLength: 9 }),
    blackHole: circle(whole(150, 320), whole(-160, 160), 18),
    repulsors: fc.array(circle(whole(80, 260), whole(-140, 140), 32, 48), { maxLength: 1 }),
    recoil: fc.boolean(),
  })
  .map(({ near, others, back, front, novae, blackHole, repulsors, recoil }) =>
    resolveLevel({
      version: 1,
      name: 'bound to a line',
      astronaut: { x: 0, y: 0 },
      blackHole,
      recoil,
      asteroids: [near, ...others],
      novae: [back, front, ...novae],
      repulsors,
    }),
  );

it('no run is found where the line ends in a dead end, or where recoil is claimed to add up to little', () => {
  let deadEnds = 0;
  let swings = 0;
  let completed = 0;
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
      expect(verifyProof(level, proof)).toEqual({ ok: true });
      const { front, back } = proof.certificate;
      if (front.by.kind === 'dead-end' || back.by.kind === 'dead-end') deadEnds++;
      else if (level.recoil) swings++;
      search.advance(15_000);
      expect(search.solutions).toEqual([]);
    }),
    { numRuns: 170 },
  );
  // The property is meaningful only if all of this occurs.
  expectDeep(deadEnds).toBeGreaterThan(5);
  expectDeep(swings).toBeGreaterThan(5);
  expectDeep(completed).toBeGreaterThan(5);
});

interface Place {
  readonly x: number;
  readonly y: number;
}

/** How far a place lies outside a convex polygon, px; 0 inside. The corners are in the sense from x to y. */
function outside(corners: readonly Place[], { x, y }: Place): number {
  const beyond = corners.map((a, i) => {
    const b = corners[(i + 1) % corners.length];
    const length = Math.hypot(b.x - a.x, b.y - a.y);
    return length === 0 ? 0 : ((b.y - a.y) * (x - a.x) - (b.x - a.x) * (y - a.y)) / length;
  });
  return Math.max(0, ...beyond);
}

it('off the line she stays within the places that the dead end allows', () => {
  let places = 0;
  let dies = 0;
  fc.assert(
    fc.property(boundLevel, fc.array(someHolds, { minLength: 12, maxLength: 12 }), (bound, plays) => {
      const level = { ...bound, recoil: false };
      const proof = proveImpossible(level, { accuracy: 'precise' });
      const ends = proof?.certificate.kind === 'line-trap' ? [proof.certificate.front.by, proof.certificate.back.by] : [];
      if (proof === null || !ends.some(({ kind }) => kind === 'dead-end')) return;
      const pieces = proofPicture(level, proof).lines.flatMap(({ role, points }) => (role === 'reach' ? [points] : []));
      const state = new Float64Array(6);
      for (const holds of plays) {
        const run = simulate(compile(level), [[0, 20], ...holds], { maxTime: 30 });
        if (run.outcome === 'collided') dies++;
        for (let time = 0; time < run.time; time += 1 / 60) {
          run.trajectory.at(time, state);
          const [x, y] = state;
          // The line is the x axis.
          if (Math.abs(y) < 1e-6) continue;
          places++;
          const least = Math.min(...pieces.map((piece) => outside(piece, { x, y })));
          expect(least).toBeLessThan(0.01);
        }
      }
    }),
    { numRuns: 300 },
  );
  expectDeep(places).toBeGreaterThan(300);
  expectDeep(dies).toBeGreaterThan(50);
});
