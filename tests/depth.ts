import { describe, expect, it } from 'vitest';
import { isHunt as isHuntBy, propertySettings } from './property-settings.ts';

const { runs } = propertySettings(process.env);

/** Whether this is the deep set, which tries every case where the quick one tries a sample: see CONTRIBUTING.md. */
export const isDeep = runs >= 1;

/** Whether this is a hunt for bugs, as in `npm run bench -- soak`, which tries more than any set. */
export const isHunt = isHuntBy(process.env);

/** Whether the deep set runs, which does not repeat what the quick one says; by hand, or for mutants, all of a file runs. */
const isDeepSet = process.env.TEST_SET === 'deep';

/** What declares nothing, so that a set does not list what it leaves to the other one as skipped. */
const nothing = Object.assign(() => {}, { each: () => () => {}, runIf: () => () => {} });

/** `it` for a test that is dear, or repeats for more cases what another one says: it is in the deep set alone. */
export const itDeep = (isDeep ? it : nothing) as Pick<typeof it, 'each' | 'runIf'> &
  ((name: string, test: () => unknown) => void);

/** `describe` for a group of such tests. */
export const describeDeep = (isDeep ? describe : nothing) as Pick<typeof describe, 'each'> &
  ((name: string, tests: () => void) => void);

/**
 * `it` for a dear test that says the same in every set: it is in the quick set alone, whereas the rest of its file tries more
 * cases in the deep one.
 */
export const itQuick: typeof it = isDeepSet ? (nothing as unknown as typeof it) : it;

/** `describe` for a group of such tests. */
export const describeQuick: typeof describe = isDeepSet ? (nothing as unknown as typeof describe) : describe;

/** What can be said of what a property has gathered. */
interface Gathered {
  toBeGreaterThan(least: number): void;
  toBeGreaterThanOrEqual(least: number): void;
  toBeLessThan(most: number): void;
  toEqual(seen: unknown): void;
}

const SILENT: Gathered = { toBeGreaterThan() {}, toBeGreaterThanOrEqual() {}, toBeLessThan() {}, toEqual() {} };

/** `expect` for how much a property has seen on its way, which shows that it is about something: certain only at full count. */
export const expectDeep = (seen: unknown): Gathered => (isDeep ? expect(seen) : SILENT);

/** Every case in the deep set; in the quick set so many of them, evenly spread, the first among them. */
export const someOf = <T>(cases: readonly T[], count: number): readonly T[] =>
  isDeep ? cases : cases.filter((_, i) => Math.ceil((i * count) / cases.length) < Math.ceil(((i + 1) * count) / cases.length));
