import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { propertySettings } from './property-settings.ts';

describe('the settings of properties', () => {
  it('are the same everywhere by default', () => {
    expect(propertySettings({})).toEqual({ seed: 1, runs: 1 });
  });

  it.each([
    ['random', '10', { seed: null, runs: 10 }],
    ['-1234567890', '0.5', { seed: -1234567890, runs: 0.5 }],
  ])('seed %s, runs %s', (PROPERTY_SEED, PROPERTY_RUNS, settings) => {
    expect(propertySettings({ PROPERTY_SEED, PROPERTY_RUNS })).toEqual(settings);
  });

  it.each(['', 'randomly', '1.5', '1e3', '12345678901'])('no seed: "%s"', (PROPERTY_SEED) => {
    expect(() => propertySettings({ PROPERTY_SEED })).toThrow(`expected "random" or a whole number, found "${PROPERTY_SEED}"`);
  });

  it.each(['', '0', '-1', 'many', 'Infinity', '0.0'])('no number of runs: "%s"', (PROPERTY_RUNS) => {
    expect(() => propertySettings({ PROPERTY_RUNS })).toThrow(`expected a number above 0, found "${PROPERTY_RUNS}"`);
  });
});

describe('a property', () => {
  const { seed, runs } = propertySettings(process.env);

  /** The numbers that a property draws. */
  function drawn(numRuns?: number): number[] {
    const numbers: number[] = [];
    fc.assert(
      fc.property(fc.nat(), (n) => {
        numbers.push(n);
      }),
      numRuns === undefined ? undefined : { numRuns },
    );
    return numbers;
  }

  it('runs as often as it says, or 100 times, multiplied by PROPERTY_RUNS', () => {
    expect(drawn(30)).toHaveLength(Math.ceil(30 * runs));
    expect(drawn()).toHaveLength(Math.ceil(100 * runs));
  });

  it.runIf(seed !== null)('draws the same numbers every time', () => {
    expect(drawn(20)).toEqual(drawn(20));
  });

  it('may not set its own seed', () => {
    const pass = fc.property(fc.nat(), () => {});
    expect(() => fc.assert(pass, { seed: 4 })).toThrow('expected a property without a seed of its own, found seed 4');
  });
});
