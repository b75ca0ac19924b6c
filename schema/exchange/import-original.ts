import {
  type Finding,
  fieldsOf,
  formatValue,
  isRequired,
  KINDS,
  LEVEL_VERSION,
  LIMITS,
  MAX_FILE_SIZE,
  MAX_FINDINGS,
  OBJECT_KINDS,
  type ObjectKind,
  type Path,
  type Problem,
  toWords,
} from '../basics/index.ts';
import { decodeUtf8, isObject, type Json, type JsonReading, otherEditor, readJson, toProblems } from '../json/index.ts';
import { type LevelFile, withIds } from '../level/index.ts';

/** A level of the original game, as a level file. */
export interface ImportedLevel {
  /** The file's name without `.level.json`: `level-NN` by the place in the list, from 0; `level-01` for a single object. */
  readonly slug: string;
  /** The content of the file, with ids. */
  readonly file: LevelFile;
}

/** The outcome of {@link importOriginal}: with `ok` true the levels, otherwise the problems. */
export type ImportReading =
  | {
      /** All levels could be read. */
      readonly ok: true;
      /** The levels, in the order of the file. */
      readonly levels: ImportedLevel[];
      /** What was ignored, one line each: empty placeholders, and keys without a meaning here. */
      readonly notes: string[];
    }
  | {
      /** The file could not be read. */
      readonly ok: false;
      /** What is wrong with it, in the order of the text; at least one. */
      readonly problems: Problem[];
      /** The text without a byte order mark; '' if the file is too large or not a text. */
      readonly text: string;
    };

/** Reads values of the original's objects, and collects what is wrong and what is ignored. */
class OriginalReader {
  readonly findings: Finding[] = [];
  readonly ignored = new Map<string, number>();

  find(code: Finding['code'], path: Path, message: string, hint: string): void {
    if (this.findings.length >= MAX_FINDINGS) return;
    const words = path.length === 0 ? '' : `${toWords(path)}: `;
    this.findings.push({ code, message: `${words}${message}`, hint, path, part: 'value' });
  }

  ignoreOthers(object: Json, known: readonly string[]): void {
    for (const key of Object.keys(object)) if (!known.includes(key)) this.ignored.set(key, (this.ignored.get(key) ?? 0) + 1);
  }

  missing(path: Path, key: string): void {
    const where = path.length === 0 ? '' : ` in ${toWords(path)}`;
    this.findings.push({
      code: 'missing-key',
      message: `the key "${key}" is missing${where}`,
      hint: `Add "${key}".`,
      path,
      part: 'value',
    });
  }

  /** A number from `least` to `most`; undefined if the key is missing, or its value wrong and reported. */
  number(object: Json, key: string, path: Path, least: number, most: number): number | undefined {
    if (!Object.hasOwn(object, key)) return undefined;
    const value = object[key];
    const at = [...path, key];
    if (typeof value !== 'number') {
      this.find('wrong-type', at, `expected a number, found ${formatValue(value)}`, 'Write a number.');
    } else if (value < least || value > most) {
      this.find(
        'out-of-limits',
        at,
        `expected a number from ${least} to ${most}, found ${value}`,
        'Write a number within these limits.',
      );
    } else {
      return value;
    }
    return undefined;
  }

  /** A radius or range in px, written as a number or as a text of digits. */
  size(object: Json, key: string, path: Path): number | undefined {
    if (!Object.hasOwn(object, key)) return undefined;
    const value = object[key];
    const size = typeof value === 'string' && /^\d+(\.\d+)?$/.test(value) ? Number(value) : value;
    const at = [...path, key];
    if (typeof size !== 'number') {
      this.find('wrong-type', at, `expected a number or a text of digits, found ${formatValue(value)}`, 'Write a number.');
    } else if (size < LIMITS.leastRadius || size > LIMITS.radius) {
      const limits = `from ${LIMITS.leastRadius} to ${LIMITS.radius}`;
      this.find('out-of-limits', at, `expected a number ${limits}, found ${size}`, `Write a number ${limits}.`);
    } else {
      return size;
    }
    return undefined;
  }

  flag(object: Json, key: string, path: Path, hint: string): boolean {
    const value = object[key];
    if (Object.hasOwn(object, key) && typeof value !== 'boolean') {
      this.find('wrong-type', [...path, key], `expected true or false, found ${formatValue(value)}`, hint);
    }
    return value === true;
  }

  one(level: Json, key: string, path: Path): Json | null {
    if (!Object.hasOwn(level, key)) {
      this.missing(path, key);
      return null;
    }
    const value = level[key];
    if (isObject(value)) return value;
    this.find(
      'wrong-type',
      [...path, key],
      `expected an object in { }, found ${formatValue(value)}`,
      'Write an object with x and y.',
    );
    return null;
  }

  list<T>(level: Json, key: string, path: Path, read: (object: Json, path: Path) => T): T[] | undefined {
    if (!Object.hasOwn(level, key)) return undefined;
    const value = level[key];
    const at = [...path, key];
    if (!Array.isArray(value)) {
      this.find('wrong-type', at, `expected a list in [ ], found ${formatValue(value)}`, 'Write a list of objects.');
      return undefined;
    }
    if (value.length > LIMITS.objects) {
      this.find('too-many', at, `expected at most ${LIMITS.objects} entries, found ${value.length}`, 'Remove entries.');
      return undefined;
    }
    const objects: T[] = [];
    for (let i = 0; i < value.length && this.findings.length < MAX_FINDINGS; i++) {
      const entry: unknown = value[i];
      if (isObject(entry)) objects.push(read(entry, [...at, i]));
      else
        this.find(
          'wrong-type',
          [...at, i],
          `expected an object in { }, found ${formatValue(entry)}`,
          'Write an object with x and y.',
        );
    }
    return objects.length === 0 ? undefined : objects;
  }
}

/** The kinds that the original has, and what it calls them. */
const KNOWN = OBJECT_KINDS.flatMap((kind) => {
  const { list, original } = KINDS[kind];
  return original === null ? [] : [{ kind, ours: list ?? kind, isOne: list === null, theirs: original.key }];
});

const LEVEL_KEYS = [...KNOWN.map(({ theirs }) => theirs), 'maxDistance'];

/** Reads an object of a kind. What the original may leave out and a level file must have is a problem. */
function readObject(reader: OriginalReader, kind: ObjectKind, object: Json, path: Path): Json {
  const { places, radius, original, variant } = KINDS[kind];
  const keyOf = (name: string): string => original?.fields?.[name] ?? name;
  const isPlace = (name: string): boolean => places.flat().includes(name);
  const fields = fieldsOf(kind);
  const read: Record<string, unknown> = {};
  const needs = (isWanted: (name: string) => boolean) => {
    for (const [name, field] of fields) {
      if (isWanted(name) && isRequired(field) && !Object.hasOwn(object, keyOf(name))) reader.missing(path, keyOf(name));
    }
  };
  for (const [name, field] of fields) {
    if (field.type !== 'flag') continue;
    const hint = variant?.flag === name ? `Write true for a ${variant.one}.` : 'Write true or false.';
    read[name] = reader.flag(object, keyOf(name), path, hint) ? true : undefined;
  }
  needs((name) => !isPlace(name));
  reader.ignoreOthers(
    object,
    fields.map(([name]) => keyOf(name)),
  );
  needs(isPlace);
  for (const [name, field] of fields) {
    if (field.type === 'flag') continue;
    const value =
      name === radius
        ? reader.size(object, keyOf(name), path)
        : reader.number(object, keyOf(name), path, field.least, field.most);
    // a wrong value has been reported, and then no level is made
    read[name] = value ?? (isRequired(field) ? field.least : undefined);
  }
  return Object.fromEntries(fields.map(([name]) => [name, read[name]]));
}

function readLevelObject(reader: OriginalReader, level: Json, path: Path, name: string, recoil: boolean): LevelFile {
  reader.ignoreOthers(level, LEVEL_KEYS);
  const objects = KNOWN.map(({ kind, ours, isOne, theirs }) => {
    const read = (object: Json, at: Path) => readObject(reader, kind, object, at);
    if (!isOne) return [ours, reader.list(level, theirs, path, read)];
    return [ours, read(reader.one(level, theirs, path) ?? { x: 0, y: 0 }, [...path, theirs])];
  });
  return {
    version: LEVEL_VERSION,
    name,
    range: reader.size(level, 'maxDistance', path),
    recoil: recoil ? true : undefined,
    ...(Object.fromEntries(objects) as Pick<LevelFile, 'astronaut' | 'blackHole'>),
  };
}

/** The command that writes what a module exports as JSON. */
const AS_JSON = `node -p "JSON.stringify(require('./FILE.js'))" > levels.json`;

/** Reads JSON, or a module that exports JSON. */
function readSource(source: Uint8Array | string): JsonReading {
  const module = source.length > MAX_FILE_SIZE ? null : readModule(source);
  if (module === null) return readJson(source, 'skip');
  const json = readJson(module.value, 'skip');
  if (json.ok) return { ...json, text: module.text };
  const [first, ...rest] = json.problems;
  if (first.code === 'merge-markers') return { ok: false, problems: json.problems, text: module.text };
  const hint = `Only a module that exports plain JSON can be read. Write its value as JSON: ${AS_JSON}.`;
  return { ok: false, problems: [{ ...first, hint }, ...rest], text: module.text };
}

/**
 * Reads levels of the original game: a JSON list of its level objects, or a single one; also a CommonJS module that exports
 * them as JSON. Throws nothing for any content.
 *
 * @param source - the bytes of the file, or its text
 * @param options - `recoil`: whether the levels have recoil, as in the original
 * @returns the levels and notes on what was ignored, or every problem found
 */
export function importOriginal(source: Uint8Array | string, options: { readonly recoil: boolean }): ImportReading {
  const json = readSource(source);
  if (!json.ok) return json;
  const { text, value, locator } = json;
  const other = otherEditor(value, 'levels of the original game or a Tiled map');
  if (other !== null) return { ok: false, problems: toProblems([other], locator), text };
  const reader = new OriginalReader();
  const levels: ImportedLevel[] = [];
  const skipped: string[] = [];
  const isList = Array.isArray(value);
  const entries: readonly unknown[] = isList ? value : [value];
  for (let i = 0; i < entries.length && reader.findings.length < MAX_FINDINGS; i++) {
    const entry = entries[i];
    const path: Path = isList ? [i] : [];
    const number = isList ? i : 1;
    if (!isObject(entry)) {
      const expected = isList ? 'an object in { }' : 'a level object of the original game or a list of them';
      reader.find(
        'wrong-type',
        path,
        `expected ${expected}, found ${formatValue(entry)}`,
        'Write an object with player and target.',
      );
    } else if (Object.keys(entry).length === 0) {
      skipped.push(isList ? toWords([i]) : 'the object');
    } else {
      const file = readLevelObject(reader, entry, path, `Level ${number}`, options.recoil);
      levels.push({ slug: `level-${String(number).padStart(2, '0')}`, file: withIds(file) });
    }
  }
  const findings = [...json.findings, ...reader.findings];
  if (findings.length === 0 && levels.length === 0) {
    const hint = 'Check that this is the file with the level objects.';
    findings.push({ code: 'nothing-to-import', message: 'there is no level in this file', hint, path: [], part: 'value' });
  }
  if (findings.length > 0) return { ok: false, problems: toProblems(findings, locator), text };

  const notes: string[] = [];
  if (skipped.length > 0) notes.push(`skipped ${skipped.join(', ')}: empty (a placeholder of the menu)`);
  if (reader.ignored.size > 0) {
    const keys = [...reader.ignored].map(([key, count]) => `${key} (${count} times)`.replace('(1 times)', '(once)'));
    notes.push(`ignored keys that have no meaning here: ${keys.join(', ')}`);
  }
  return { ok: true, levels, notes };
}

/** What stands before the value that a module exports. */
// a comment is matched with its line end: otherwise a line of slashes could be split in very many ways
const BEGINNING = /^(?:\s|\/\/[^\n]*\n|(['"])use strict\1;?)*(?:module\.exports\s*=|export\s+default\b)/;

/** The first bytes, in which a module says that it is one. */
const HEAD = 4096;

/** The text with everything that a pattern matches made blank; places stay. */
const blank = (text: string, pattern: RegExp): string => text.replace(pattern, (part) => part.replace(/[^\r\n]/g, ' '));

function textOf(source: Uint8Array | string): string | null {
  if (typeof source === 'string') return source;
  const head = decodeUtf8(source.subarray(0, HEAD)).text;
  if (!BEGINNING.test(head.replace(/^\ufeff/, ''))) return null;
  const { text, bad } = decodeUtf8(source);
  return bad === null ? text : null;
}

/** A JavaScript module whose exported value may be JSON. */
interface ModuleText {
  /** Its text, without a byte order mark. */
  readonly text: string;
  /** The exported value at its place in the text; everything around it and lines of comment are blank. */
  readonly value: string;
}

/** Finds the value that a JavaScript module exports, if it exports only one; null if the source is no such module. */
function readModule(source: Uint8Array | string): ModuleText | null {
  const text = textOf(source)?.replace(/^\ufeff/, '') ?? null;
  if (text === null || !BEGINNING.test(text)) return null;
  const value = blank(blank(blank(text, BEGINNING), /;\s*$/), /^[ \t]*\/\/.*$/gm);
  return { text, value };
}
