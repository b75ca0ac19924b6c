import { describe, expect, it } from 'vitest';
import { expectDeep } from '../depth.ts';
import { checkBySteps } from '../judges/by-steps.ts';
import { checkScene } from '../judges/check-scene.ts';
import { checkPieces } from '../judges/pieces.ts';
import { propertySettings } from '../property-settings.ts';
import { steppableScene, windyDegenerateScene, windyScene } from '../scenes/windy-scene.ts';

const { runs } = propertySettings(process.env);
const seeds = (count: number) => Array.from({ length: count }, (_, seed) => seed);

// a sample of bench/soak.ts, which tests any number of scenes
describe('scenes with winds and wormholes', () => {
  it('obey every rule at every accuracy, whole or split, at two tolerances', () => {
    expect(seeds(20 * runs).flatMap((seed) => checkScene(windyScene(seed), seed).filter(({ kind }) => kind === 'bug'))).toEqual(
      [],
    );
  });

  it('take a bounded number of pieces from starts on rims, in mouths and between balanced forces', () => {
    expect(
      seeds(10 * runs).flatMap((seed) => checkPieces(windyDegenerateScene(seed)).filter(({ kind }) => kind === 'bug')),
    ).toEqual([]);
  });

  it('take a bounded number of pieces if the mouths of a wormhole nearly coincide', () => {
    const known = [12228, 102_462, 102_622, 10_507];
    expect(
      known.flatMap((seed) => checkPieces(windyDegenerateScene(seed)).map(({ accuracy, what }) => ({ seed, accuracy, what }))),
    ).toEqual([]);
  });

  it('end at the same place as in another program with small steps', () => {
    let [agreeing, jumps, crossings] = [0, 0, 0];
    for (const seed of seeds(15 * runs)) {
      const finding = checkBySteps(steppableScene(seed));
      expect({ seed, finding }).not.toHaveProperty('finding.why');
      if (finding.what !== 'agrees') continue;
      agreeing++;
      jumps += finding.jumps;
      crossings += finding.crossings;
    }
    expectDeep(agreeing).toBeGreaterThan(5);
    expectDeep(jumps).toBeGreaterThan(1);
    expectDeep(crossings).toBeGreaterThan(2);
  });
});
