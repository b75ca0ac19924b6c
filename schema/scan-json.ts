import { closestName } from './closest-name.ts';
import { type Finding, MAX_FINDINGS, type Path } from './problem.ts';
import { quote } from './say.ts';

/** Brackets may be nested this deep; a level needs 4. */
export const MAX_DEPTH = 64;

/** What a scan finds out about a JSON text. */
export interface Scan {
  /** The first thing that is not JSON or is nested too deep; null when `JSON.parse` can read the text. */
  readonly failure: Finding | null;
  /** Keys that stand more than once in their object; those after `failure` are unknown. */
  readonly repeated: readonly Finding[];
  /** Whether any key begins with x-. */
  readonly hasExtensions: boolean;
}

const LITERALS = ['true', 'false', 'null'];

// from here on looking through a list of keys costs more than a set
const MANY_KEYS = 16;

const isDigit = (c: number) => c >= 48 && c <= 57;
const isHex = (c: number) => isDigit(c) || (c >= 65 && c <= 70) || (c >= 97 && c <= 102);
const isWord = (c: number) => isDigit(c) || (c >= 65 && c <= 90) || (c >= 97 && c <= 122) || c === 95 || c === 36 || c > 127;
const isSpace = (c: number) => c === 32 || c === 10 || c === 13 || c === 9;

/** What may come next. */
type Mode = 'value' | 'value or ]' | 'key' | 'key or }' | 'colon' | 'after' | 'end';

/** Where a text ends for a reader: the offset after its last character that is not space. */
function visibleEnd(text: string): number {
  let end = text.length;
  while (end > 0 && isSpace(text.charCodeAt(end - 1))) end--;
  return end;
}

function wordAt(text: string, start: number): string {
  let end = start;
  while (end < text.length && isWord(text.charCodeAt(end))) end++;
  return text.slice(start, end);
}

/**
 * One pass over a JSON text (RFC 8259) without recursion: tells whether `JSON.parse` can read it, what is wrong if not, and what `JSON.parse`
 * would hide: keys given twice, nesting deeper than `MAX_DEPTH`, numbers that would become Infinity.
 */
export function scanJson(text: string): Scan {
  const length = text.length;
  const isList: boolean[] = [];
  const index: number[] = [];
  const keys: string[][] = [];
  const keySets: (Set<string> | null)[] = [];
  const repeated: Finding[] = [];
  let depth = 0;
  let hasExtensions = false;
  let failure: Finding | null = null;

  /** Of the key that was read last. */
  const path = (): Path => {
    const steps: (string | number)[] = [];
    for (let d = 0; d < depth; d++) {
      if (isList[d]) steps.push(index[d]);
      else steps.push(keys[d][keys[d].length - 1]);
    }
    return steps;
  };

  const fail = (code: Finding['code'], offset: number, message: string, hint: string): -1 => {
    failure = { code, message, hint, path: [], part: 'value', offset };
    return -1;
  };

  const failAtEnd = (expected: string): -1 =>
    fail(
      'truncated-json',
      visibleEnd(text),
      `expected ${expected}, found the end of the file`,
      'Add what is missing, or take the file from git again.',
    );

  /** Says what is wrong with the character at `i`, where `expected` should be. */
  const failUnexpected = (i: number, expected: string, mode: Mode): -1 => {
    if (i >= length) return failAtEnd(expected);
    const c = text[i];
    const next = text[i + 1] ?? '';
    if (c === '#' || (c === '/' && (next === '/' || next === '*'))) {
      const note = 'Move it into "description", or into a key of your own that begins with x-, such as "x-note".';
      return fail('comment', i, `expected ${expected}, found a comment: JSON has none`, note);
    }
    if ("'`‘’‚“”„«»".includes(c)) {
      return fail(
        'wrong-quotes',
        i,
        `expected ${expected}, found the quote ${c}: JSON knows only "`,
        'Use straight double quotes.',
      );
    }
    if (c === ']' || c === '}') {
      if (mode === 'key' || (mode === 'value' && depth > 0 && isList[depth - 1])) {
        const comma = text.lastIndexOf(',', i);
        return fail('trailing-comma', comma, `expected ${expected} after the comma, found "${c}"`, 'Remove the comma.');
      }
      return fail('invalid-json', i, `expected ${expected}, found "${c}"`, 'Check that every bracket has its partner.');
    }
    const word = wordAt(text, c === '-' || c === '+' ? i + 1 : i);
    if (word === 'NaN' || word === 'Infinity') {
      return fail(
        'not-a-number',
        i,
        `expected ${expected}, found ${c === word[0] ? '' : c}${word}: JSON has no such value`,
        'Write a number.',
      );
    }
    if (c === '+' || c === '.' || isDigit(c.charCodeAt(0))) {
      if (mode === 'key' || mode === 'key or }') {
        return fail('invalid-json', i, `expected ${expected}, found a number`, 'Put the key in double quotes.');
      }
      if (mode === 'value' || mode === 'value or ]') {
        return fail(
          'invalid-json',
          i,
          `a number can't begin with "${c}"`,
          c === '.' ? 'Write 0 before the point.' : 'Remove the +.',
        );
      }
    }
    if (word !== '' && c === word[0]) {
      const shown = quote(word);
      if (mode === 'key' || mode === 'key or }') {
        return fail(
          'invalid-json',
          i,
          `expected ${expected}, found ${shown} without quotes`,
          `Put the key in double quotes: ${shown}.`,
        );
      }
      const literal = closestName(word, LITERALS);
      if (literal !== null && literal !== word) {
        return fail('invalid-json', i, `expected ${expected}, found ${shown} without quotes`, `Write ${literal}.`);
      }
      if (mode === 'value' || mode === 'value or ]') {
        return fail(
          'invalid-json',
          i,
          `expected ${expected}, found ${shown} without quotes`,
          'Put texts in double quotes; leave out keys without a value.',
        );
      }
    }
    if (mode === 'colon') {
      return fail('invalid-json', i, `expected ${expected}, found ${quote(c)}`, 'Write a colon between the key and its value.');
    }
    if (mode === 'after') {
      const found = c === '"' ? 'a text' : quote(c);
      return fail('invalid-json', i, `expected ${expected}, found ${found}`, 'Add a comma before it, if one is missing.');
    }
    if (mode === 'end') {
      return fail('invalid-json', i, `expected ${expected}, found ${quote(c)}`, 'Remove what follows the last bracket.');
    }
    return fail('invalid-json', i, `expected ${expected}, found ${quote(c)}`, 'Correct the marked place.');
  };

  /** @returns the offset after the string whose opening quote is at `start`, or -1 */
  const scanString = (start: number): number => {
    for (let i = start + 1; i < length; i++) {
      const c = text.charCodeAt(i);
      if (c === 34) return i + 1;
      if (c === 92) {
        i++;
        if (i >= length) break;
        const letter = text[i];
        if (letter === 'u') {
          for (let k = 1; k <= 4; k++) {
            if (i + k >= length) return failAtEnd('the closing " of the text');
            if (!isHex(text.charCodeAt(i + k))) {
              return fail(
                'invalid-json',
                i - 1,
                `expected 4 hexadecimal digits after \\u, found ${quote(text.slice(i + 1, i + 5))}`,
                'Write the character itself.',
              );
            }
          }
          i += 4;
        } else if (!'"\\/bfnrt'.includes(letter)) {
          return fail(
            'invalid-json',
            i - 1,
            `there is no escape \\${quote(letter).slice(1, -1)} in JSON`,
            'Write \\\\ for a backslash.',
          );
        }
      } else if (c < 32) {
        if (c === 10 || c === 13) {
          return fail(
            'invalid-json',
            start,
            'the text has no closing " on its line',
            'Close it, or write \\n for a new line in it.',
          );
        }
        return fail(
          'invalid-json',
          i,
          `a text can't contain the control character ${quote(text[i])}`,
          c === 9 ? 'Write \\t.' : 'Remove it.',
        );
      }
    }
    return failAtEnd('the closing " of the text');
  };

  /** @returns the offset after the number at `start`, or -1 */
  const scanNumber = (start: number): number => {
    let i = start;
    let isSimple = true;
    if (text.charCodeAt(i) === 45) i++;
    const first = text.charCodeAt(i);
    if (!isDigit(first)) {
      if (i >= length) return failAtEnd('the digits of a number');
      if (wordAt(text, i) === 'Infinity') return failUnexpected(start, 'a number', 'value');
      return fail(
        'invalid-json',
        i,
        `expected a digit after the minus, found ${quote(text[i])}`,
        'Write the digits of the number.',
      );
    }
    i++;
    if (first === 48) {
      const second = text.charCodeAt(i);
      if (isDigit(second)) {
        return fail(
          'invalid-json',
          start,
          "a number can't begin with 0 before other digits",
          'Remove the zeros at its beginning.',
        );
      }
      if (second === 120 || second === 88) {
        return fail('invalid-json', start, 'JSON has no hexadecimal numbers', 'Write the number in decimal.');
      }
    }
    while (isDigit(text.charCodeAt(i))) i++;
    if (text.charCodeAt(i) === 46) {
      i++;
      if (!isDigit(text.charCodeAt(i))) {
        if (i >= length) return failAtEnd('a digit after the point');
        return fail(
          'invalid-json',
          i,
          `expected a digit after the point, found ${quote(text[i])}`,
          'Remove the point, or write 0 after it.',
        );
      }
      while (isDigit(text.charCodeAt(i))) i++;
    }
    const exponent = text.charCodeAt(i);
    if (exponent === 101 || exponent === 69) {
      isSimple = false;
      i++;
      const sign = text.charCodeAt(i);
      if (sign === 43 || sign === 45) i++;
      if (!isDigit(text.charCodeAt(i))) {
        if (i >= length) return failAtEnd('the digits of an exponent');
        return fail(
          'invalid-json',
          i,
          `expected the digits of an exponent, found ${quote(text[i])}`,
          'Write digits after the e, or remove it.',
        );
      }
      while (isDigit(text.charCodeAt(i))) i++;
    }
    // without an exponent it takes 309 digits to exceed the largest double
    if ((!isSimple || i - start > 300) && !Number.isFinite(Number(text.slice(start, i)))) {
      const shown = quote(text.slice(start, i)).slice(1, -1);
      return fail(
        'number-too-large',
        start,
        `the number ${shown} is too large for a double`,
        'Write a number of at most 1.79e308.',
      );
    }
    return i;
  };

  const open = (list: boolean): boolean => {
    if (depth === MAX_DEPTH) return false;
    isList[depth] = list;
    index[depth] = 0;
    keys[depth] = [];
    keySets[depth] = null;
    depth++;
    return true;
  };

  /** Notes the key in text[start, end) (with quotes) of the innermost object. */
  const takeKey = (start: number, end: number): void => {
    const raw = text.slice(start + 1, end - 1);
    const key = raw.includes('\\') ? (JSON.parse(text.slice(start, end)) as string) : raw;
    if (key.charCodeAt(0) === 120 && key.charCodeAt(1) === 45) hasExtensions = true;
    const d = depth - 1;
    const seen = keys[d];
    const set = keySets[d];
    const isRepeated = set === null ? seen.includes(key) : set.has(key);
    seen.push(key);
    if (set !== null) set.add(key);
    else if (seen.length > MANY_KEYS) keySets[d] = new Set(seen);
    if (isRepeated && repeated.length < MAX_FINDINGS) {
      const message = `the key ${quote(key)} stands more than once in this object`;
      repeated.push({ code: 'duplicate-key', message, hint: 'Keep one of them.', path: path(), part: 'key', offset: start });
    }
  };

  const scan = (): void => {
    let mode: Mode = 'value';
    let i = 0;
    while (i >= 0) {
      let c = text.charCodeAt(i);
      while (c === 32 || c === 10 || c === 13 || c === 9) c = text.charCodeAt(++i);
      switch (mode) {
        case 'value':
        case 'value or ]':
          if (c === 34) {
            i = scanString(i);
            mode = 'after';
          } else if (c === 45 || isDigit(c)) {
            i = scanNumber(i);
            mode = 'after';
          } else if (c === 123 || c === 91) {
            if (!open(c === 91)) {
              const message = `brackets are nested more than ${MAX_DEPTH} deep`;
              fail('too-deep', i, message, 'A level needs 4 levels of brackets: remove the others.');
              return;
            }
            i++;
            mode = c === 91 ? 'value or ]' : 'key or }';
          } else if (c === 93 && mode === 'value or ]') {
            depth--;
            i++;
            mode = 'after';
          } else {
            const word: string = wordAt(text, i);
            if (!LITERALS.includes(word)) {
              failUnexpected(i, mode === 'value' ? 'a value' : 'a value or "]"', mode);
              return;
            }
            i += word.length;
            mode = 'after';
          }
          break;
        case 'key':
        case 'key or }': {
          if (c === 125 && mode === 'key or }') {
            depth--;
            i++;
            mode = 'after';
            break;
          }
          if (c !== 34) {
            failUnexpected(i, mode === 'key' ? 'a key in double quotes' : 'a key in double quotes or "}"', mode);
            return;
          }
          const end = scanString(i);
          if (end < 0) return;
          takeKey(i, end);
          i = end;
          mode = 'colon';
          break;
        }
        case 'colon':
          if (c !== 58) {
            failUnexpected(i, 'a colon after the key', mode);
            return;
          }
          i++;
          mode = 'value';
          break;
        case 'after':
          if (depth === 0) {
            mode = 'end';
          } else if (c === 44) {
            index[depth - 1]++;
            i++;
            mode = isList[depth - 1] ? 'value' : 'key';
          } else if (c === (isList[depth - 1] ? 93 : 125)) {
            depth--;
            i++;
          } else {
            failUnexpected(i, isList[depth - 1] ? '"," or "]"' : '"," or "}"', mode);
            return;
          }
          break;
        case 'end':
          if (i < length) failUnexpected(i, 'the end of the file', mode);
          return;
      }
    }
  };

  scan();
  return { failure, repeated, hasExtensions };
}
