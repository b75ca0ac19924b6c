import { closestName } from './closest-name.ts';
import { quote } from './format-value.ts';
import { isDigit, isSpace, LITERALS, wordAt } from './json-characters.ts';
import type { Finding } from './problem.ts';

/** What may come next in a JSON text. */
export type Expected = 'value' | 'value or ]' | 'key' | 'key or }' | 'colon' | 'after' | 'end';

/** A finding about an offset of a text that is not JSON. */
export const failureAt = (code: Finding['code'], offset: number, message: string, hint: string): Finding => ({
  code,
  message,
  hint,
  path: [],
  part: 'value',
  offset,
});

/** What is wrong with a text that ends where `expected` should be. */
export function truncated(text: string, expected: string): Finding {
  // the end as a reader sees it, without trailing white space
  let end = text.length;
  while (end > 0 && isSpace(text.charCodeAt(end - 1))) end--;
  const message = `expected ${expected}, found the end of the file`;
  return failureAt('truncated-json', end, message, 'Add what is missing, or take the file from git again.');
}

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

/**
 * Describes what is wrong with the character at an offset, and what to do about it.
 * @param expected - what should be there, in words
 * @param isInList - whether the innermost open bracket is that of a list
 */
export function unexpected(text: string, offset: number, expected: string, mode: Expected, isInList: boolean): Finding {
  if (offset >= text.length) return truncated(text, expected);
  const what: Unexpected = { text, offset, mode, expected, isInList };
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
