import fc from 'fast-check';
import { expect, it } from 'vitest';
import { checkScene } from '../judges/check-scene.ts';
import { randomScene } from '../scenes/random-scene.ts';

// a sample of bench/soak.ts, which tests a hundred thousand scenes
it('every rule holds in random scenes, at every accuracy, whole or split, at two tolerances', () => {
  fc.assert(
    fc.property(fc.nat(2 ** 31 - 1), (seed) => {
      const bugs = checkScene(randomScene(seed), seed).filter((finding) => finding.kind === 'bug');
      expect(bugs).toEqual([]);
    }),
    // A scene is made from its whole seed: a smaller seed is not a simpler scene. In the example she returns to an alien that fell asleep.
    { numRuns: 40, endOnFailure: true, examples: [[933_097_368]] },
  );
});
