import fc, { type IRawProperty, type Parameters } from '../node_modules/fast-check/lib/fast-check.js';
import { propertySettings } from './property-settings.ts';

// Tests import this as `fast-check`, by an alias in vitest.config.ts. With a random seed, a property could fail on one machine
// and not on the next. So all properties use one seed, which a hunt for bugs varies: therefore no test may set its own seed.

const { seed, runs } = propertySettings(process.env);

function settle<T>(own: Parameters<T> = {}): Parameters<T> {
  if (own.seed !== undefined)
    throw new Error(`expected a property without a seed of its own, found seed ${own.seed}: see CONTRIBUTING.md`);
  return { ...own, numRuns: Math.ceil((own.numRuns ?? 100) * runs), seed: seed ?? undefined };
}

export const assert = (<T>(property: IRawProperty<T>, own?: Parameters<T>) =>
  fc.assert(property, settle(own))) as typeof fc.assert;

export * from '../node_modules/fast-check/lib/fast-check.js';
export default { ...fc, assert };
