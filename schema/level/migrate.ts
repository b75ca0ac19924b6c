import { LEVEL_VERSION } from '../basics/index.ts';

/** A JSON object. */
export type JsonObject = {
  /** The value of a key. */
  readonly [key: string]: unknown;
};

/** Turns a file of version `from` into one of version `from` + 1. */
export interface Migration {
  /** The version it takes. */
  readonly from: number;
  /** What changed, for people. */
  readonly what: string;
  /**
   * Does it. The function must be pure. The file has not been validated: what the migration does not know it must leave as it
   * is. The caller sets the version.
   *
   * @param file - the level file of version `from`
   * @returns the file of the next version
   */
  readonly apply: (file: JsonObject) => JsonObject;
}

/** The migrations of the format, one for each older version. Version 1 is the first version, so there are none. */
export const MIGRATIONS: readonly Migration[] = [];

/**
 * Applies the migrations from version `from` up to `to`.
 *
 * @param file - the level file
 * @param from - its version
 * @param to - the wanted version
 * @param migrations - has one for each version from `from` to `to` - 1
 * @returns the file of version `to`
 * @throws {RangeError} when a migration is missing
 */
export function migrate(file: JsonObject, from: number, to: number, migrations: readonly Migration[]): JsonObject {
  let current = file;
  for (let version = from; version < to; version++) {
    const step = migrations.find((migration) => migration.from === version);
    if (step === undefined) throw new RangeError(`there is no migration from version ${version}`);
    current = { ...step.apply(current), version: version + 1 };
  }
  return current;
}

/** What the version of a file says: that it is the present one, or which older one, or why it cannot be read. */
export type VersionReading =
  | { readonly kind: 'present' }
  | { readonly kind: 'older'; readonly from: number }
  | { readonly kind: 'newer' | 'unknown' | 'no version'; readonly version: unknown };

/**
 * Reads the version of a file.
 *
 * @param value - any JSON value; one without a version counts as present: its shape is wrong
 * @param migrations - those that there are
 */
export function readVersion(value: unknown, migrations: readonly Migration[]): VersionReading {
  const hasVersion = typeof value === 'object' && value !== null && !Array.isArray(value) && Object.hasOwn(value, 'version');
  if (!hasVersion) return { kind: 'present' };
  const { version } = value as JsonObject;
  if (version === LEVEL_VERSION) return { kind: 'present' };
  if (typeof version !== 'number' || !Number.isInteger(version) || version < 0) return { kind: 'no version', version };
  if (version > LEVEL_VERSION) return { kind: 'newer', version };
  for (let v = version; v < LEVEL_VERSION; v++) {
    if (!migrations.some((migration) => migration.from === v)) return { kind: 'unknown', version: v };
  }
  return { kind: 'older', from: version };
}
