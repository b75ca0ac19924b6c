import type { FieldChange } from '../change.ts';
import { numberInWords, numbersApart } from './numbers.ts';

const LONGEST = 40;

/** A text in quotes: escaped so that it cannot control a terminal, and cut if it is long. */
export function quoted(text: string): string {
  const letters = [...text];
  const shown = letters.length > LONGEST ? `${letters.slice(0, LONGEST).join('')}…` : text;
  return JSON.stringify(shown).replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, (c) => `\\u{${c.codePointAt(0)?.toString(16)}}`);
}

/** A key as it is; one that is no plain word in quotes. */
export const keyInWords = (key: string): string => (/^[\w$-]+$/.test(key) && key.length <= LONGEST ? key : quoted(key));

const isShort = (value: unknown): value is string | number | boolean =>
  typeof value === 'number' || typeof value === 'boolean' || (typeof value === 'string' && value.length <= LONGEST);

const valueInWords = (value: string | number | boolean): string =>
  typeof value === 'string' ? quoted(value) : typeof value === 'number' ? numberInWords(value) : String(value);

/** A change of any value: `x-author "Ann" -> "Ben"`, `x-notes changed`, `$schema added`. */
export function valueChangeInWords(change: FieldChange, name = keyInWords(change.key), unit = ''): string {
  const { before, after } = change;
  if (!Object.hasOwn(change, 'before')) return isShort(after) ? `${name} ${valueInWords(after)}${unit} added` : `${name} added`;
  if (!Object.hasOwn(change, 'after'))
    return isShort(before) ? `${name} ${valueInWords(before)}${unit} removed` : `${name} removed`;
  if (typeof before === 'number' && typeof after === 'number') {
    const [b, a] = numbersApart(before, after);
    return `${name} ${b} -> ${a}${unit}`;
  }
  return isShort(before) && isShort(after) ? `${name} ${valueInWords(before)} -> ${valueInWords(after)}` : `${name} changed`;
}
