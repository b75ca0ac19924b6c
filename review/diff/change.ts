/** A JSON object. */
export type Json = { readonly [key: string]: unknown };

/** A value of a key before and after. A property that is missing here was missing there. */
export interface FieldChange {
  readonly key: string;
  readonly before?: unknown;
  readonly after?: unknown;
}

/** The order of the x- keys of an object before and after, where it does not follow from the fields. */
export interface KeyOrder {
  readonly before: readonly string[];
  readonly after: readonly string[];
}

/** How two entries of a list were found to be the same: by id or name, by equal content, or by the nearest place. */
export type MatchedBy = 'id' | 'content' | 'place';

/** A key of the level that is neither an object nor a list of objects or runs: its name, its range, an x- key. */
export interface ValueChange extends FieldChange {
  readonly type: 'value';
}

/** Keys of the level whose values are looked up by name: rules, and codes that are allowed. */
export interface MapChange {
  readonly type: 'map';
  readonly of: string;
  readonly fields: readonly FieldChange[];
  readonly keys: KeyOrder | null;
  /** Whether the file had, and has, the key with nothing in it. */
  readonly empty: { readonly before: boolean; readonly after: boolean };
}

/** An entry that is in one version only. */
export interface EntryChange {
  readonly type: 'added' | 'removed';
  /** The key of the list: `asteroids`, `runs`. */
  readonly of: string;
  /** From 0, in the version that has it. */
  readonly index: number;
  readonly entry: Json;
}

/** An object or run whose fields differ. */
export interface PartChange {
  readonly type: 'changed';
  /** The key of the list, or of the object that a level has once: `asteroids`, `runs`, `astronaut`. */
  readonly of: string;
  /** Indices in the two lists, from 0; 0 for an object that a level has once. */
  readonly before: number;
  readonly after: number;
  readonly matchedBy: MatchedBy;
  readonly fields: readonly FieldChange[];
  readonly keys: KeyOrder | null;
}

/** A list whose common entries are in another order. */
export interface OrderChange {
  readonly type: 'order';
  readonly of: string;
  /** Indices of the common entries before and after, sorted by the second. */
  readonly pairs: readonly (readonly [before: number, after: number])[];
}

/** An empty list that is written in one version and left out in the other. Both mean the same. */
export interface EmptyListChange {
  readonly type: 'empty-list';
  readonly of: string;
  readonly before: boolean;
  readonly after: boolean;
}

/** The order of the level's own x- keys. */
export interface LevelKeysChange extends KeyOrder {
  readonly type: 'keys';
}

/** One difference between two versions of a level. Together they turn the first version into the second. */
export type Change = ValueChange | MapChange | EntryChange | PartChange | OrderChange | EmptyListChange | LevelKeysChange;

const isOwn = (key: string): boolean => key.startsWith('x-');

/** The x- keys of an object, in their order. */
export const ownKeys = (object: Json): string[] => Object.keys(object).filter((key) => isOwn(key) && object[key] !== undefined);

/** The x- keys that follow from those before and the changed fields: the kept ones, then the new ones. */
export function followingKeys(before: readonly string[], fields: readonly FieldChange[]): string[] {
  const removed = new Set(fields.flatMap((field) => (Object.hasOwn(field, 'after') ? [] : [field.key])));
  const added = fields.flatMap((field) => (Object.hasOwn(field, 'before') || !isOwn(field.key) ? [] : [field.key]));
  return [...before.filter((key) => !removed.has(key)), ...added];
}

/** A change in the other direction. */
export const swapped = ({ key, ...values }: FieldChange): FieldChange => ({
  key,
  ...(Object.hasOwn(values, 'after') && { before: values.after }),
  ...(Object.hasOwn(values, 'before') && { after: values.before }),
});

/** Whether two JSON values have the same canonical text. */
export const isEqual = (a: unknown, b: unknown): boolean => a === b || JSON.stringify(a) === JSON.stringify(b);
