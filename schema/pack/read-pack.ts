import {
  closestName,
  type Finding,
  formatValue,
  MAX_FINDINGS,
  type Path,
  type Problem,
  quote,
  toPointer,
} from '../basics/index.ts';
import { isObject, readJson, type TextPlace, toProblems, withoutExtensions } from '../json/index.ts';
import { found, unknownKey } from '../level/index.ts';
import { KEYS, PACK_LIMITS, PACK_VERSION, type PackFile } from './pack.ts';

/** The outcome of {@link readPack}: with `ok` true the pack, otherwise the problems. */
export type PackReading =
  | {
      /** The file is a valid pack. */
      readonly ok: true;
      /** The pack as the file has it, with its x- keys. */
      readonly pack: PackFile;
      /** The text without a byte order mark. */
      readonly text: string;
      /**
       * Finds a place in the text.
       *
       * @param path - keys and indices from the root
       * @returns the pointer of the value that the path names, and its line and column
       */
      locate(path: Path): TextPlace & { readonly pointer: string };
    }
  | {
      /** The file is not a valid pack. */
      readonly ok: false;
      /** What is wrong with it, in the order of the text; at least one. */
      readonly problems: Problem[];
      /** The text without a byte order mark; '' if the file is too large or not a text. */
      readonly text: string;
    };

/**
 * Reads a pack file: encoding, JSON syntax, version, keys, types, limits. Throws nothing for any content.
 *
 * @param source - the bytes of `pack.json`, or its text
 * @returns the pack, or every problem found, each with its place
 */
export function readPack(source: Uint8Array | string): PackReading {
  const json = readJson(source, 'skip', 'pack');
  if (!json.ok) return json;
  const { text, locator, value, hasExtensions } = json;
  const findings = [...json.findings, ...checkPackShape(hasExtensions ? withoutExtensions(value) : value)];
  if (findings.length > 0) return { ok: false, problems: toProblems(findings, locator), text };
  const locate = (path: Path) => {
    const pointer = toPointer(path);
    return { pointer, ...locator.placeAt(locator.offsetOf(pointer, 'value')) };
  };
  return { ok: true, pack: value as PackFile, text, locate };
}

const LEVEL_KEYS = ['level', 'introduces'];
const CHAPTER_KEYS = ['chapter'];

/** What to call a place in a pack: `entry 3`, `entry 3, introduces 1`. */
const inWords = (path: Path): string =>
  path
    .map((step, i) => (typeof step === 'number' ? ` ${step + 1}` : i === 0 && path.length > 1 ? 'entry' : `, ${step}`))
    .join('')
    .replace(/^, /, '');

const named = (path: Path, message: string): string => `${inWords(path)}: ${message}`;

/** Checks a text. @param what what is expected there @param longest characters */
function checkText(value: unknown, path: Path, what: string, longest: number, into: Finding[]): void {
  if (typeof value !== 'string') {
    into.push(
      found(path, 'wrong-type', named(path, `expected ${what} in double quotes, found ${formatValue(value)}`), `Write ${what}.`),
    );
  } else if (value === '') {
    into.push(found(path, 'empty-text', named(path, `expected ${what}, found an empty text`), `Write ${what}.`));
  } else if (value.length > longest) {
    into.push(
      found(path, 'text-too-long', named(path, `expected at most ${longest} characters, found ${value.length}`), 'Shorten it.'),
    );
  }
}

/** Checks a name, which stands on one line. */
function checkName(value: unknown, path: Path, what: string, into: Finding[]): void {
  const before = into.length;
  checkText(value, path, what, PACK_LIMITS.name, into);
  if (into.length > before || typeof value !== 'string') return;
  if (!/\S/.test(value))
    into.push(found(path, 'empty-text', named(path, `expected ${what}, found only blanks`), `Write ${what}.`));
  else if (/[\p{Cc}\p{Zl}\p{Zp}]/u.test(value))
    into.push(
      found(path, 'unknown-value', named(path, `expected one line, found ${quote(value)}`), 'Remove the control characters.'),
    );
}

function checkKeys(
  object: Readonly<Record<string, unknown>>,
  path: Path,
  known: readonly string[],
  into: Finding[],
): Set<string> {
  const meant = new Set<string>();
  for (const key of Object.keys(object)) {
    if (known.includes(key)) continue;
    if (into.length >= MAX_FINDINGS) break;
    const guess = closestName(key, known);
    if (guess !== null) meant.add(guess);
    const where = path.length === 0 ? '' : `${inWords(path)}: `;
    const { finding } = unknownKey([], key, object, known);
    into.push({ ...finding, path: [...path, key], message: `${where}${finding.message}` });
  }
  return meant;
}

function checkIntroduces(value: unknown, path: Path, into: Finding[]): void {
  const most = PACK_LIMITS.introduces;
  if (!Array.isArray(value)) {
    const expected = 'a list of effects in [ ]';
    into.push(
      found(
        path,
        'wrong-type',
        named(path, `expected ${expected}, found ${formatValue(value)}`),
        `Write ${expected}, such as ["novae"].`,
      ),
    );
  } else if (value.length === 0) {
    into.push(
      found(
        path,
        'empty-list',
        named(path, 'expected at least one entry, found an empty list'),
        'Name an effect, or remove the key.',
      ),
    );
  } else if (value.length > most) {
    into.push(found(path, 'too-many', named(path, `expected at most ${most} entries, found ${value.length}`), 'Remove entries.'));
  } else {
    for (const [i, name] of value.entries()) checkText(name, [...path, i], 'the name of an effect', PACK_LIMITS.id, into);
  }
}

const ENTRY = 'the id of a level in double quotes, { "level": ID } or { "chapter": NAME }';

function checkEntry(entry: unknown, path: Path, into: Finding[]): void {
  if (typeof entry === 'string') {
    checkText(entry, path, 'the id of a level', PACK_LIMITS.id, into);
    return;
  }
  if (!isObject(entry)) {
    into.push(found(path, 'wrong-type', named(path, `expected ${ENTRY}, found ${formatValue(entry)}`), 'Write one of these.'));
    return;
  }
  const isChapter = Object.hasOwn(entry, 'chapter') && !Object.hasOwn(entry, 'level');
  const isLevel = Object.hasOwn(entry, 'level');
  if (!isChapter && !isLevel) {
    const meant = checkKeys(entry, path, [...LEVEL_KEYS, ...CHAPTER_KEYS], into);
    // a misspelt key is one problem, not two
    if (!meant.has('level') && !meant.has('chapter'))
      into.push(found(path, 'missing-key', named(path, `expected ${ENTRY}, found neither key`), 'Add "level" or "chapter".'));
    return;
  }
  checkKeys(entry, path, isChapter ? CHAPTER_KEYS : LEVEL_KEYS, into);
  if (isChapter) checkName(entry.chapter, [...path, 'chapter'], 'the name of a chapter', into);
  else {
    checkText(entry.level, [...path, 'level'], 'the id of a level', PACK_LIMITS.id, into);
    if (Object.hasOwn(entry, 'introduces')) checkIntroduces(entry.introduces, [...path, 'introduces'], into);
  }
}

function checkVersion(value: unknown, into: Finding[]): void {
  const path = ['version'];
  if (value === PACK_VERSION) return;
  if (typeof value === 'number' && Number.isInteger(value) && value > PACK_VERSION) {
    const message = `this pack has version ${value} of the format; this toolkit reads version ${PACK_VERSION}`;
    into.push(found(path, 'newer-version', message, 'Update the toolkit (gravity-quest-toolkit).'));
    return;
  }
  const message = `version: expected ${PACK_VERSION}, found ${formatValue(value)}`;
  into.push(found(path, 'unsupported-version', message, `Write "version": ${PACK_VERSION}.`));
}

const MISSING: Readonly<Record<'version' | 'name' | 'levels', string>> = {
  version: `Add "version": ${PACK_VERSION} as the first key.`,
  name: 'Add "name", the title of the game.',
  levels: 'Add "levels", a list of the ids of levels in the order in which they are played.',
};

/** Checks a JSON value without x- keys against `packSchema`: keys, types, limits. */
function checkPackShape(value: unknown): Finding[] {
  if (!isObject(value)) {
    const message = `expected the order of a pack (an object in { }), found ${formatValue(value)}`;
    return [found([], 'wrong-type', message, `Write { "version": ${PACK_VERSION}, "name": "My levels", "levels": [] }.`)];
  }
  const into: Finding[] = [];
  const meant = checkKeys(value, [], KEYS, into);
  for (const key of ['version', 'name', 'levels'] as const) {
    if (Object.hasOwn(value, key) || meant.has(key)) continue;
    const code = key === 'version' ? 'missing-version' : 'missing-key';
    into.push(found([], code, `the key "${key}" is missing`, MISSING[key]));
  }
  if (Object.hasOwn(value, 'version')) checkVersion(value.version, into);
  if (Object.hasOwn(value, '$schema') && typeof value.$schema !== 'string') {
    const message = `$schema: expected a text in double quotes, found ${formatValue(value.$schema)}`;
    into.push(found(['$schema'], 'wrong-type', message, 'Write a text in double quotes.'));
  }
  if (Object.hasOwn(value, 'name')) checkName(value.name, ['name'], 'a name', into);
  if (Object.hasOwn(value, 'levels')) checkLevels(value.levels, into);
  return into.slice(0, MAX_FINDINGS);
}

function checkLevels(levels: unknown, into: Finding[]): void {
  const path = ['levels'];
  if (!Array.isArray(levels)) {
    const message = `levels: expected a list in [ ], found ${formatValue(levels)}`;
    into.push(found(path, 'wrong-type', message, 'Write a list of the ids of levels.'));
  } else if (levels.length > PACK_LIMITS.entries) {
    const message = `levels: expected at most ${PACK_LIMITS.entries} entries, found ${levels.length}`;
    into.push(found(path, 'too-many', message, 'Remove entries.'));
  } else {
    for (const [i, entry] of levels.entries()) {
      if (into.length >= MAX_FINDINGS) return;
      checkEntry(entry, ['levels', i], into);
    }
  }
}
