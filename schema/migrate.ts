/** An object as JSON has it. */
export type JsonObject = { readonly [key: string]: unknown };

/** Turns a file of version `from` into one of version `from` + 1. */
export interface Migration {
  readonly from: number;
  /** What changed, for people. */
  readonly what: string;
  /** Pure. The file is not validated yet: what it doesn't know it must leave alone. The version is set by the caller. */
  readonly apply: (file: JsonObject) => JsonObject;
}

/** From every older version of the format to the next. Version 1 is the first. */
export const MIGRATIONS: readonly Migration[] = [];

/** Applies the migrations from version `from` up to `to`; `migrations` has one for each version on the way. */
export function migrate(file: JsonObject, from: number, to: number, migrations: readonly Migration[]): JsonObject {
  let current = file;
  for (let version = from; version < to; version++) {
    const step = migrations.find((migration) => migration.from === version);
    if (step === undefined) throw new RangeError(`there is no migration from version ${version}`);
    current = { ...step.apply(current), version: version + 1 };
  }
  return current;
}
