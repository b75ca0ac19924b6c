import { MERGE_MARKER } from '../merge-markers.ts';
import { MAX_DEPTH } from '../open-brackets.ts';
import { createPlaceFinder } from '../text-place.ts';
import { Failure, inWords } from './failure.ts';

const NUMBER = /-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;

const WORDS: readonly (readonly [word: string, value: unknown])[] = [
  ['true', true],
  ['false', false],
  ['null', null],
];

const QUOTE = 34;
const BACKSLASH = 92;

/**
 * Reads a JSON text as strictly as `scanJson`: RFC 8259, no key twice in an object, no number beyond the doubles, brackets at
 * most `MAX_DEPTH` deep, which also bounds the recursion.
 * @throws {Failure} where the text is something else
 */
export function parseJson(text: string): unknown {
  const path: (string | number)[] = [];
  let at = 0;

  function fail(expected: string): never {
    const merge = text.search(MERGE_MARKER);
    // a text may end in the middle of an escape
    const { line, column } = createPlaceFinder(text)(merge < 0 ? Math.min(at, text.length) : merge);
    const there = at < text.length ? inWords(String.fromCodePoint(text.codePointAt(at) as number)) : 'the end';
    const found = merge < 0 ? there : 'an unresolved merge';
    throw new Failure(`expected ${expected}, found ${found}`, path, `line ${line}, column ${column}`);
  }

  /** The character at the next place that is not blank. */
  function peek(): string | undefined {
    while (' \n\r\t'.includes(text[at] ?? '-')) at++;
    return text[at];
  }

  /** Skips a character if it is the next one. */
  function skip(character: string): boolean {
    const isNext = peek() === character;
    if (isNext) at++;
    return isNext;
  }

  function string(): string {
    const start = at;
    let isEscaped = false;
    for (at++; text.charCodeAt(at) !== QUOTE; at++) {
      // the end gives NaN
      if (!(text.charCodeAt(at) >= 32)) fail('the closing " of a text');
      if (text.charCodeAt(at) !== BACKSLASH) continue;
      isEscaped = true;
      at++;
    }
    at++;
    if (!isEscaped) return text.slice(start + 1, at - 1);
    try {
      return JSON.parse(text.slice(start, at)) as string;
    } catch {
      at = start;
      return fail('a text with the escapes of JSON');
    }
  }

  function open(depth: number): number {
    if (depth === MAX_DEPTH) fail(`brackets at most ${MAX_DEPTH} deep`);
    at++;
    return depth + 1;
  }

  function list(depth: number): unknown[] {
    const entries: unknown[] = [];
    if (skip(']')) return entries;
    do {
      path.push(entries.length);
      entries.push(value(depth));
      path.pop();
    } while (skip(','));
    return skip(']') ? entries : fail('"," or "]"');
  }

  function object(depth: number): Record<string, unknown> {
    const entries: Record<string, unknown> = {};
    if (skip('}')) return entries;
    do {
      if (peek() !== '"') fail('a key in double quotes');
      const start = at;
      const key = string();
      if (Object.hasOwn(entries, key)) {
        at = start;
        fail('a key that the object does not have yet');
      }
      if (!skip(':')) fail('":"');
      path.push(key);
      const entry = value(depth);
      path.pop();
      // an assignment would set the prototype
      if (key === '__proto__') Object.defineProperty(entries, key, { value: entry, enumerable: true });
      else entries[key] = entry;
    } while (skip(','));
    return skip('}') ? entries : fail('"," or "}"');
  }

  function value(depth: number): unknown {
    const first = peek();
    if (first === '{') return object(open(depth));
    if (first === '[') return list(open(depth));
    if (first === '"') return string();
    for (const [word, meaning] of WORDS) {
      if (!text.startsWith(word, at)) continue;
      at += word.length;
      return meaning;
    }
    NUMBER.lastIndex = at;
    const digits = NUMBER.exec(text)?.[0];
    if (digits === undefined) return fail('a value');
    const number = Number(digits);
    if (!Number.isFinite(number)) fail('a number of at most 1.79e308');
    at += digits.length;
    return number;
  }

  const whole = value(0);
  if (peek() !== undefined) fail('the end');
  return whole;
}
