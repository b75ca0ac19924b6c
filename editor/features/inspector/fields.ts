import {
  appearanceOfObject,
  fieldsOf as fieldsOfKind,
  KINDS,
  type LevelFile,
  type ObjectKind,
  resolveLevel,
} from '../../../schema/index.ts';
import { LEVEL_SHAPE, LEVEL_WORDS, type Shape } from '../../../schema/level/index.ts';
import type { FoundObject } from '../../core/document/index.ts';

/** A property that can be edited. */
export interface Field {
  readonly key: string;
  /** Its label in the inspector. */
  readonly label: string;
  readonly type: 'number' | 'text' | 'flag';
  /** the range of a number; for a text, the greatest length in characters */
  readonly least: number;
  readonly most: number;
  /** The change of a number per key or per px of a drag. */
  readonly step: number;
  /** What it means. */
  readonly about: string;
  /** px, px/s, px/s2; null if it has none */
  readonly unit: string | null;
  /** The default; undefined if the property is required. */
  readonly fallback: number | string | boolean | undefined;
  /** The names of the two states of a flag. */
  readonly ends: readonly [off: string, on: string];
}

/** What the inspector can show. */
export type Subject = ObjectKind | 'level';

interface Fields {
  readonly about: string;
  readonly fields: readonly Field[];
}

const TYPES: Readonly<Record<string, Field['type']>> = { number: 'number', string: 'text', boolean: 'flag' };

/** Set by the format, not by users. */
const NOT_TYPED: ReadonlySet<string> = new Set(['$schema', 'version']);

/** The fields of the level itself, from its shape. */
function fieldsOfLevel(): Fields {
  const at = { x: 0, y: 0 };
  // a level with nothing but the required properties
  const defaults = resolveLevel({ version: 1, name: 'level', astronaut: at, blackHole: at }) as unknown as Readonly<
    Record<string, unknown>
  >;
  const fields = Object.entries<Shape>(LEVEL_SHAPE.keys).flatMap(([key, shape]): Field[] => {
    const type = TYPES[shape.type ?? ''];
    if (type === undefined || NOT_TYPED.has(key)) return [];
    return [
      {
        key,
        label: key === 'description' ? 'about' : key,
        type,
        least: type === 'number' ? (shape.least ?? 0) : 0,
        most: shape.most ?? Number.POSITIVE_INFINITY,
        step: 1,
        about: LEVEL_WORDS[key] ?? '',
        unit: type === 'number' ? 'px' : null,
        fallback: shape.optional === true ? (defaults[key] as Field['fallback']) : undefined,
        ends: ['off', 'on'],
      },
    ];
  });
  return { about: LEVEL_WORDS[''], fields };
}

const fieldsOfObjects = (kind: ObjectKind): Fields => ({
  about: KINDS[kind].about,
  fields: fieldsOfKind(kind).map(
    ([key, field]): Field => ({
      key,
      label: field.label ?? key,
      type: field.type,
      least: field.type === 'number' ? field.least : 0,
      most: field.type === 'number' ? field.most : Number.POSITIVE_INFINITY,
      step: field.type === 'number' ? field.step : 1,
      about: field.about,
      unit: field.type === 'number' ? field.unit : null,
      fallback: field.default,
      ends: field.type === 'flag' ? field.ends : ['off', 'on'],
    }),
  ),
});

const known = new Map<Subject, Fields>();

/** The fields of a kind of object or of the level, in file order, and what it is. */
export function fieldsOf(subject: Subject): Fields {
  const made = known.get(subject);
  if (made !== undefined) return made;
  const fields = subject === 'level' ? fieldsOfLevel() : fieldsOfObjects(subject);
  known.set(subject, fields);
  return fields;
}

/** What an object is and does. */
export const aboutObject = ({ kind, object }: FoundObject): string => appearanceOfObject(kind, object).about;

const shared = new Map<string, readonly Field[]>();

/**
 * The fields that all of these kinds have, with the tightest limits, and a default only if they share it. Equal kinds give the
 * same list.
 */
export function sharedFields(kinds: Iterable<ObjectKind>): readonly Field[] {
  const all = [...new Set(kinds)];
  const made = shared.get(all.join());
  if (made !== undefined) return made;
  const fields = fieldsOfAll(all);
  shared.set(all.join(), fields);
  return fields;
}

function fieldsOfAll(kinds: readonly ObjectKind[]): readonly Field[] {
  const [first, ...others] = kinds.map((kind) => fieldsOf(kind).fields);
  return (first ?? []).flatMap((field) => {
    const twins = others.map((fields) => fields.find(({ key, type }) => key === field.key && type === field.type));
    if (twins.some((twin) => twin === undefined)) return [];
    const all = [field, ...(twins as Field[])];
    return [
      {
        ...field,
        about: all.every(({ about }) => about === field.about) ? field.about : '',
        least: Math.max(...all.map(({ least }) => least)),
        most: Math.min(...all.map(({ most }) => most)),
        step: Math.min(...all.map(({ step }) => step)),
        fallback: all.every(({ fallback }) => fallback === field.fallback) ? field.fallback : undefined,
      },
    ];
  });
}

/** What a field shows. */
export interface FieldValue {
  /** null if the selected objects differ */
  readonly value: number | string | boolean | null;
  /** The file has no value, so the default applies. */
  readonly isDefault: boolean;
}

type Json = Readonly<Record<string, unknown>>;

/** The value that objects have in common, with defaults filled in. */
export function valueOfObjects(objects: readonly FoundObject[], { key }: Field): FieldValue {
  const defaultOf = (kind: ObjectKind) => fieldsOf(kind).fields.find((field) => field.key === key)?.fallback;
  const shownOf = ({ kind, object }: FoundObject) => (object as unknown as Json)[key] ?? defaultOf(kind);
  const first = shownOf(objects[0]);
  return {
    value: objects.every((found) => shownOf(found) === first) ? ((first as FieldValue['value'] | undefined) ?? null) : null,
    isDefault: objects.every(({ object }) => (object as unknown as Json)[key] === undefined),
  };
}

/** The value of a field of the level itself. */
export function valueOfLevel(file: LevelFile, { key, fallback }: Field): FieldValue {
  const written = (file as Json)[key];
  return { value: ((written ?? fallback) as FieldValue['value'] | undefined) ?? null, isDefault: written === undefined };
}
