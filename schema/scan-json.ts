import {
  CLOSE_LIST,
  CLOSE_OBJECT,
  COLON,
  COMMA,
  isDigit,
  isSpace,
  LITERALS,
  MINUS,
  OPEN_LIST,
  OPEN_OBJECT,
  QUOTE,
  wordAt,
} from './json-characters.ts';
import { type Expected, failureAt, unexpected } from './json-failures.ts';
import { scanNumber } from './json-number.ts';
import { scanString } from './json-string.ts';
import { MAX_DEPTH, OpenBrackets } from './open-brackets.ts';
import type { Finding } from './problem.ts';

/** The result of scanning a JSON text. */
export interface Scan {
  /** The first error in syntax or nesting; null if `JSON.parse` can read the text. */
  readonly failure: Finding | null;
  /** Keys that occur more than once in their object; those after `failure` are not found. */
  readonly repeated: readonly Finding[];
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

/** @returns the first error, or null */
function scan(text: string, brackets: OpenBrackets): Finding | null {
  let mode: Expected = 'value';
  let i = 0;
  for (;;) {
    let c = text.charCodeAt(i);
    while (isSpace(c)) c = text.charCodeAt(++i);
    switch (mode) {
      case 'value':
      case 'value or ]':
        if (c === OPEN_OBJECT || c === OPEN_LIST) {
          if (!brackets.open(c === OPEN_LIST)) return tooDeep(i);
          i++;
          mode = c === OPEN_LIST ? 'value or ]' : 'key or }';
        } else if (c === CLOSE_LIST && mode === 'value or ]') {
          brackets.close();
          i++;
          mode = 'after';
        } else {
          const end = scanScalar(text, i, mode, brackets.isInList);
          if (typeof end !== 'number') return end;
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
        const expected = mode === 'key' ? 'a key in double quotes' : 'a key in double quotes or "}"';
        if (c !== QUOTE) return unexpected(text, i, expected, mode, false);
        const end = scanString(text, i);
        if (typeof end !== 'number') return end;
        brackets.addKey(keyIn(text, i, end), i);
        i = end;
        mode = 'colon';
        break;
      }
      case 'colon':
        if (c !== COLON) return unexpected(text, i, 'a colon after the key', mode, false);
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
          return unexpected(text, i, brackets.isInList ? '"," or "]"' : '"," or "}"', mode, brackets.isInList);
        }
        break;
      case 'end':
        return i < text.length ? unexpected(text, i, 'the end of the file', mode, false) : null;
    }
  }
}

/** @returns the offset after the string, number or word at an offset, or what is wrong there */
function scanScalar(text: string, offset: number, mode: 'value' | 'value or ]', isInList: boolean): number | Finding {
  const c = text.charCodeAt(offset);
  if (c === QUOTE) return scanString(text, offset);
  if (c === MINUS || isDigit(c)) return scanNumber(text, offset);
  const word = wordAt(text, offset);
  if (LITERALS.includes(word)) return offset + word.length;
  return unexpected(text, offset, mode === 'value' ? 'a value' : 'a value or "]"', mode, isInList);
}

/** The key in `text[start, end)`, whose quotes are included. */
function keyIn(text: string, start: number, end: number): string {
  const raw = text.slice(start + 1, end - 1);
  return raw.includes('\\') ? (JSON.parse(text.slice(start, end)) as string) : raw;
}

const tooDeep = (offset: number): Finding =>
  failureAt(
    'too-deep',
    offset,
    `brackets are nested more than ${MAX_DEPTH} deep`,
    'A level needs 4 levels of brackets: remove the others.',
  );
