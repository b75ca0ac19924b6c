import { levelJsonSchema, resolveLevel } from '../../../schema/index.ts';
import { type FoundObject, LIST_OF_KIND, type ObjectKind } from '../../document/index.ts';

/** One property that can be typed, as the schema of levels has it. */
export interface Field {
  readonly key: string;
  readonly type: 'number' | 'text' | 'flag';
  /** Least and most of a number; letters of a text. */
  readonly least: number;
  readonly most: number;
  /** What the schema says about it. */
  readonly about: string;
  /** px, px/s; null where it has none */
  readonly unit: string | null;
  /** What stands for it when it is left out; undefined: it can't be. */
  readonly fallback: number | string | boolean | undefined;
}

/** What the inspector shows at once. */
export type Subject = ObjectKind | 'level';

interface JsonSchema {
  readonly type?: string;
  readonly const?: unknown;
  readonly description?: string;
  readonly minimum?: number;
  readonly maximum?: number;
  readonly maxLength?: number;
  readonly properties?: Readonly<Record<string, JsonSchema>>;
  readonly items?: JsonSchema;
}

const TYPES: Readonly<Record<string, Field['type']>> = { number: 'number', string: 'text', boolean: 'flag' };

/** Set by the format or by the editor, not by people. */
const NOT_TYPED: ReadonlySet<string> = new Set(['$schema', 'version', 'id']);

function schemaOf(root: JsonSchema, subject: Subject): JsonSchema {
  if (subject === 'level') return root;
  if (subject === 'astronaut' || subject === 'blackHole') return root.properties?.[subject] ?? {};
  return root.properties?.[LIST_OF_KIND[subject]]?.items ?? {};
}

/** What a level with one of everything is when it leaves out all it can: every default by where it stands. */
function defaultsOf(subject: Subject): Readonly<Record<string, unknown>> {
  const at = { x: 0, y: 0 };
  const round = { ...at, radius: 1 };
  const level = resolveLevel({
    version: 1,
    name: 'level',
    astronaut: at,
    blackHole: at,
    asteroids: [round],
    novae: [round],
    repulsors: [round],
    aliens: [at],
    minerals: [at],
  });
  if (subject === 'level') return { ...level };
  if (subject === 'astronaut' || subject === 'blackHole') return { ...level[subject] };
  return { ...level[LIST_OF_KIND[subject]][0] };
}

const known = new Map<Subject, { readonly about: string; readonly fields: readonly Field[] }>();

/** The fields of a kind of object, or of the level itself, in the order of the schema; and what the schema says of it. */
export function fieldsOf(subject: Subject): { readonly about: string; readonly fields: readonly Field[] } {
  const made = known.get(subject);
  if (made !== undefined) return made;
  const schema = schemaOf(levelJsonSchema() as JsonSchema, subject);
  const required = (schema as { readonly required?: readonly string[] }).required ?? [];
  const defaults = defaultsOf(subject);
  const fields = Object.entries(schema.properties ?? {}).flatMap(([key, property]): Field[] => {
    const type = TYPES[property.type ?? ''];
    if (type === undefined || NOT_TYPED.has(key)) return [];
    const about = property.description ?? '';
    return [
      {
        key,
        type,
        least: property.minimum ?? 0,
        most: property.maximum ?? property.maxLength ?? Number.POSITIVE_INFINITY,
        about,
        unit: type === 'number' ? (/px\/s|px/.exec(about)?.[0] ?? null) : null,
        fallback: required.includes(key) ? undefined : (defaults[key] as Field['fallback']),
      },
    ];
  });
  const answer = { about: schema.description ?? '', fields };
  known.set(subject, answer);
  return answer;
}

const HOT = 'Pulls her as a cold one does while it is the nearest asteroid and the gun is held. Kills on touch.';

/** What an object is and does to her. */
export const aboutObject = ({ kind, object }: FoundObject): string =>
  'hot' in object && object.hot === true ? HOT : fieldsOf(kind).about;

const shared = new Map<string, readonly Field[]>();

/** The fields that all of these kinds have, with the tightest limits; a default only where it is the same for all. The same kinds give the same list. */
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
        fallback: all.every(({ fallback }) => fallback === field.fallback) ? field.fallback : undefined,
      },
    ];
  });
}
