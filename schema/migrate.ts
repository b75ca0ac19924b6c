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
