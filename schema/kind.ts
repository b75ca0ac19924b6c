/** A property of an object that is a number. Without a `default` a file must have it. */
export interface NumberField {
  readonly type: 'number';
  /** null: a plain number */
  readonly unit: 'px' | 'px/s' | 'px/s2' | null;
  readonly least: number;
  readonly most: number;
  /** By how much a key, or a px of a drag, changes it where it is typed. */
  readonly step: number;
  /** What stands for it where a file leaves it out. */
  readonly default?: number;
  /** What a new object gets where there is no default. Coordinates have none: they come from where the object is put. */
  readonly initial?: number;
  /** What it means, as the JSON Schema and the editor say it. */
  readonly about: string;
  /** What it is called where it is typed; its key when left out. */
  readonly label?: string;
}

/** A property of an object that is true or false. */
export interface FlagField {
  readonly type: 'flag';
  readonly default: boolean;
  readonly about: string;
  /** What its two ends are called. */
  readonly ends: readonly [off: string, on: string];
  readonly label?: string;
}

export type Field = NumberField | FlagField;

/** Two fields that are coordinates, or the parts of a vector, along x and y. */
export type Pair = readonly [x: string, y: string];

/** What an object is to people: a kind as a whole, or those of a kind that a flag makes another thing. */
export interface Appearance {
  /** In words, lower case: one and many. */
  readonly one: string;
  readonly many: string;
  /** Where counts of everything stand side by side, and words have to tell alike things apart; `one` and `many` when left out. */
  readonly counted?: readonly [one: string, many: string];
  /** Whether touching it ends a run badly. */
  readonly deadly: boolean;
  /** What it does to her. */
  readonly about: string;
  /** The key that takes the editor's tool for it; null where it can't be placed. */
  readonly letter: string | null;
}

/** One kind of object: all that schema, editor, pictures and reports have to know of it. What it does is the engine's. */
export interface Kind extends Appearance {
  /** The list in a level file that holds those of this kind, each with an id; null: a level has exactly one, under the name of the kind, without an id. */
  readonly list: string | null;
  /** What the list is for. */
  readonly aboutList: string;
  /** In the order of a file. */
  readonly fields: Readonly<Record<string, Field>>;
  /** Which fields are places, px. The first is where the object is; whatever moves an object moves all of them. */
  readonly places: readonly [Pair, ...Pair[]];
  /** Which fields are vectors, by what they are together. */
  readonly vectors: Readonly<Record<string, Pair>>;
  /** Which field is the radius of the disc around each of its places, px; null: it is none. */
  readonly radius: 'radius' | null;
  /** What those are to people whose `flag` is true. */
  readonly variant?: Appearance & { readonly flag: string };
  /** What the original game calls the kind, and fields of it that have another name there; null: it has none. */
  readonly original: { readonly key: string; readonly fields?: Readonly<Record<string, string>> } | null;
}
