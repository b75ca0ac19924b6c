import type { Path } from '../basics/index.ts';

/** Brackets may be nested to this depth; a level needs 4. */
export const MAX_DEPTH = 64;

/** At most this many repeated keys are listed: a file with so many is not one with mistakes. */
const MOST_REPEATED = 1000;

/** What may come next in a JSON text. */
export type Expected = 'value' | 'value or ]' | 'key' | 'key or }' | 'colon' | 'after' | 'end';

/**
 * Where a text is not JSON, or says something twice. It has no advice, which a game does not need: `mistakes.ts` puts it
 * into words for those who write levels.
 */
export interface Mistake {
  readonly what:
    | 'unexpected'
    | 'missing-digit'
    | 'leading-zero'
    | 'hexadecimal'
    | 'too-large'
    | 'escape'
    | 'code-unit'
    | 'control-character'
    | 'open-line'
    | 'open-text'
    | 'too-deep'
    | 'repeated-key';
  readonly offset: number;
  /** What should be there, in words. */
  readonly expected: string;
  readonly mode: Expected;
  /** Whether the innermost open bracket is that of a list. */
  readonly isInList: boolean;
  /** Leads to the value that is wrong, or to the one around it. */
  readonly path: Path;
}

/** The result of scanning a JSON text. */
export interface Scan {
  /** The first error in syntax or nesting; null if `JSON.parse` can read the text. */
  readonly failure: Mistake | null;
  /** Keys that occur more than once in their object; those after `failure` are not found. */
  readonly repeated: readonly Mistake[];
  /** Whether any key begins with x-. */
  readonly hasExtensions: boolean;
}

/**
 * Scans a JSON text (RFC 8259) once, without recursion. Finds out whether `JSON.parse` can read it and what is wrong if not,
 * and also what `JSON.parse` would not report: repeated keys, nesting deeper than `MAX_DEPTH`, numbers that would become
 * Infinity.
 */
export function scanJson(text: string): Scan {
  const brackets = new OpenBrackets();
  const failure = scan(text, brackets);
  return { failure, repeated: brackets.repeated, hasExtensions: brackets.hasExtensions };
}

/**
 * Reads a JSON text of which {@link scanJson} would find nothing to tell, in a fraction of its time.
 * @returns the value in a list of its own; null where the text has to be scanned: it is no JSON, or has what needs a second look
 */
export function readPlain(text: string): readonly [value: unknown] | null {
  // with escapes, characters of the text and of its values differ
  if (text.includes('\\')) return null;
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return null;
  }
  let colons = 0;
  for (let i = 0; i < text.length; i++) if (text.charCodeAt(i) === COLON) colons++;
  // each key has a colon; there are more where an equal key came later, whose value alone is kept, or where keys have some
  return colons === colonsOf(value, 0) ? [value] : null;
}

/** How many colons stand in the text of a value, at least; NaN if anything else needs a second look. */
function colonsOf(value: unknown, depth: number): number {
  if (typeof value === 'number') return Number.isFinite(value) ? 0 : Number.NaN;
  if (typeof value === 'string') return value.includes(':') ? value.split(':').length - 1 : 0;
  if (typeof value !== 'object' || value === null) return 0;
  if (depth === MAX_DEPTH) return Number.NaN;
  let colons = 0;
  if (Array.isArray(value)) {
    for (let i = 0; i < value.length; i++) colons += colonsOf(value[i], depth + 1);
    return colons;
  }
  for (const key of Object.keys(value)) {
    if (key.startsWith('x-')) return Number.NaN;
    colons += 1 + colonsOf((value as Record<string, unknown>)[key], depth + 1);
  }
  return colons;
}

/** @returns the first error, or null */
function scan(text: string, brackets: OpenBrackets): Mistake | null {
  let mode: Expected = 'value';
  let i = 0;
  const wrong = ({ what = 'unexpected', offset = i, expected }: Failed): Mistake => {
    const { isInList } = brackets;
    // between values, what is wrong is the list or the object itself
    const path = brackets.path(mode === 'value' || mode === 'value or ]');
    return { what, offset, expected, mode, isInList, path };
  };
  for (;;) {
    let c = text.charCodeAt(i);
    while (isSpace(c)) c = text.charCodeAt(++i);
    switch (mode) {
      case 'value':
      case 'value or ]':
        if (c === OPEN_OBJECT || c === OPEN_LIST) {
          if (!brackets.open(c === OPEN_LIST)) return wrong({ what: 'too-deep', expected: `brackets at most ${MAX_DEPTH} deep` });
          i++;
          mode = c === OPEN_LIST ? 'value or ]' : 'key or }';
        } else if (c === CLOSE_LIST && mode === 'value or ]') {
          brackets.close();
          i++;
          mode = 'after';
        } else {
          const end = scanScalar(text, i, mode);
          if (typeof end !== 'number') return wrong(end);
          i = end;
          mode = 'after';
        }
        break;
      case 'key':
      case 'key or }': {
        if (c === CLOSE_OBJECT && mode === 'key or }') {
          brackets.close();
          i++;
          mode = 'after';
          break;
        }
        if (c !== QUOTE) return wrong({ expected: mode === 'key' ? KEY : `${KEY} or "}"` });
        const end = scanString(text, i);
        if (typeof end !== 'number') return wrong(end);
        brackets.addKey(keyIn(text, i, end), i);
        i = end;
        mode = 'colon';
        break;
      }
      case 'colon':
        if (c !== COLON) return wrong({ expected: 'a colon after the key' });
        i++;
        mode = 'value';
        break;
      case 'after':
        if (brackets.depth === 0) {
          mode = 'end';
        } else if (c === COMMA) {
          brackets.next();
          i++;
          mode = brackets.isInList ? 'value' : 'key';
        } else if (c === (brackets.isInList ? CLOSE_LIST : CLOSE_OBJECT)) {
          brackets.close();
          i++;
        } else {
          return wrong({ expected: brackets.isInList ? '"," or "]"' : '"," or "}"' });
        }
        break;
      case 'end':
        return i < text.length ? wrong({ expected: 'the end of the file' }) : null;
    }
  }
}

const KEY = 'a key in double quotes';

// UTF-16 code units of the characters that have a meaning in JSON
const SPACE = 32;
const QUOTE = 34;
const PLUS = 43;
const COMMA = 44;
const MINUS = 45;
const POINT = 46;
const ZERO = 48;
const COLON = 58;
const UPPER_E = 69;
const UPPER_X = 88;
const OPEN_LIST = 91;
const BACKSLASH = 92;
const CLOSE_LIST = 93;
const LOWER_E = 101;
const LOWER_U = 117;
const LOWER_X = 120;
const OPEN_OBJECT = 123;
const CLOSE_OBJECT = 125;

/** The words that are values in JSON. */
export const LITERALS: readonly string[] = ['true', 'false', 'null'];

export const isDigit = (c: number): boolean => c >= 48 && c <= 57;
const isHex = (c: number): boolean => isDigit(c) || (c >= 65 && c <= 70) || (c >= 97 && c <= 102);
export const isSpace = (c: number): boolean => c === SPACE || c === 10 || c === 13 || c === 9;

/** Whether a character may be part of a word that someone left without quotes. */
const isWord = (c: number): boolean =>
  isDigit(c) || (c >= 65 && c <= 90) || (c >= 97 && c <= 122) || c === 95 || c === 36 || c > 127;

/** The word that begins at an offset; '' if none does. */
export function wordAt(text: string, start: number): string {
  let end = start;
  while (end < text.length && isWord(text.charCodeAt(end))) end++;
  return text.slice(start, end);
}

/** What is wrong with a value; it is unexpected, and at the place of the scan, where the value does not say otherwise. */
type Failed = Partial<Pick<Mistake, 'what' | 'offset'>> & Pick<Mistake, 'expected'>;

/** @returns the offset after the string, number or word at an offset, or what is wrong there */
function scanScalar(text: string, offset: number, mode: 'value' | 'value or ]'): number | Failed {
  const c = text.charCodeAt(offset);
  if (c === QUOTE) return scanString(text, offset);
  if (c === MINUS || isDigit(c)) return scanNumber(text, offset);
  const word = wordAt(text, offset);
  if (LITERALS.includes(word)) return offset + word.length;
  return { expected: mode === 'value' ? 'a value' : 'a value or "]"' };
}

/** @returns the offset after the number at `start`, or what is wrong with it */
function scanNumber(text: string, start: number): number | Failed {
  let i = text.charCodeAt(start) === MINUS ? start + 1 : start;
  if (!isDigit(text.charCodeAt(i))) {
    return wordAt(text, i) === 'Infinity'
      ? { expected: 'a number' }
      : { what: 'missing-digit', offset: i, expected: 'a digit after the minus' };
  }
  if (text.charCodeAt(i) === ZERO) {
    const next = text.charCodeAt(i + 1);
    if (isDigit(next)) return { what: 'leading-zero', expected: 'a number without zeros before it' };
    if (next === LOWER_X || next === UPPER_X) return { what: 'hexadecimal', expected: 'a decimal number' };
  }
  i = afterDigits(text, i);
  if (text.charCodeAt(i) === POINT) {
    i++;
    if (!isDigit(text.charCodeAt(i))) return { what: 'missing-digit', offset: i, expected: 'a digit after the point' };
    i = afterDigits(text, i);
  }
  const exponent = text.charCodeAt(i);
  const hasExponent = exponent === LOWER_E || exponent === UPPER_E;
  if (hasExponent) {
    i++;
    const sign = text.charCodeAt(i);
    if (sign === PLUS || sign === MINUS) i++;
    if (!isDigit(text.charCodeAt(i))) return { what: 'missing-digit', offset: i, expected: 'the digits of an exponent' };
    i = afterDigits(text, i);
  }
  // without an exponent it takes 309 digits to exceed the largest double
  if ((hasExponent || i - start > 300) && !Number.isFinite(Number(text.slice(start, i))))
    return { what: 'too-large', expected: 'a number of at most 1.79e308' };
  return i;
}

function afterDigits(text: string, start: number): number {
  let i = start;
  while (isDigit(text.charCodeAt(i))) i++;
  return i;
}

/** @returns the offset after the string whose opening quote is at `start`, or what is wrong with it */
function scanString(text: string, start: number): number | Failed {
  for (let i = start + 1; i < text.length; i++) {
    const c = text.charCodeAt(i);
    if (c === QUOTE) return i + 1;
    if (c === BACKSLASH) {
      const last = scanEscape(text, i);
      if (typeof last !== 'number') return last;
      i = last;
    } else if (c < SPACE) {
      return c === 10 || c === 13
        ? { what: 'open-line', offset: start, expected: CLOSING }
        : { what: 'control-character', offset: i, expected: CLOSING };
    }
  }
  return { what: 'open-text', offset: text.length, expected: CLOSING };
}

const CLOSING = 'the closing " of a text';

/** @returns the offset of the last character of the escape that begins at `start`, or what is wrong with it */
function scanEscape(text: string, start: number): number | Failed {
  const letter = text.charCodeAt(start + 1);
  if (letter === LOWER_U) {
    for (let i = start + 2; i < start + 6; i++) {
      if (i >= text.length) return { what: 'open-text', offset: text.length, expected: CLOSING };
      if (!isHex(text.charCodeAt(i))) return { what: 'code-unit', offset: start, expected: 'a text with the escapes of JSON' };
    }
    return start + 5;
  }
  if (start + 1 >= text.length) return { what: 'open-text', offset: text.length, expected: CLOSING };
  if ('"\\/bfnrt'.includes(text[start + 1])) return start + 1;
  return { what: 'escape', offset: start, expected: 'a text with the escapes of JSON' };
}

/** The key in `text[start, end)`, whose quotes are included. */
function keyIn(text: string, start: number, end: number): string {
  const raw = text.slice(start + 1, end - 1);
  return raw.includes('\\') ? (JSON.parse(text.slice(start, end)) as string) : raw;
}

// from this many keys on, searching a list costs more than a set
const MANY_KEYS = 16;

/** The brackets that are open at a place of a JSON text, with the keys that each object has so far. */
class OpenBrackets {
  depth = 0;
  /** Whether any key begins with x-. */
  hasExtensions = false;
  /** Keys that occur more than once in their object. */
  readonly repeated: Mistake[] = [];
  // one entry per depth
  private readonly isList: boolean[] = [];
  private readonly index: number[] = [];
  private readonly keys: string[][] = [];
  private readonly keySets: (Set<string> | null)[] = [];

  /** Whether the innermost bracket is that of a list. */
  get isInList(): boolean {
    return this.depth > 0 && this.isList[this.depth - 1];
  }

  /**
   * Opens a bracket.
   * @returns false if it is nested too deeply
   */
  open(isList: boolean): boolean {
    const { depth } = this;
    if (depth === MAX_DEPTH) return false;
    this.isList[depth] = isList;
    this.index[depth] = 0;
    this.keys[depth] = [];
    this.keySets[depth] = null;
    this.depth++;
    return true;
  }

  close(): void {
    this.depth--;
  }

  /** Moves on to the next item of the innermost list, or the next key of the innermost object. */
  next(): void {
    this.index[this.depth - 1]++;
  }

  /** Adds a key to the innermost object; `offset` is that of its opening quote. */
  addKey(key: string, offset: number): void {
    if (key.startsWith('x-')) this.hasExtensions = true;
    const d = this.depth - 1;
    const seen = this.keys[d];
    const set = this.keySets[d];
    const isRepeated = set === null ? seen.includes(key) : set.has(key);
    seen.push(key);
    if (set !== null) set.add(key);
    else if (seen.length > MANY_KEYS) this.keySets[d] = new Set(seen);
    if (!isRepeated || this.repeated.length === MOST_REPEATED) return;
    const expected = 'a key that the object does not have yet';
    this.repeated.push({ what: 'repeated-key', offset, expected, mode: 'key', isInList: false, path: this.path(true) });
  }

  /** The path of the innermost list or object; with `isInside` that of its present entry. */
  path(isInside: boolean): Path {
    const depths = this.isList.slice(0, isInside ? this.depth : Math.max(0, this.depth - 1));
    return depths.map((isList, d) => (isList ? this.index[d] : this.keys[d][this.keys[d].length - 1]));
  }
}
