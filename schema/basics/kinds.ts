import { LIMITS } from './limits.ts';

const coordinate = (about: string) =>
  ({ type: 'number', unit: 'px', least: -LIMITS.coordinate, most: LIMITS.coordinate, step: 1, about }) as const;

const at = {
  x: coordinate('Place in px, from left to right.'),
  y: coordinate('Place in px, from top to bottom.'),
} as const;

const velocity = (direction: string, label: string) =>
  ({
    type: 'number',
    unit: 'px/s',
    least: -LIMITS.velocity,
    most: LIMITS.velocity,
    step: 1,
    default: 0,
    about: `Speed ${direction} at the start, px/s; 0 when left out.`,
    label,
  }) as const;

const size = { type: 'number', unit: 'px', least: LIMITS.leastRadius, most: LIMITS.radius, step: 1 } as const;

/** A radius that a file must have. `note` is appended to its description. */
const radius = (initial: number, note: string) => ({ ...size, initial, about: `Radius in px; ${note}.` }) as const;

const optionalRadius = <const R extends number>(usual: R) =>
  ({ ...size, default: usual, about: `Radius in px; ${usual} when left out.` }) as const;

/** The strongest wind, px/s² along each axis. */
const STRONGEST = 100;

const acceleration = <const A extends number>(usual: A, direction: string, label: string) =>
  ({
    type: 'number',
    unit: 'px/s2',
    least: -STRONGEST,
    most: STRONGEST,
    step: 1,
    default: usual,
    about: `Acceleration ${direction}, px/s2; ${usual} when left out.`,
    label,
  }) as const;

/** Every kind of object, in the order of a file. The types of levels are derived from it. */
const TABLE = {
  astronaut: {
    one: 'astronaut',
    many: 'astronauts',
    list: null,
    about: 'Where she starts: the centre of a box of 20 x 32 px.',
    aboutList: '',
    deadly: false,
    letter: null,
    fields: { ...at, vx: velocity('to the right', 'speed x'), vy: velocity('downwards', 'speed y') },
    places: [['x', 'y']],
    vectors: { velocity: ['vx', 'vy'] },
    radius: null,
    original: { key: 'player' },
  },
  blackHole: {
    one: 'black hole',
    many: 'black holes',
    list: null,
    about: 'Touching it completes the level.',
    aboutList: '',
    deadly: false,
    letter: null,
    fields: { ...at, radius: optionalRadius(18) },
    places: [['x', 'y']],
    vectors: {},
    radius: 'radius',
    original: { key: 'target' },
  },
  asteroid: {
    one: 'asteroid',
    many: 'asteroids',
    counted: ['cold asteroid', 'cold asteroids'],
    list: 'asteroids',
    about: 'Pulls her while it is the nearest asteroid and the gun is held.',
    aboutList: 'What the gun can target.',
    deadly: false,
    letter: 'a',
    fields: {
      ...at,
      radius: radius(16, 'the original uses 16 and 32'),
      hot: {
        type: 'flag',
        default: false,
        about: 'A hot asteroid pulls like a cold one, and kills on touch; false when left out.',
        ends: ['cold', 'hot'],
      },
    },
    places: [['x', 'y']],
    vectors: {},
    radius: 'radius',
    variant: {
      flag: 'hot',
      one: 'hot asteroid',
      many: 'hot asteroids',
      deadly: true,
      about: 'Pulls her as a cold one does while it is the nearest asteroid and the gun is held. Kills on touch.',
      letter: 'h',
    },
    original: { key: 'asteroids', fields: { hot: 'enemy' } },
  },
  nova: {
    one: 'nova',
    many: 'novae',
    counted: ['dwarf nova', 'dwarf novae'],
    list: 'novae',
    about: 'A dwarf nova kills on touch; the gun never targets it.',
    aboutList: 'Kill on touch; never a target.',
    deadly: true,
    letter: 'n',
    fields: { ...at, radius: radius(16, 'the original uses 16 and 32') },
    places: [['x', 'y']],
    vectors: {},
    radius: 'radius',
    original: { key: 'novae' },
  },
  repulsor: {
    one: 'repulsor',
    many: 'repulsors',
    counted: ['repulsor field', 'repulsor fields'],
    list: 'repulsors',
    about:
      'A field that pushes her away from its centre at 20 px/s2 while her centre is inside; where fields overlap, the first one.',
    aboutList: 'Fields that push her away.',
    deadly: false,
    letter: 'r',
    fields: { ...at, radius: radius(32, 'the original uses 32 and 48') },
    places: [['x', 'y']],
    vectors: {},
    radius: 'radius',
    original: { key: 'antiForceFields' },
  },
  alien: {
    one: 'alien',
    many: 'aliens',
    list: 'aliens',
    about: 'Sleeps until her centre is nearer than 150 px, then accelerates towards her. Kills on touch; two that touch explode.',
    aboutList: 'Chase her when she comes near.',
    deadly: true,
    letter: 'e',
    fields: { ...at, radius: optionalRadius(25) },
    places: [['x', 'y']],
    vectors: {},
    radius: 'radius',
    original: { key: 'aliens' },
  },
  mineral: {
    one: 'mineral',
    many: 'minerals',
    list: 'minerals',
    about: 'Collected on touch; not needed to complete the level.',
    aboutList: 'To collect on the way; usually three.',
    deadly: false,
    letter: 'm',
    fields: { ...at, radius: optionalRadius(7) },
    places: [['x', 'y']],
    vectors: {},
    radius: 'radius',
    original: { key: 'goodies' },
  },
  wind: {
    one: 'wind',
    many: 'winds',
    list: 'winds',
    about: 'A disc in which a steady acceleration is added to whatever else acts on her.',
    aboutList: 'Discs in which a steady wind blows.',
    deadly: false,
    letter: 'b',
    fields: {
      ...at,
      radius: radius(96, 'the disc in which it blows'),
      ax: acceleration(0, 'to the right', 'wind x'),
      ay: acceleration(-20, 'downwards', 'wind y'),
    },
    places: [['x', 'y']],
    vectors: { acceleration: ['ax', 'ay'] },
    radius: 'radius',
    original: null,
  },
  wormhole: {
    one: 'wormhole',
    many: 'wormholes',
    list: 'wormholes',
    about: 'Two mouths: when her centre enters one of them, she goes on from the other, as far from its centre.',
    aboutList: 'Pairs of discs that lead to each other.',
    deadly: false,
    letter: 'o',
    fields: {
      ...at,
      toX: { ...coordinate('Place of the second mouth in px, from left to right.'), label: 'to x' },
      toY: { ...coordinate('Place of the second mouth in px, from top to bottom.'), label: 'to y' },
      radius: radius(32, 'of both mouths'),
    },
    places: [
      ['x', 'y'],
      ['toX', 'toY'],
    ],
    vectors: {},
    radius: 'radius',
    original: null,
  },
} as const satisfies Readonly<Record<string, Kind>>;

type Table = typeof TABLE;

/** The name of a kind of object. */
export type ObjectKind = keyof Table;

/** The kinds of which a level has exactly one. */
export type SingleKind = { [K in ObjectKind]: Table[K]['list'] extends null ? K : never }[ObjectKind];

/** The kinds of which a level has a list. */
export type ListedKind = Exclude<ObjectKind, SingleKind>;

/** The key of the list that holds a kind in a level file. */
export type ListOf<K extends ListedKind> = Table[K]['list'] & string;
/** The keys of all lists of objects in a level file. */
export type ObjectList = ListOf<ListedKind>;

/** The fields of a kind, without `id`. */
export type FieldsOf<K extends ObjectKind> = Table[K]['fields'];

/** The keys of all fields of all kinds. */
export type FieldName = { [K in ObjectKind]: keyof FieldsOf<K> }[ObjectKind];

/** The type of a field's value. */
export type ValueOf<F> = F extends { readonly type: 'number' } ? number : boolean;

/** The flags that turn the objects of a kind into something else for people, such as `hot`. */
export type VariantFlag = {
  [K in ObjectKind]: Table[K] extends { readonly variant: { readonly flag: infer F extends string } } ? F : never;
}[ObjectKind];

/** Every kind of object, in the order of a file. This table is the only list of the kinds. */
export const KINDS: Readonly<Record<ObjectKind, Kind>> = TABLE;

/** The names of all kinds, in the order of a file. */
export const OBJECT_KINDS = Object.keys(TABLE) as readonly ObjectKind[];
/** The names of the kinds of which a level has exactly one. */
export const SINGLE_KINDS = OBJECT_KINDS.filter((kind) => KINDS[kind].list === null) as readonly SingleKind[];
/** The names of the kinds of which a level has a list, in the order of a file. */
export const LISTED_KINDS = OBJECT_KINDS.filter((kind) => KINDS[kind].list !== null) as readonly ListedKind[];

/**
 * The list of a kind.
 *
 * @param kind - the kind
 * @returns the key of its list in a level file
 */
export const listOf = <K extends ListedKind>(kind: K): ListOf<K> => TABLE[kind].list as ListOf<K>;

/** The keys of the lists of objects in a level, in the order of a file. */
export const OBJECT_LISTS: readonly ObjectList[] = LISTED_KINDS.map(listOf);

const KIND_OF_LIST = Object.fromEntries(LISTED_KINDS.map((kind) => [listOf(kind), kind])) as Readonly<
  Record<ObjectList, ListedKind>
>;

/**
 * The kind of a list.
 *
 * @param list - the key of a list in a level file
 * @returns the kind of its objects
 */
export const kindOfList = (list: ObjectList): ListedKind => KIND_OF_LIST[list];

/** What a tool of the editor places: a kind, or the variant of a kind, named by its flag. */
export type Placeable = ListedKind | VariantFlag;

/**
 * Everything that can be placed, in the order of the editor's tools: the kinds in the order of a file, each followed by its
 * variant.
 */
export const PLACEABLES: readonly Placeable[] = LISTED_KINDS.flatMap((kind): Placeable[] => {
  const flag = KINDS[kind].variant?.flag as VariantFlag | undefined;
  return flag === undefined ? [kind] : [kind, flag];
});

/**
 * What a tool of the editor places.
 *
 * @param placeable - the tool
 * @returns the kind, and the flag that is true for the placed object, or null
 */
export function placedAs(placeable: Placeable): { readonly kind: ListedKind; readonly flag: VariantFlag | null } {
  const owner = LISTED_KINDS.find((kind) => KINDS[kind].variant?.flag === placeable);
  return owner === undefined ? { kind: placeable as ListedKind, flag: null } : { kind: owner, flag: placeable as VariantFlag };
}

/**
 * How a placeable is presented to people.
 *
 * @param placeable - a kind or variant
 * @returns its names and properties
 */
export function appearanceOf(placeable: Placeable): Appearance {
  const { kind, flag } = placedAs(placeable);
  return appearanceIf(kind, flag !== null);
}

/**
 * Tells whether an object is of its kind's variant.
 *
 * @param kind - the kind of the object
 * @param object - the object, as in a file or in a level
 * @returns whether the variant's flag is true; false if the kind has no variant
 */
export function isVariant(kind: ObjectKind, object: object): boolean {
  const flag = KINDS[kind].variant?.flag;
  return flag !== undefined && (object as Readonly<Record<string, unknown>>)[flag] === true;
}

const appearanceIf = (kind: ObjectKind, varied: boolean): Appearance =>
  varied ? (KINDS[kind].variant ?? KINDS[kind]) : KINDS[kind];

/**
 * How an object is presented to people.
 *
 * @param kind - the kind of the object
 * @param object - the object, as in a file or in a level
 * @returns its names and properties
 */
export const appearanceOfObject = (kind: ObjectKind, object: object): Appearance => appearanceIf(kind, isVariant(kind, object));

/**
 * The name of what was touched when an object of a kind ends a run. For asteroids it is `hot asteroid`, since cold ones end no
 * run.
 *
 * @param kind - the kind of the object
 * @returns the name, lower case
 */
export function nameWhenTouched(kind: ObjectKind): string {
  const { deadly, variant, one } = KINDS[kind];
  return !deadly && variant?.deadly === true ? variant.one : one;
}

/**
 * The places of an object. Most kinds have one; a wormhole has two.
 *
 * @param kind - the kind of the object
 * @param object - the object, as in a file or in a level
 * @returns its places, px; the first is its own `x` and `y`
 */
export function placesIn(
  kind: ObjectKind,
  object: { readonly x: number; readonly y: number },
): readonly { readonly x: number; readonly y: number }[] {
  const { places } = KINDS[kind];
  if (places.length === 1) return [object];
  const numbers = object as unknown as Readonly<Record<string, number>>;
  return places.map(([x, y]) => ({ x: numbers[x], y: numbers[y] }));
}

/**
 * The fields of a kind.
 *
 * @param kind - the kind
 * @returns pairs of key and field, in the order of a file
 */
export const fieldsOf = (kind: ObjectKind): readonly (readonly [name: string, field: Field])[] => FIELDS[kind];

const FIELDS = Object.fromEntries(OBJECT_KINDS.map((kind) => [kind, Object.entries(KINDS[kind].fields)])) as unknown as Readonly<
  Record<ObjectKind, readonly (readonly [string, Field])[]>
>;

/**
 * Tells whether a file must have a field.
 *
 * @param field - the field
 * @returns true if the field has no default
 */
export const isRequired = (field: NumberField | FlagField): boolean => field.default === undefined;

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
