import type { IRawProperty, Parameters } from 'fast-check';
import { vi } from 'vitest';
import { propertySettings } from './property-settings.ts';

// A property whose seed is drawn anew each time fails on one machine and not on the next. Here all are drawn from one seed, which
// a hunt for bugs varies: for that, no test may keep a seed to itself.
vi.mock('fast-check', async (importOriginal) => {
  const original = await importOriginal<typeof import('fast-check')>();
  const { seed, runs } = propertySettings(process.env);

  const settle = <T>(own: Parameters<T> = {}): Parameters<T> => {
    if (own.seed !== undefined)
      throw new Error(`expected a property without a seed of its own, found seed ${own.seed}: see CONTRIBUTING.md`);
    return { ...own, numRuns: Math.ceil((own.numRuns ?? 100) * runs), seed: seed ?? undefined };
  };
  const assert = (<T>(property: IRawProperty<T>, own?: Parameters<T>) =>
    original.assert(property, settle(own))) as typeof original.assert;
  return { ...original, default: { ...original.default, assert } };
});
