import { quote } from './format-value.ts';
import { isDigit, LOWER_E, LOWER_X, MINUS, PLUS, POINT, UPPER_E, UPPER_X, wordAt, ZERO } from './json-characters.ts';
import { failureAt, truncated, unexpected } from './json-failures.ts';
import type { Finding } from './problem.ts';

/** @returns the offset after the number at `start`, or what is wrong with it */
export function scanNumber(text: string, start: number): number | Finding {
  let i = text.charCodeAt(start) === MINUS ? start + 1 : start;
  if (!isDigit(text.charCodeAt(i))) return noDigits(text, start, i);
  if (text.charCodeAt(i) === ZERO) {
    const next = text.charCodeAt(i + 1);
    if (isDigit(next) || next === LOWER_X || next === UPPER_X) return leadingZero(start, next);
  }
  i = afterDigits(text, i);
  if (text.charCodeAt(i) === POINT) {
    i++;
    if (!isDigit(text.charCodeAt(i))) {
      return missingDigit(
        text,
        i,
        'a digit after the point',
        'a digit after the point',
        'Remove the point, or write 0 after it.',
      );
    }
    i = afterDigits(text, i);
  }
  const exponent = text.charCodeAt(i);
  const hasExponent = exponent === LOWER_E || exponent === UPPER_E;
  if (hasExponent) {
    i++;
    const sign = text.charCodeAt(i);
    if (sign === PLUS || sign === MINUS) i++;
    const digits = 'the digits of an exponent';
    if (!isDigit(text.charCodeAt(i))) return missingDigit(text, i, digits, digits, 'Write digits after the e, or remove it.');
    i = afterDigits(text, i);
  }
  // without an exponent it takes 309 digits to exceed the largest double
  if ((hasExponent || i - start > 300) && !Number.isFinite(Number(text.slice(start, i))))
    return tooLarge(text.slice(start, i), start);
  return i;
}

function afterDigits(text: string, start: number): number {
  let i = start;
  while (isDigit(text.charCodeAt(i))) i++;
  return i;
}

/** A minus without a digit after it; `i` is the offset after the minus. */
function noDigits(text: string, start: number, i: number): Finding {
  if (i < text.length && wordAt(text, i) === 'Infinity') return unexpected(text, start, 'a number', 'value', false);
  return missingDigit(text, i, 'the digits of a number', 'a digit after the minus', 'Write the digits of the number.');
}

/** A digit is missing at `offset`. `more` says what should come next at the end of the text, `expected` elsewhere. */
function missingDigit(text: string, offset: number, more: string, expected: string, hint: string): Finding {
  if (offset >= text.length) return truncated(text, more);
  return failureAt('invalid-json', offset, `expected ${expected}, found ${quote(text[offset])}`, hint);
}

/** A number begins with a superfluous 0; `next` is the character after it. */
function leadingZero(start: number, next: number): Finding {
  return isDigit(next)
    ? failureAt('invalid-json', start, "a number can't begin with 0 before other digits", 'Remove the zeros at its beginning.')
    : failureAt('invalid-json', start, 'JSON has no hexadecimal numbers', 'Write the number in decimal.');
}

function tooLarge(number: string, offset: number): Finding {
  const message = `the number ${quote(number).slice(1, -1)} is too large for a double`;
  return failureAt('number-too-large', offset, message, 'Write a number of at most 1.79e308.');
}
