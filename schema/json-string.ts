import { quote } from './format-value.ts';
import { BACKSLASH, CARRIAGE_RETURN, isHex, LINE_FEED, QUOTE, TAB } from './json-characters.ts';
import { failureAt, truncated } from './json-failures.ts';
import type { Finding } from './problem.ts';

const CLOSING = 'the closing " of the text';

/** @returns the offset after the string whose opening quote is at `start`, or what is wrong with it */
export function scanString(text: string, start: number): number | Finding {
  for (let i = start + 1; i < text.length; i++) {
    const c = text.charCodeAt(i);
    if (c === QUOTE) return i + 1;
    if (c === BACKSLASH) {
      const last = scanEscape(text, i);
      if (typeof last !== 'number') return last;
      i = last;
    } else if (c < 32) return controlCharacter(text, start, i);
  }
  return truncated(text, CLOSING);
}

/** @returns the offset of the last character of the escape that begins at `start`, or what is wrong with it */
function scanEscape(text: string, start: number): number | Finding {
  const letter = text[start + 1];
  if (letter === undefined) return truncated(text, CLOSING);
  if (letter === 'u') {
    for (let i = start + 2; i < start + 6; i++) {
      if (i >= text.length) return truncated(text, CLOSING);
      if (isHex(text.charCodeAt(i))) continue;
      const found = quote(text.slice(start + 2, start + 6));
      const message = `expected 4 hexadecimal digits after \\u, found ${found}`;
      return failureAt('invalid-json', start, message, 'Write the character itself.');
    }
    return start + 5;
  }
  if ('"\\/bfnrt'.includes(letter)) return start + 1;
  const message = `JSON has no escape \\${quote(letter).slice(1, -1)}`;
  return failureAt('invalid-json', start, message, 'Write \\\\ for a backslash.');
}

/** A control character at `offset`, in the string that begins at `start`. */
function controlCharacter(text: string, start: number, offset: number): Finding {
  const c = text.charCodeAt(offset);
  if (c === LINE_FEED || c === CARRIAGE_RETURN) {
    const message = 'the text has no closing " on its line';
    return failureAt('invalid-json', start, message, 'Close it, or write \\n for a new line in it.');
  }
  const message = `a text can't contain the control character ${quote(text[offset])}`;
  return failureAt('invalid-json', offset, message, c === TAB ? 'Write \\t.' : 'Remove it.');
}
