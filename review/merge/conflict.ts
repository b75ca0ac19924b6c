/** A version that takes part in a merge. */
export type Side = 'mine' | 'theirs';

/** A property that both sides changed in different ways. */
export interface Conflict {
  /** Identifies what it is about, for choices: `asteroids/a7k2/place`, `runs/solution/holds`, `name`, `order/asteroids`. */
  readonly key: string;
  /** The same in words: `asteroid a7k2, place`. */
  readonly what: string;
  /**
   * JSON values; undefined if missing or deleted. An object that is of another kind than the list in the key says has the
   * additional key `kind`.
   */
  readonly base: unknown;
  readonly mine: unknown;
  readonly theirs: unknown;
}

/** The chosen side of conflicts, by key. */
export type Choices = ReadonlyMap<string, Side>;

/** A conflict's key from its parts; names may contain slashes. */
export const conflictKey = (...parts: readonly string[]): string =>
  parts.map((part) => part.replaceAll('~', '~0').replaceAll('/', '~1')).join('/');

/** The parts of a conflict's key. */
export const partsOfKey = (key: string): string[] =>
  key.split('/').map((part) => part.replaceAll('~1', '/').replaceAll('~0', '~'));

/** The first part of the key of a conflict about the order of a list. */
export const ORDER = 'order';
