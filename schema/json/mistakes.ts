import { closestName, type Finding, quote } from '../basics/index.ts';
import { createPlaceFinder } from './locate.ts';
import { type Expected, isDigit, isSpace, LITERALS, MAX_DEPTH, type Mistake, scanJson, wordAt } from './scan.ts';

/** What is wrong with a text that is not JSON, or says something twice, and what to do about it. */
export function explainMistake(text: string, mistake: Mistake): Finding {
  const { what, offset, expected } = mistake;
  const at = (message: string, hint: string) => failureAt('invalid-json', offset, message, hint);
  switch (what) {
    case 'unexpected':
      return unexpected({ text, ...mistake });
    case 'missing-digit':
      return missingDigit(text, offset, expected);
    case 'leading-zero':
      return at("a number can't begin with 0 before other digits", 'Remove the zeros at its beginning.');
    case 'hexadecimal':
      return at('JSON has no hexadecimal numbers', 'Write the number in decimal.');
    case 'too-large': {
      const message = `the number ${quote(numberAt(text, offset)).slice(1, -1)} is too large for a double`;
      return failureAt('number-too-large', offset, message, 'Write a number of at most 1.79e308.');
    }
    case 'escape':
      return at(`JSON has no escape \\${quote(text[offset + 1]).slice(1, -1)}`, 'Write \\\\ for a backslash.');
    case 'code-unit': {
      const found = quote(text.slice(offset + 2, offset + 6));
      return at(`expected 4 hexadecimal digits after \\u, found ${found}`, 'Write the character itself.');
    }
    case 'control-character': {
      const c = text[offset];
      const message = `a text can't contain the control character ${quote(c)}`;
      return at(message, c === '\t' ? 'Write \\t.' : 'Remove it.');
    }
    case 'open-line':
      return at('the text has no closing " on its line', 'Close it, or write \\n for a new line in it.');
    case 'open-text':
      return truncated(text, 'the closing " of the text');
    case 'too-deep': {
      const hint = 'A level needs 4 levels of brackets: remove the others.';
      return failureAt('too-deep', offset, `brackets are nested more than ${MAX_DEPTH} deep`, hint);
    }
    case 'repeated-key': {
      const { path } = mistake;
      const message = `this object has the key ${quote(String(path[path.length - 1]))} more than once`;
      return { code: 'duplicate-key', message, hint: 'Keep one of them.', path, part: 'key', offset };
    }
  }
}

/** A finding about an offset of a text that is not JSON. */
const failureAt = (code: Finding['code'], offset: number, message: string, hint: string): Finding => ({
  code,
  message,
  hint,
  path: [],
  part: 'value',
  offset,
});

/** What is wrong with a text that ends where `expected` should be. */
function truncated(text: string, expected: string): Finding {
  // the end as a reader sees it, without trailing white space
  let end = text.length;
  while (end > 0 && isSpace(text.charCodeAt(end - 1))) end--;
  const message = `expected ${expected}, found the end of the file`;
  return failureAt('truncated-json', end, message, 'Add what is missing, or take the file from git again.');
}

/** What to do where a number lacks a digit, by what is expected there. */
const DIGITS: Readonly<Record<string, string>> = {
  'a digit after the minus': 'Write the digits of the number.',
  'a digit after the point': 'Remove the point, or write 0 after it.',
  'the digits of an exponent': 'Write digits after the e, or remove it.',
};

function missingDigit(text: string, offset: number, expected: string): Finding {
  if (offset >= text.length) return truncated(text, expected === 'a digit after the minus' ? 'the digits of a number' : expected);
  return failureAt('invalid-json', offset, `expected ${expected}, found ${quote(text[offset])}`, DIGITS[expected]);
}

/** The number at an offset, which is complete. */
const numberAt = (text: string, start: number): string => /-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?/.exec(text.slice(start))?.[0] ?? '';

/** A character that is not what was expected. */
interface Unexpected {
  readonly text: string;
  readonly offset: number;
  readonly mode: Expected;
  /** What was expected, in words. */
  readonly expected: string;
  /** Whether the innermost open bracket is that of a list. */
  readonly isInList: boolean;
}

/** Describes what is wrong with the character at an offset, and what to do about it. */
function unexpected(what: Unexpected): Finding {
  if (what.offset >= what.text.length) return truncated(what.text, what.expected);
  return (
    asComment(what) ??
    asQuote(what) ??
    asBracket(what) ??
    asNotANumber(what) ??
    asNumber(what) ??
    asWord(what) ??
    asMissingPunctuation(what)
  );
}

function asComment({ text, offset, expected }: Unexpected): Finding | null {
  const c = text[offset];
  const next = text[offset + 1] ?? '';
  if (c !== '#' && !(c === '/' && (next === '/' || next === '*'))) return null;
  const note = 'Move it into "description", or into a key of your own that begins with x-, such as "x-note".';
  return failureAt('comment', offset, `expected ${expected}, found a comment: JSON has none`, note);
}

function asQuote({ text, offset, expected }: Unexpected): Finding | null {
  const c = text[offset];
  if (!"'`‘’‚“”„«»".includes(c)) return null;
  const message = `expected ${expected}, found the quote ${c}: JSON has only "`;
  return failureAt('wrong-quotes', offset, message, 'Use straight double quotes.');
}

function asBracket({ text, offset, mode, expected, isInList }: Unexpected): Finding | null {
  const c = text[offset];
  if (c !== ']' && c !== '}') return null;
  if (mode === 'key' || (mode === 'value' && isInList)) {
    const comma = text.lastIndexOf(',', offset);
    return failureAt('trailing-comma', comma, `expected ${expected} after the comma, found "${c}"`, 'Remove the comma.');
  }
  return failureAt('invalid-json', offset, `expected ${expected}, found "${c}"`, 'Check that every bracket has its partner.');
}

function asNotANumber({ text, offset, expected }: Unexpected): Finding | null {
  const c = text[offset];
  const word = wordAt(text, c === '-' || c === '+' ? offset + 1 : offset);
  if (word !== 'NaN' && word !== 'Infinity') return null;
  const message = `expected ${expected}, found ${c === word[0] ? '' : c}${word}: JSON has no such value`;
  return failureAt('not-a-number', offset, message, 'Write a number.');
}

const isKey = (mode: Expected): boolean => mode === 'key' || mode === 'key or }';
const isValue = (mode: Expected): boolean => mode === 'value' || mode === 'value or ]';

function asNumber({ text, offset, mode, expected }: Unexpected): Finding | null {
  const c = text[offset];
  if (c !== '+' && c !== '.' && !isDigit(c.charCodeAt(0))) return null;
  if (isKey(mode))
    return failureAt('invalid-json', offset, `expected ${expected}, found a number`, 'Put the key in double quotes.');
  if (!isValue(mode)) return null;
  const hint = c === '.' ? 'Write 0 before the point.' : 'Remove the +.';
  return failureAt('invalid-json', offset, `a number can't begin with "${c}"`, hint);
}

function asWord({ text, offset, mode, expected }: Unexpected): Finding | null {
  const word = wordAt(text, offset);
  if (word === '') return null;
  const shown = quote(word);
  const message = `expected ${expected}, found ${shown} without quotes`;
  if (isKey(mode)) return failureAt('invalid-json', offset, message, `Put the key in double quotes: ${shown}.`);
  const literal = closestName(word, LITERALS);
  if (literal !== null && literal !== word) return failureAt('invalid-json', offset, message, `Write ${literal}.`);
  if (!isValue(mode)) return null;
  return failureAt('invalid-json', offset, message, 'Put texts in double quotes; leave out keys without a value.');
}

function asMissingPunctuation({ text, offset, mode, expected }: Unexpected): Finding {
  const c = text[offset];
  if (mode !== 'after') return failureAt('invalid-json', offset, `expected ${expected}, found ${quote(c)}`, hintFor(mode));
  const word = isDigit(c.charCodeAt(0)) ? '' : wordAt(text, offset);
  const found = c === '"' ? textAt(text, offset) : word === '' ? c : word;
  const hint = word === '' || LITERALS.includes(word) ? hintFor(mode) : hintForWord(text, offset);
  return failureAt('invalid-json', offset, `expected ${expected}, found ${quote(found)}`, hint);
}

/** The content of the text whose opening quote is at an offset, as far as its line goes. */
function textAt(text: string, offset: number): string {
  const raw = /[^"\\\n\r]*(?:\\.[^"\\\n\r]*)*/y.exec(text.slice(offset + 1, offset + 1000))?.[0] ?? '';
  try {
    return String(JSON.parse(`"${raw}"`));
  } catch {
    return raw;
  }
}

/** What to do about a bare word after a value: a unit after a number, the rest of a text that a quote ended, or a key. */
function hintForWord(text: string, offset: number): string {
  const before = /[^\s][^\S\n\r]*$/.exec(text.slice(Math.max(0, offset - 100), offset))?.[0][0] ?? '';
  if (/\d/.test(before)) return 'Remove it: a number is written without a unit.';
  if (before === '"') return 'Write \\" for a quote within a text.';
  return 'Add a comma before it, if one is missing, and put it in double quotes.';
}

function hintFor(mode: Expected): string {
  switch (mode) {
    case 'colon':
      return 'Write a colon between the key and its value.';
    case 'after':
      return 'Add a comma before it, if one is missing.';
    case 'end':
      return 'Remove what follows the last bracket.';
    default:
      return 'Correct the marked place.';
  }
}

/** The value of a JSON text, or the first thing that is wrong with it, and where. */
type StrictJson =
  | { readonly ok: true; readonly value: unknown }
  | { readonly ok: false; readonly message: string; readonly line: number; readonly column: number };

/**
 * Reads a JSON text that a person or a stranger wrote, as strictly as a level file: a key that an object has twice is a mistake,
 * as is a number beyond the doubles. `JSON.parse` would take the last of two values, and another program the first.
 */
export function strictJson(text: string): StrictJson {
  const { failure, repeated } = scanJson(text);
  const first = failure ?? repeated[0];
  if (first === undefined) return { ok: true, value: JSON.parse(text) };
  const { message, offset = 0 } = explainMistake(text, first);
  return { ok: false, message, ...createPlaceFinder(text)(offset) };
}
