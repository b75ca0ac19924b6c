/** A field of an object that is a number. A field without `default` must be present in a file. */
export interface NumberField {
  /** Tells numbers from flags. */
  readonly type: 'number';
  /** Unit of the value; null for a number without a unit. */
  readonly unit: 'px' | 'px/s' | 'px/s2' | null;
  /** The smallest value allowed. */
  readonly least: number;
  /** The largest value allowed. */
  readonly most: number;
  /** How much one key press, or one px of a drag, changes the value in the editor's inspector. */
  readonly step: number;
  /** The value when a file leaves the field out. */
  readonly default?: number;
  /**
   * The value of a new object where there is no default. Coordinates have neither: they come from where the object is placed.
   */
  readonly initial?: number;
  /** What the field means, as the JSON Schema and the editor say it. */
  readonly about: string;
  /** The label in the editor's inspector; the field's key when left out. */
  readonly label?: string;
}

/** A field of an object that is true or false. */
export interface FlagField {
  /** Tells flags from numbers. */
  readonly type: 'flag';
  /** The value when a file leaves the field out. */
  readonly default: boolean;
  /** What the field means, as the JSON Schema and the editor say it. */
  readonly about: string;
  /** Words for false and for true. */
  readonly ends: readonly [off: string, on: string];
  /** The label in the editor; the field's key when left out. */
  readonly label?: string;
}

/** A field of an object in a level. */
export type Field = NumberField | FlagField;

/** The keys of two fields that form a place or a vector. */
export type Pair = readonly [x: string, y: string];

/** How an object is presented to people: a kind as a whole, or the objects of a kind that a flag turns into something else. */
export interface Appearance {
  /** The name of one object, lower case. */
  readonly one: string;
  /** The name of several objects, lower case. */
  readonly many: string;
  /** The names in lists of counts, where similar kinds must be told apart; `one` and `many` when left out. */
  readonly counted?: readonly [one: string, many: string];
  /** Whether touching it ends a run with `collided`. */
  readonly deadly: boolean;
  /** What it does to the astronaut. */
  readonly about: string;
  /** The key that selects the editor's tool for it; null if it cannot be placed. */
  readonly letter: string | null;
}

/**
 * A kind of object: everything that schema, editor, pictures and reports know of it. What it does in a run is up to the engine.
 */
export interface Kind extends Appearance {
  /**
   * The key of the list in a level file that holds objects of this kind, each with an id. null: a level has exactly one, under
   * the kind's own name and without an id.
   */
  readonly list: string | null;
  /** What the list is for. */
  readonly aboutList: string;
  /** Fields by key, in the order of a file. */
  readonly fields: Readonly<Record<string, Field>>;
  /** The fields that are places, px. The first is where the object is; moving an object moves all of them. */
  readonly places: readonly [Pair, ...Pair[]];
  /** The fields that are vectors, by the name of the vector. */
  readonly vectors: Readonly<Record<string, Pair>>;
  /** The field that is the radius of the disc around each of the object's places, px; null if it has none. */
  readonly radius: 'radius' | null;
  /** How objects of this kind are presented whose `flag` is true. */
  readonly variant?: Appearance & { readonly flag: string };
  /**
   * What the original game calls the kind, and its fields that have another name there; null if the original does not have it.
   */
  readonly original: { readonly key: string; readonly fields?: Readonly<Record<string, string>> } | null;
}
