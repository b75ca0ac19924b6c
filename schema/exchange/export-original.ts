import {
  DEFAULT_RANGE,
  fieldsOf,
  KINDS,
  type Level,
  LISTED_KINDS,
  OBJECT_KINDS,
  type ObjectKind,
  objectName,
  type Path,
  type Problem,
  RULE_NAMES,
  toPointer,
} from '../basics/index.ts';
import type { Json } from '../json/index.ts';
import { type LevelDocument, type LevelFile, objectsOfFile, RULES } from '../level/index.ts';

/** A level object of the original game: plain JSON. */
export type OriginalLevel = { readonly [key: string]: unknown };

/** A level as the original game has it, and what it could not take over. */
export interface OriginalExport {
  /** The level object, without what is refused. */
  readonly object: OriginalLevel;
  /** What the original game does not have, each with its place: without it, the level plays differently. */
  readonly refused: readonly Problem[];
  /** What a level object has no place for, though it plays the same without it; a sentence for each. */
  readonly lost: readonly string[];
  /** What the original game reads otherwise than this toolkit does; a sentence for each. */
  readonly differences: readonly string[];
}

interface Picture {
  /** The name of the picture; that of one in several sizes ends with its diameter. */
  readonly key: string;
  /** The radii in which the picture exists, px; empty if there is one, of the size that is usual. */
  readonly radii: readonly number[];
}

const TWO_SIZES = [16, 32];

/** The pictures of the original game. It takes the size of an object from its picture. */
const PICTURES: Readonly<Partial<Record<ObjectKind, Picture>>> = {
  astronaut: { key: 'player', radii: [] },
  blackHole: { key: 'target', radii: [] },
  asteroid: { key: 'asteroid', radii: TWO_SIZES },
  nova: { key: 'nova', radii: TWO_SIZES },
  repulsor: { key: 'antiForceField', radii: [32, 48] },
  alien: { key: 'alien', radii: [] },
};

const HOT_PICTURE: Picture = { key: 'thermoAsteroid', radii: TWO_SIZES };

/** Size of the world in which the original game's camera moves, px. */
const WORLD = { width: 1424, height: 1624 };

/** The lists that every level object has, even if they are empty: the original game reads the first one unasked. */
const ALWAYS: readonly ObjectKind[] = ['asteroid', 'nova', 'mineral'];

const nearest = (radii: readonly number[], radius: number): number =>
  radii.reduce((best, one) => (Math.abs(one - radius) < Math.abs(best - radius) ? one : best));

/** Whether the original game has an object of this size. */
function hasSize(kind: ObjectKind, radius: number): boolean {
  const usual = PICTURES[kind]?.radii ?? [];
  const field = KINDS[kind].fields.radius;
  return usual.length > 0 ? usual.includes(radius) : field?.type !== 'number' || field.default === radius;
}

function pictureOf(kind: ObjectKind, object: Json): string | undefined {
  const picture = kind === 'asteroid' && object.hot === true ? HOT_PICTURE : PICTURES[kind];
  if (picture === undefined || picture.radii.length === 0) return picture?.key;
  return `${picture.key}_${2 * nearest(picture.radii, object.radius as number)}`;
}

/** An object under the original's names. What the file leaves out stays out, except where the original always has it. */
function exportObject(kind: ObjectKind, object: Json): OriginalLevel {
  const names = KINDS[kind].original?.fields ?? {};
  const fields = fieldsOf(kind).map(([name, field]) => {
    const isAlways = KINDS[kind].list === null ? name === 'radius' : field.type === 'flag';
    const value = object[name] ?? (isAlways ? field.default : undefined);
    return [names[name] ?? name, value] as const;
  });
  const key = pictureOf(kind, object);
  return Object.fromEntries([...fields, ['key', key] as const].filter(([, value]) => value !== undefined));
}

/** Says what the original game does not have, with places. */
function refusals(level: Level, { file, locate }: LevelDocument): Problem[] {
  const problems: Problem[] = [];
  const refuse = (path: Path, message: string, hint: string): void => {
    const pointer = toPointer(path);
    const place = path.length === 0 ? { line: null, column: null } : locate(pointer);
    problems.push({ code: 'not-in-original', severity: 'error', message, hint, pointer, ...place });
  };
  if (!level.recoil) {
    const path = file.recoil === undefined ? [] : ['recoil'];
    const message = 'recoil: expected true, as the original game always has it, found false';
    refuse(path, message, 'Write "recoil": true and check the runs again, or leave this out with --drop.');
  }
  const undecided = file.conflicts?.length ?? 0;
  if (undecided > 0) {
    const message = `expected a level whose merge is finished, found ${undecided} undecided in "conflicts"`;
    refuse(['conflicts'], message, 'Decide them in the editor (gq edit), or remove the list.');
  }
  for (const name of RULE_NAMES) {
    const value = level.rules?.[name];
    if (value === undefined) continue;
    const isOwn = file.rules?.[name] !== undefined;
    const message = `the rule ${name}: expected ${RULES[name].default}, the original game's, found ${value}${isOwn ? '' : ', which gq.config.json sets'}`;
    const hint = 'Remove the rule and check the runs again, or leave this out with --drop.';
    refuse(isOwn ? ['rules', name] : [], message, hint);
  }
  for (const kind of LISTED_KINDS) {
    const { list, original, many } = KINDS[kind];
    if (original !== null || list === null) continue;
    for (const i of objectsOfFile(file, kind).keys()) {
      const message = `${objectName(kind, i)}: the original game has no ${many}`;
      refuse([list, i], message, `Remove it and check the runs again, or leave out all ${many} with --drop.`);
    }
  }
  return problems;
}

const words = (names: readonly string[]): string =>
  names.length > 3 ? `${names.slice(0, 3).join(', ')} and ${names.length - 3} more` : names.join(', ');

function* everyObject(file: LevelFile): Generator<readonly [kind: ObjectKind, object: Json, name: string]> {
  for (const kind of OBJECT_KINDS) {
    if (KINDS[kind].original === null) continue;
    for (const [i, object] of objectsOfFile(file, kind).entries()) yield [kind, object, objectName(kind, i, object)];
  }
}

/** Keys of a level file that are in the level object, are refused, or are named in words. */
const SAID: readonly string[] = [
  ...['$schema', 'version', 'name', 'description', 'range', 'recoil', 'rules', 'runs', 'conflicts'],
  ...OBJECT_KINDS.map((kind) => KINDS[kind].list ?? kind),
];

function lostIn(file: LevelFile): string[] {
  const lost = ['its name'];
  if (file.description !== undefined) lost.push('its description');
  const runs = file.runs?.length ?? 0;
  if (runs > 0) lost.push(runs === 1 ? 'its run' : `its ${runs} runs`);
  for (const key of Object.keys(file)) if (!SAID.includes(key) && !key.startsWith('x-')) lost.push(JSON.stringify(key));
  const objects = [...everyObject(file)].map(([, object]) => object);
  if (objects.some(({ id }) => id !== undefined)) lost.push('the ids of its objects');
  const isOwn = (object: object): boolean => Object.keys(object).some((key) => key.startsWith('x-'));
  if (isOwn(file) || objects.some(isOwn)) lost.push('keys that begin with x-');
  return [`a level object has no place for ${lost.join(', ')}`];
}

function differencesIn(file: LevelFile): string[] {
  const differences: string[] = [];
  const sized: string[] = [];
  const outside: string[] = [];
  for (const [kind, object, name] of everyObject(file)) {
    if (object.radius !== undefined && !hasSize(kind, object.radius as number)) sized.push(`${name} (${object.radius})`);
    const [x, y] = [object.x as number, object.y as number];
    if (x < 0 || y < 0 || x > WORLD.width || y > WORLD.height) outside.push(name);
  }
  if (sized.length > 0) {
    differences.push(`the original game has no picture of this radius and takes the size from its pictures: ${words(sized)}`);
  }
  if (outside.length > 0) {
    differences.push(`outside of the original game's world of ${WORLD.width} x ${WORLD.height} px: ${words(outside)}`);
  }
  const { vx = 0, vy = 0 } = file.astronaut;
  if (vx !== 0 || vy !== 0) differences.push('the original game starts the astronaut at rest; gq import reads her speed');
  return differences;
}

/**
 * Turns a level into a level object of the original game, as {@link importOriginal} reads them. Importing the object gives the
 * same level, but for its name, its runs and ids.
 *
 * @param level - the level, with the rules of its folder
 * @param source - the level's file
 * @returns the object, and what it does not say
 */
export function exportOriginal(level: Level, source: LevelDocument): OriginalExport {
  const { file } = source;
  const lists = new Map<ObjectKind, OriginalLevel[]>();
  const singles = new Map<ObjectKind, OriginalLevel>();
  for (const [kind, object] of everyObject(file)) {
    const exported = exportObject(kind, object);
    if (KINDS[kind].list === null) singles.set(kind, exported);
    else if (lists.has(kind)) lists.get(kind)?.push(exported);
    else lists.set(kind, [exported]);
  }
  const object: Record<string, unknown> = {};
  for (const kind of OBJECT_KINDS) {
    const { original } = KINDS[kind];
    const value = singles.get(kind) ?? lists.get(kind) ?? (ALWAYS.includes(kind) ? [] : undefined);
    if (original !== null && value !== undefined) object[original.key] = value;
  }
  object.maxDistance = file.range ?? DEFAULT_RANGE;
  return { object, refused: refusals(level, source), lost: lostIn(file), differences: differencesIn(file) };
}

const inline = (value: unknown): string => {
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const entries = Object.entries(value).map(([key, inner]) => `${JSON.stringify(key)}: ${JSON.stringify(inner)}`);
  return entries.length === 0 ? '{}' : `{ ${entries.join(', ')} }`;
};

function formatObject(object: OriginalLevel): string {
  const rows = Object.entries(object).map(([key, value]) => {
    const name = `    ${JSON.stringify(key)}: `;
    if (!Array.isArray(value)) return name + inline(value);
    return value.length === 0 ? `${name}[]` : `${name}[\n${value.map((one) => `      ${inline(one)}`).join(',\n')}\n    ]`;
  });
  return rows.length === 0 ? '  {}' : `  {\n${rows.join(',\n')}\n  }`;
}

/** A level object with the title that a module says before it. */
export interface TitledOriginal {
  /** The title; '' for none. A JSON file does not have it. */
  readonly title: string;
  /** The level object; empty for a placeholder. */
  readonly object: OriginalLevel;
}

/**
 * Writes level objects of the original game, one object a line.
 *
 * @param levels - the level objects, in order
 * @param shape - `json` for a JSON list; `module` for a CommonJS module that exports it, as the original game has
 * @returns the text of the file; {@link importOriginal} reads both
 */
export function formatOriginal(levels: readonly TitledOriginal[], shape: 'json' | 'module'): string {
  const comment = ({ title }: TitledOriginal): string =>
    // a line separator would end the comment
    shape === 'module' && title !== '' ? `  // ${title.replace(/[\p{Cc}\p{Zl}\p{Zp}]+/gu, ' ')}\n` : '';
  const rows = levels.map((one) => comment(one) + formatObject(one.object));
  const list = rows.length === 0 ? '[]' : `[\n${rows.join(',\n')}\n]`;
  return shape === 'json' ? `${list}\n` : `'use strict';\n\nmodule.exports = ${list};\n`;
}
