import {
  closestName,
  type Finding,
  formatValue,
  KINDS,
  LEVEL_VERSION,
  type ObjectKind,
  type Path,
  quote,
  SINGLE_KINDS,
  toPointer,
} from '../../basics/index.ts';
import { isObject, type Json, otherEditor, readJson, toProblems, withoutExtensions } from '../../json/index.ts';
import { checkMeaning, checkShape, type LevelFile, withIds } from '../../level/index.ts';
import type { ImportReading } from '../import-original.ts';
import { LevelMaker, type Made, ownValue } from './level-maker.ts';
import { MAP_KEYS, OFFSET, PARTNER, POINT_KINDS } from './map.ts';
import { MapReader, type ReadObject, type ReadProperty } from './map-objects.ts';
import { hintForType, isNumeric, typeHint } from './property-type.ts';
import { isTmx, readMapSource } from './read-tmx.ts';

/** The longest name of a level. */
const LONGEST_NAME = 120;

/** Pairs the objects of a kind that has two places: one of them names the other. */
function pairs(objects: readonly ReadObject[], kind: ObjectKind, reader: MapReader): (readonly [ReadObject, ReadObject])[] {
  const byId = new Map(objects.map((object) => [object.id, object]));
  const taken = new Set<ReadObject>();
  const found: (readonly [ReadObject, ReadObject])[] = [];
  const one = KINDS[kind].one;
  const refuse = ({ path, title }: ReadObject, message: string): void => {
    const hint = `Give one of the two mouths a property "${PARTNER}" of type object, and choose the other mouth.`;
    reader.find('unpaired-mouth', path, `${title}: ${message}`, hint);
  };
  const firstOf = new Map<ReadObject, ReadObject>();
  for (const object of objects) {
    const property = object.properties.get(PARTNER);
    // Tiled writes 0 for "no object"
    if (property === undefined || property.value === 0) continue;
    const other = typeof property.value === 'number' ? byId.get(property.value) : undefined;
    if (other === undefined || other === object) {
      taken.add(object);
      refuse(
        object,
        `expected the other mouth of the ${one} as "${PARTNER}", found ${other === object ? 'itself' : formatValue(property.value)}`,
      );
    } else if (!taken.has(object) && !taken.has(other)) {
      taken.add(object);
      taken.add(other);
      found.push([object, other]);
      firstOf.set(object, other);
      // both may name each other
    } else if (firstOf.get(other) !== object) {
      taken.add(object);
      refuse(object, `expected a mouth without another partner as "${PARTNER}", found ${other.title}`);
    }
  }
  for (const object of objects) if (!taken.has(object)) refuse(object, `expected the other mouth of the ${one}, found none`);
  return found;
}

/** Reads the properties of a map into a level, and says where they are. */
function takeMapProperties(
  reader: MapReader,
  properties: ReadonlyMap<string, ReadProperty>,
  level: Record<string, unknown>,
): Map<string, Path> {
  const paths = new Map<string, Path>();
  for (const property of properties.values()) {
    const { name, value, path } = property;
    if (name.startsWith('x-')) {
      level[name] = ownValue(property);
    } else if (Object.hasOwn(MAP_KEYS, name)) {
      paths.set(name, path);
      level[name] = MAP_KEYS[name] ? jsonOf(reader, property) : value;
    } else if (!(OFFSET as readonly string[]).includes(name)) {
      const meant = closestName(name, Object.keys(MAP_KEYS));
      reader.notes.push(`ignored the property ${quote(name)} of the map${meant === null ? '' : `: did you mean "${meant}"?`}`);
    }
  }
  return paths;
}

function jsonOf(reader: MapReader, { name, value, path }: ReadProperty): unknown {
  const json = typeof value === 'string' ? readJson(value, 'skip') : null;
  if (json?.ok === true && json.findings.length === 0) return json.value;
  const first = json === null || json.ok ? null : json.problems[0];
  const why = first === null ? formatValue(value) : `a text that is not JSON: ${first.message}`;
  reader.find(
    'wrong-type',
    path,
    `the property "${name}" of the map: expected JSON as text, found ${why}`,
    `Write ${name} as in a level file.`,
  );
  return undefined;
}

function offsetOf(reader: MapReader, properties: ReadonlyMap<string, ReadProperty>): number[] {
  return OFFSET.map((name) => {
    const property = properties.get(name);
    if (property === undefined || typeof property.value === 'number') return (property?.value as number | undefined) ?? 0;
    const message = `the property "${name}" of the map: expected a number, found ${formatValue(property.value)}`;
    const hint = isNumeric(property.type) ? 'Write how far the level is moved, px.' : typeHint(property.name, 'float');
    reader.find('wrong-type', property.path, message, hint);
    return 0;
  });
}

/** Reports kinds of which a level has exactly one, and the map none or several. */
function checkSingles(made: readonly Made[], reader: MapReader, isComplete: boolean): void {
  for (const kind of SINGLE_KINDS) {
    const [first, ...others] = made.filter((one) => one.kind === kind);
    const { one } = KINDS[kind];
    for (const { source } of others) {
      const message = `${source.title}: a level has exactly one ${one}, and ${first.source.title} is one already`;
      reader.find('one-per-level', source.path, message, 'Remove one of the two, or set another Class.');
    }
    // an object with a mistake may be the one that is missing
    if (first === undefined && isComplete) {
      const message = `expected an object of class "${kind}", found none`;
      reader.find('missing-key', [], message, `Add ${POINT_KINDS.includes(kind) ? 'a point' : 'a circle'} of class "${kind}".`);
    }
  }
}

/** Puts findings about the level where the map has what they are about. */
function placed(
  findings: readonly Finding[],
  places: ReadonlyMap<string, { readonly path: Path; readonly title: string }>,
  reader: MapReader,
): Finding[] {
  return findings.map((finding) => {
    for (let length = finding.path.length; length > 0; length--) {
      const place = places.get(toPointer(finding.path.slice(0, length)));
      if (place !== undefined) {
        const message = place.title === '' ? finding.message : `${place.title}: ${finding.message}`;
        const property = finding.code === 'wrong-type' ? reader.propertyAt(place.path) : undefined;
        const hint = (property === undefined ? null : hintForType(property, finding.path)) ?? finding.hint;
        return { ...finding, message, hint, path: place.path, part: 'value' };
      }
    }
    return { ...finding, path: [], part: 'value' };
  });
}

function addTo(level: Record<string, unknown>, list: string, values: Json): void {
  const before = level[list] as Json[] | undefined;
  if (before === undefined) level[list] = [values];
  else before.push(values);
}

/** Ids tell objects apart. A copy made in Tiled has the id of its original, and gets one of its own. */
function withoutCopiedIds(made: readonly Made[], notes: string[]): void {
  const seen = new Set<unknown>();
  for (const { values, source } of made) {
    if (values.id === undefined) continue;
    if (seen.has(values.id)) {
      notes.push(`${source.title} has the id of another object: it gets one of its own`);
      delete values.id;
    } else {
      seen.add(values.id);
    }
  }
}

/**
 * Tells whether a file is a Tiled map rather than a level or a file of the original game.
 *
 * @param source - the bytes of the file, or its text
 * @returns true for a JSON object that says so, and for an XML file with a map
 */
export function isTiledMap(source: Uint8Array | string): boolean {
  if (isTmx(source)) return true;
  const read = readMapSource(source);
  if (!read.ok) return false;
  const { value } = read;
  return (
    isObject(value) &&
    (value.type === 'map' || (Array.isArray(value.layers) && (value.tilewidth !== undefined || value.orientation !== undefined)))
  );
}

/** Options of {@link importTiled}. */
export interface ImportTiledOptions {
  /** The name of the level's file, without ending; the level's own name, too, where the map does not give one. */
  readonly slug: string;
}

/**
 * Reads a Tiled map (`.tmj`, or `.tmx` in XML) whose objects have the kinds of a level as classes. Throws nothing for any
 * content.
 *
 * @param source - the bytes of the file, or its text
 * @param options - the name of the level's file
 * @returns the level and notes on what was ignored, or every problem found
 */
export function importTiled(source: Uint8Array | string, { slug }: ImportTiledOptions): ImportReading {
  const read = readMapSource(source);
  if (!read.ok) return { ok: false, problems: read.problems, text: read.text };
  const { value: map, locator, text } = read;
  const reader = new MapReader();
  const fail = (findings: readonly Finding[]): ImportReading => ({ ok: false, problems: toProblems(findings, locator), text });
  const other = otherEditor(map, 'a Tiled map');
  if (other !== null) return fail([other]);
  if (!isObject(map)) {
    reader.find('wrong-type', [], `expected a Tiled map, found ${formatValue(map)}`, 'Save the map again in Tiled.');
    return fail(reader.findings);
  }
  if (map.orientation !== undefined && map.orientation !== 'orthogonal') {
    const message = `expected an orthogonal map, found ${formatValue(map.orientation)} as orientation`;
    reader.find('unsupported-map', ['orientation'], message, 'Set Orientation to Orthogonal in Map > Map Properties.');
    return fail(reader.findings);
  }
  const properties = reader.properties(map, [], 'the map');
  const offset = offsetOf(reader, properties);
  reader.layers(map, [], { x: 0, y: 0 });
  if (Array.isArray(map.tilesets) && map.tilesets.length > 0) reader.notes.push('ignored the tilesets of the map');

  const maker = new LevelMaker(reader, offset);
  const paired = new Map<ObjectKind, ReadObject[]>();
  for (const object of reader.objects) {
    const meaning = maker.meaningOf(object);
    if (meaning === null) continue;
    if (!object.isVisible) reader.noteHidden(object.title);
    if (KINDS[meaning.kind].places.length === 1) maker.make(meaning, object, null);
    else paired.set(meaning.kind, [...(paired.get(meaning.kind) ?? []), object]);
  }
  for (const [kind, objects] of paired) {
    for (const [first, second] of pairs(objects, kind, reader)) maker.make({ kind, flag: null }, first, second);
  }
  checkSingles(maker.made, reader, reader.findings.length === 0);
  withoutCopiedIds(maker.made, reader.notes);

  const level: Record<string, unknown> = { version: LEVEL_VERSION, name: (slug === '' ? 'level' : slug).slice(0, LONGEST_NAME) };
  const places = new Map<string, { path: Path; title: string }>();
  for (const [key, path] of takeMapProperties(reader, properties, level)) {
    if (level[key] === undefined) delete level[key];
    places.set(`/${key}`, { path, title: '' });
  }
  for (const kind of SINGLE_KINDS) level[kind] = { x: 0, y: 0 };
  for (const { kind, values, source, paths } of maker.made) {
    const { list } = KINDS[kind];
    if (list === null) level[kind] = values;
    else addTo(level, list, values);
    const pointer = list === null ? `/${kind}` : `/${list}/${(level[list] as Json[]).length - 1}`;
    places.set(pointer, { path: source.path, title: source.title });
    for (const [name, path] of paths) places.set(`${pointer}/${name}`, { path, title: source.title });
  }
  const checked = withoutExtensions(level);
  const findings = [
    ...read.findings,
    ...reader.findings,
    ...placed([...checkShape(checked), ...checkMeaning(checked)], places, reader),
  ];
  if (findings.length > 0) return fail(findings);
  return { ok: true, levels: [{ slug, file: withIds(level as unknown as LevelFile) }], notes: reader.notes };
}
