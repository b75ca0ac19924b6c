import { fieldsOf, KINDS, OBJECT_KINDS, type Path } from '../../basics/index.ts';
import { LEVEL_SHAPE } from '../../level/index.ts';
import type { ReadProperty } from './map-objects.ts';

/** Types of properties for what a level file has as number, as true or false, and as text. */
const TYPES = { number: 'float', flag: 'bool', text: 'string' } as const;

type TiledType = (typeof TYPES)[keyof typeof TYPES];

/** Keys of a level that are properties of a map, and neither texts nor written as JSON. */
const OF_MAP: Readonly<Record<string, TiledType>> = { range: TYPES.number, recoil: TYPES.flag };

/** The type that a property of a map must have for a value of the level; null where a value has no such type. */
function typeAt(path: Path): TiledType | null {
  const [key, ...inner] = path.map(String);
  if (inner.length === 0) {
    if (Object.hasOwn(OF_MAP, key)) return OF_MAP[key];
    return Object.hasOwn(LEVEL_SHAPE.keys, key) ? TYPES.text : null;
  }
  const kind = OBJECT_KINDS.find((one) => (KINDS[one].list ?? one) === key);
  const name = inner.at(-1);
  if (kind === undefined || name === undefined) return null;
  if (name === 'id') return TYPES.text;
  const field = fieldsOf(kind).find(([known]) => known === name)?.[1];
  return field === undefined ? null : TYPES[field.type];
}

/** Whether Tiled keeps a number in a property of that type. */
export const isNumeric = (type: string): boolean => type === 'int' || type === 'float';

/** How a property gets another type. */
export const typeHint = (name: string, type: TiledType): string =>
  `Set the type of the property "${name}" to ${type} in Tiled: remove it, and add it again with that type.`;

/** What to do about a property whose value has the wrong type; null if its type is right, and so its value is not. */
export function hintForType({ name, type }: ReadProperty, path: Path): string | null {
  const wanted = typeAt(path);
  const declared = isNumeric(type) ? TYPES.number : type;
  return wanted === null || declared === wanted ? null : typeHint(name, wanted);
}
