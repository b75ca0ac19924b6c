// Reading levels in a game. It is the reader of the schema without what explains every mistake to the author of a level: the same
// scan, shape, contradictions and defaults, and a few words. So the two can't differ in what is valid.

import { LEVEL_VERSION, type Level, MAX_FILE_SIZE, type OwnRules, type Path, toPointer } from '../basics/index.ts';
import { createPlaceFinder, decodeUtf8, LFS, MERGE_MARKER, type Mistake, scanJson } from '../json/index.ts';
import {
  contradictionsIn,
  type Fault,
  findFaults,
  fits,
  type JsonObject,
  LEVEL_SHAPE,
  type LevelFile,
  MIGRATIONS,
  migrate,
  readVersion,
  resolveLevel,
} from '../level/index.ts';

/** The outcome of {@link readPlainLevel}: the level, or what is wrong with its file. */
export type PlainLevelReading =
  | {
      /** The file is a valid level. */
      readonly ok: true;
      /** The level with every default filled in. */
      readonly level: Level;
    }
  | {
      /** The file is not a valid level. */
      readonly ok: false;
      /** The first thing that is wrong: where, what was expected, what was found. */
      readonly message: string;
      /** JSON pointer of the value concerned; '' is the whole file. For a missing key: the object that lacks it. */
      readonly pointer: string;
    };

/** Options of {@link readPlainLevel}. */
export interface ReadPlainLevelOptions {
  /** Rules that the level's folder sets; they apply where the level has none of its own. None when left out. */
  readonly rules?: OwnRules;
}

/**
 * Reads a level file in a game: the same files are valid as for {@link readLevel}, and give the same level. It needs no zod and a
 * few kB only, so it reports the first mistake alone. Throws nothing for any content.
 *
 * @param source - the text of the file, or its bytes
 * @param options - rules of the folder
 * @returns the level, or the first mistake and its place
 *
 * @example
 * ```ts
 * const reading = readLevel(await (await fetch('levels/01-first-pull.level.json')).text());
 * if (!reading.ok) throw new Error(reading.message);
 * const player = createPlayer(reading.level);
 * ```
 */
export function readPlainLevel(source: string | Uint8Array, { rules = {} }: ReadPlainLevelOptions = {}): PlainLevelReading {
  try {
    const file = migrated(parseJson(textOf(source)));
    if (!fits(file, LEVEL_SHAPE)) findFaults(file, LEVEL_SHAPE, [], failShape);
    for (const { path, ...contradiction } of contradictionsIn(file)) {
      if (contradiction.what === 'repeated') fail(`expected ${inWords(contradiction.name)} once, found it twice`, path);
      else fail(`expected a release after the press ${contradiction.press}, found ${contradiction.release}`, path);
    }
    return { ok: true, level: resolveLevel(file as LevelFile, rules) };
  } catch (failure) {
    if (!(failure instanceof Failure)) throw failure;
    const pointer = pointerOf(failure.path);
    const place = failure.place ?? pointer;
    return { ok: false, message: place === '' ? failure.message : `${place}: ${failure.message}`, pointer };
  }
}

/** What is wrong with a text or a value, and where. It ends the reading; it is not seen outside of this file. */
class Failure {
  constructor(
    /** What was expected and what was found. */
    readonly message: string,
    /** Keys and indices that lead to the value. */
    readonly path: Path,
    /** The place in the text, where it is no JSON. */
    readonly place: string | null,
  ) {}
}

function fail(message: string, path: Path = [], place: string | null = null): never {
  throw new Failure(message, path, place);
}

// a key of a megabyte must not appear in a message
const MAX_POINTER = 500;

/** The pointer of a path; if a key makes it too long, that of the value around it. */
function pointerOf(path: Path): string {
  const pointer = toPointer(path);
  return pointer.length > MAX_POINTER ? pointerOf(path.slice(0, -1)) : pointer;
}

/** Longer texts are cut in messages. */
const LONGEST = 40;

/** A value in a few words: `"a text"`, `a list of 3`. */
function inWords(value: unknown): string {
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (typeof value === 'string') return JSON.stringify(value.length > LONGEST ? `${value.slice(0, LONGEST)}…` : value);
  return typeof value === 'object' && value !== null ? 'an object' : String(value);
}

function textOf(source: string | Uint8Array): string {
  if (typeof source !== 'string' && !(source instanceof Uint8Array)) {
    fail(`expected the text or the bytes of a level file, found ${inWords(source)}`);
  }
  if (source.length > MAX_FILE_SIZE) fail('expected at most 8 MiB, found more');
  const { text, bad } = typeof source === 'string' ? { text: source, bad: null } : decodeUtf8(source);
  if (bad !== null) fail(`expected UTF-8, found the byte ${bad.byte.toString(16)} at offset ${bad.at}`);
  if (text.startsWith('\ufeff')) fail('expected {, found a byte order mark; gq fmt removes it');
  // what a server gives that has a repository without what git lfs pull fetches
  if (LFS.test(text)) fail('expected a level, found a Git LFS pointer');
  return text;
}

function parseJson(text: string): unknown {
  const { failure, repeated } = scanJson(text);
  const mistake = repeated[0] ?? failure;
  if (mistake !== null) failText(text, mistake);
  return JSON.parse(text);
}

function failText(text: string, { what, offset, expected, path }: Mistake): never {
  const merge = text.search(MERGE_MARKER);
  const { line, column } = createPlaceFinder(text)(merge < 0 ? offset : merge);
  let found = offset < text.length ? inWords(String.fromCodePoint(text.codePointAt(offset) as number)) : 'the end';
  if (what === 'open-line') found = 'the end of its line';
  if (merge >= 0) found = 'an unresolved merge';
  // a key that is there twice is that of the object around it
  fail(
    `expected ${expected}, found ${found}`,
    what === 'repeated-key' ? path.slice(0, -1) : path,
    `line ${line}, column ${column}`,
  );
}

/** The file in the present version of the format. */
function migrated(file: unknown): unknown {
  const read = readVersion(file, MIGRATIONS);
  if (read.kind === 'newer') {
    fail(`expected a version up to ${LEVEL_VERSION}, found ${read.version}: update gravity-quest-toolkit`, ['version']);
  }
  // a version that there is not is wrong in the shape
  return read.kind === 'older' ? migrate(file as JsonObject, read.from, LEVEL_VERSION, MIGRATIONS) : file;
}

const TYPES: Readonly<Record<string, string>> = {
  number: 'a number',
  integer: 'a whole number',
  boolean: 'true or false',
  string: 'a text',
  array: 'a list',
  object: 'an object',
};

function failShape({ what, path, value, shape }: Fault): never {
  const { type = '', least, most, only, pattern, keys = {} } = shape;
  const key = inWords(path[path.length - 1]);
  const object = path.slice(0, -1);
  const found = inWords(value);
  const limits = what === 'too-small' ? `at least ${least}` : `at most ${most}`;
  const length = (value as { readonly length?: number } | null | undefined)?.length;
  switch (what) {
    case 'wrong-type':
      return fail(`expected ${TYPES[type]}, found ${found}`, path);
    case 'other-value':
      return fail(`expected ${inWords(only)}, found ${found}`, path);
    case 'too-small':
    case 'too-big':
      if (typeof value === 'number') return fail(`expected a number of ${limits}, found ${found}`, path);
      return fail(`expected ${limits} ${type === 'array' ? 'entries' : 'characters'}, found ${length}`, path);
    case 'wrong-form':
      return fail(`expected a text that matches ${pattern}, found ${found}`, path);
    case 'unknown-key':
      return fail(`expected one of the keys ${Object.keys(keys).join(', ')}, found the key ${key}`, object);
    case 'missing-key':
      return fail(`expected the key ${key}, found none of this name`, object);
  }
}
