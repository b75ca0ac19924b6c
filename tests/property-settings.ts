/** How the properties in tests are tried: see CONTRIBUTING.md. */
interface PropertySettings {
  /** of the random numbers of every property; null: a new one for each property */
  readonly seed: number | null;
  /** what every property's number of runs is multiplied by, above 0 */
  readonly runs: number;
}

const FIXED_SEED = 1;

/**
 * The settings asked for by `PROPERTY_SEED` and `PROPERTY_RUNS`, otherwise the same on every machine and every day.
 * Throws an Error for values that are none.
 */
export function propertySettings(environment: Readonly<Record<string, string | undefined>>): PropertySettings {
  const { PROPERTY_SEED: seed = String(FIXED_SEED), PROPERTY_RUNS: runs = '1' } = environment;
  if (seed !== 'random' && !/^-?\d{1,10}$/.test(seed))
    throw new Error(`PROPERTY_SEED: expected "random" or a whole number, found "${seed}"`);
  if (!(/^\d+(\.\d+)?$/.test(runs) && Number(runs) > 0))
    throw new Error(`PROPERTY_RUNS: expected a number above 0, found "${runs}"`);
  return { seed: seed === 'random' ? null : Number(seed), runs: Number(runs) };
}
