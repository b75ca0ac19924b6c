import { describe, expect, it } from 'vitest';
import { isDeep } from '../depth.ts';
import { checkMixed } from '../judges/check-mixed.ts';
import { propertySettings } from '../property-settings.ts';
import { mixedScene } from '../scenes/mixed-scene.ts';
import { startScene } from '../scenes/start-scene.ts';

const BLOCKS = Math.max(1, Math.round(5 * propertySettings(process.env).runs));
const SCENES = isDeep ? 40 : 10;

/** Largest share of the scenes of a block whose end may be left out because last digits decide it. */
const MOST_EXCLUDED = 0.25;

// a sample of bench/soak.ts, which tests any number of scenes
describe.each([
  ['in which all effects meet', mixedScene],
  ['in which much is decided at time 0', startScene],
] as const)('scenes %s', (_, sceneOf) => {
  it.each(Array.from({ length: BLOCKS }, (_, block) => SCENES * block))(
    'end as the reference with 32 digits says, whole or in parts: from seed %i',
    (first) => {
      let excluded = 0;
      const bugs = Array.from({ length: SCENES }, (_, i) => first + i).flatMap((seed) => {
        const findings = checkMixed(sceneOf(seed), seed);
        excluded += findings.some(({ kind }) => kind === 'excluded') ? 1 : 0;
        return findings.filter(({ kind }) => kind === 'bug').map((finding) => ({ seed, ...finding }));
      });
      expect(bugs).toEqual([]);
      expect(excluded / SCENES).toBeLessThan(MOST_EXCLUDED);
    },
  );
});
