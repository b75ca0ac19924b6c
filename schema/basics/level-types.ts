import type { AllowableCode } from './adjustable.ts';
import type { OwnRules } from './default-rules.ts';
import {
  type FieldsOf,
  KINDS,
  LISTED_KINDS,
  type ListedKind,
  type ListOf,
  type ObjectKind,
  type ObjectList,
  type SingleKind,
  type ValueOf,
} from './kinds.ts';

// Apart from the schema of level files, so that declarations of engine and game do not need zod.

/** An object of a kind with every default filled in, as a {@link Level} has it. Only kinds with a list have an `id`. */
export type ObjectOf<K extends ObjectKind> = (K extends ListedKind ? { readonly id: string | null } : unknown) & {
  readonly [F in keyof FieldsOf<K>]: ValueOf<FieldsOf<K>[F]>;
};

/** The reasons why problems are meant in a level, by code. */
export type Allowed = { readonly [code in AllowableCode]?: string };

/** A place in a level. */
export interface Place {
  /** Distance to the right of the origin, px. */
  readonly x: number;
  /** Distance below the origin, px. */
  readonly y: number;
}

/** A disc in a level. */
export interface Disc extends Place {
  /** Radius, px. */
  readonly radius: number;
}

/** An object of a level that is a disc. */
export interface Circle extends Disc {
  /** The object's id; null if the file gives it none. */
  readonly id: string | null;
}

/** An asteroid of a level. */
export interface Asteroid extends Circle {
  /** Whether it is hot: deadly to touch. */
  readonly hot: boolean;
}

/** A hold: the gun is held from tick `press` up to, but not including, tick `release`. Ticks last 1/60 s. */
export type Hold = readonly [press: number, release: number];

/** A note at a tick of a run, as a level file has it. A {@link Level} has none: notes change nothing in play. */
export interface RunNote {
  /** The tick of 1/60 s that it is about. */
  readonly tick: number;
  /** What it says: 1 to 200 characters on one line. */
  readonly text: string;
}

/** A run that a level file contains. */
export interface ScriptedRun {
  /** Its name, unique in the level. */
  readonly name: string;
  /** When the gun is held. */
  readonly holds: readonly Hold[];
}

type LevelObjects = { readonly [K in SingleKind]: ObjectOf<K> } & {
  readonly [K in ListedKind as ListOf<K>]: readonly ObjectOf<K>[];
};

/**
 * A valid level with every default filled in. It also has a property for each kind of object: one object of
 * each {@link SingleKind}, such as `astronaut`, and a list for each {@link ListedKind}, such as `asteroids`. Lengths are in px,
 * velocities in px/s, accelerations in px/s².
 */
export interface Level extends LevelObjects {
  /** What players and reports call the level. */
  readonly name: string;
  /** What the level teaches or asks for; '' if the file has none. */
  readonly description: string;
  /** Farther than this from the centre of every asteroid she is lost, px. */
  readonly range: number;
  /** Whether the gun also pulls its target towards her. */
  readonly recoil: boolean;
  /** The rules that have another value in this level than in the original game; missing if there are none. */
  readonly rules?: OwnRules;
  /** The problems that are meant in this level, by code, each with the reason; missing if there are none. */
  readonly allow?: Allowed;
  /** The runs in the file; the first one is shown by default. */
  readonly runs: readonly ScriptedRun[];
}

/** Empty lists of objects, to start a level from. */
export const NO_OBJECTS = Object.fromEntries(LISTED_KINDS.map((kind) => [KINDS[kind].list, []])) as unknown as Readonly<
  Pick<Level, ObjectList>
>;

/** The objects of a kind in a level. */
export function objectsIn<K extends ObjectKind>(level: Level, kind: K): readonly ObjectOf<K>[] {
  const found = (level as unknown as Readonly<Record<string, unknown>>)[KINDS[kind].list ?? kind];
  return (KINDS[kind].list === null ? [found] : found) as readonly ObjectOf<K>[];
}
