/** The settings of properties in tests: see CONTRIBUTING.md. */
interface PropertySettings {
  /** The seed of every property; null: a new one for each property. */
  readonly seed: number | null;
  /** A factor for the number of runs of every property, above 0. */
  readonly runs: number;
}

const FIXED_SEED = 1;

/** The factor of the quick set, for vitest.config.ts. The deep set runs each property as often as it says. */
export const QUICK_RUNS = 0.1;

/**
 * The settings from `PROPERTY_SEED` and `PROPERTY_RUNS`, by default the same on every machine and every day.
 * @throws Error for invalid values
 */
export function propertySettings(environment: Readonly<Record<string, string | undefined>>): PropertySettings {
  const { PROPERTY_SEED: seed = String(FIXED_SEED), PROPERTY_RUNS: runs = '1' } = environment;
  if (seed !== 'random' && !/^-?\d{1,10}$/.test(seed))
    throw new Error(`PROPERTY_SEED: expected "random" or a whole number, found "${seed}"`);
  if (!(/^\d+(\.\d+)?$/.test(runs) && Number(runs) > 0))
    throw new Error(`PROPERTY_RUNS: expected a number above 0, found "${runs}"`);
  return { seed: seed === 'random' ? null : Number(seed), runs: Number(runs) };
}

/** Whether this is a hunt for bugs, as in `npm run bench -- soak`, which tries more than any set. */
export const isHunt = (environment: Readonly<Record<string, string | undefined>>): boolean =>
  propertySettings(environment).runs >= 10;
