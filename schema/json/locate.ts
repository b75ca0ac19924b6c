import { fromPointer } from '../basics/index.ts';

/**
 * Finds places in the text of a JSON document. It reads the text at the first question, and then only the containers on the
 * pointer's path.
 */
export interface Locator {
  /**
   * Offset of the value that a JSON pointer names, or of its key; if there is no such value, of the nearest one that contains
   * its place.
   */
  offsetOf(pointer: string, part: 'value' | 'key'): number;
  placeAt(offset: number): TextPlace;
}

interface Member {
  readonly key: number;
  readonly value: number;
}

type Members = ReadonlyMap<string, Member>;

function skipSpace(text: string, start: number): number {
  let i = start;
  while (' \n\r\t'.includes(text[i])) i++;
  return i;
}

function skipString(text: string, start: number): number {
  let i = start + 1;
  while (text[i] !== '"') i += text[i] === '\\' ? 2 : 1;
  return i + 1;
}

/** The offset after the value at `start`, without recursion. */
function skipValue(text: string, start: number): number {
  let depth = 0;
  let i = start;
  do {
    const c = text[i];
    if (c === '"') {
      i = skipString(text, i);
      continue;
    }
    if (c === '{' || c === '[') depth++;
    else if (c === '}' || c === ']') depth--;
    i++;
    // a number or a literal extends up to a character that cannot be part of it
    if (depth === 0 && c !== '}' && c !== ']') {
      while (i < text.length && !',]} \n\r\t'.includes(text[i])) i++;
    }
  } while (depth > 0);
  return i;
}

/**
 * The members of the container whose bracket is at `start`; none for other values. Of two equal keys the last wins, as in
 * `JSON.parse`.
 */
function membersOf(text: string, start: number): Members {
  const members = new Map<string, Member>();
  const isList = text[start] === '[';
  if (!isList && text[start] !== '{') return members;
  let i = skipSpace(text, start + 1);
  for (let n = 0; text[i] !== ']' && text[i] !== '}'; n++) {
    const key = i;
    let name = String(n);
    if (!isList) {
      const end = skipString(text, i);
      name = JSON.parse(text.slice(i, end)) as string;
      i = skipSpace(text, skipSpace(text, end) + 1);
    }
    members.set(name, { key, value: i });
    i = skipSpace(text, skipValue(text, i));
    if (text[i] === ',') i = skipSpace(text, i + 1);
  }
  return members;
}

/** Makes a locator for a text, which must be valid JSON. */
export function createLocator(text: string): Locator {
  const known = new Map<number, Members>();
  let placeAt: ((offset: number) => TextPlace) | null = null;

  const members = (start: number): Members => {
    let found = known.get(start);
    if (found === undefined) {
      found = membersOf(text, start);
      known.set(start, found);
    }
    return found;
  };

  return {
    offsetOf(pointer, part) {
      const root = skipSpace(text, 0);
      let at: Member = { key: root, value: root };
      for (const step of fromPointer(pointer)) {
        const member = members(at.value).get(step);
        if (member === undefined) return at.value;
        at = member;
      }
      return part === 'key' ? at.key : at.value;
    },
    placeAt(offset) {
      placeAt ??= createPlaceFinder(text);
      return placeAt(offset);
    },
  };
}

/** A place in a text. */
export interface TextPlace {
  /** Line, from 1. */
  readonly line: number;
  /** Column, from 1, in UTF-16 code units as editors count. */
  readonly column: number;
}

/** Returns a function that turns offsets in `text` into places. Lines end with LF; a CR before it belongs to the line. */
export function createPlaceFinder(text: string): (offset: number) => TextPlace {
  const starts = [0];
  for (let i = text.indexOf('\n'); i >= 0; i = text.indexOf('\n', i + 1)) starts.push(i + 1);
  return (offset) => {
    let low = 0;
    let high = starts.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (starts[middle] <= offset) low = middle;
      else high = middle - 1;
    }
    return { line: low + 1, column: offset - starts[low] + 1 };
  };
}

const AROUND = 2;
const WIDTH = 110;

/**
 * Replaces characters that have no width, take the place of others, or would control a terminal, each by one visible character,
 * so that the caret stays in the right column.
 */
function visible(text: string): string {
  return text.replaceAll('\t', ' ').replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, '·');
}

/**
 * Quotes the lines around a place in a text, numbered, with a caret below the place. Long lines are cut to the part around the
 * column.
 *
 * @param text - the whole text
 * @param line - line of the place, from 1
 * @param column - column of the place, from 1, in UTF-16 code units
 * @returns up to five lines of the text and the line with the caret, separated by LF
 */
export function codeFrame(text: string, line: number, column: number): string {
  const lines = text.split(/\r?\n/);
  const first = Math.max(1, line - AROUND);
  const last = Math.min(lines.length, line + AROUND);
  const digits = String(last).length;
  const cut = column > WIDTH - 20 ? column - (WIDTH >> 1) : 0;
  const rows: string[] = [];
  for (let n = first; n <= last; n++) {
    const whole = lines[n - 1];
    const shown = visible(whole.slice(cut, cut + WIDTH));
    const before = cut > 0 && whole.length > 0 ? '…' : '';
    const after = whole.length > cut + WIDTH ? '…' : '';
    rows.push(`${n === line ? '>' : ' '} ${String(n).padStart(digits)} | ${before}${shown}${after}`.trimEnd());
    if (n !== line) continue;
    // surrogate pairs are two code units and one character
    const gap = Array.from(visible(whole.slice(cut, column - 1))).length + (before === '' ? 0 : 1);
    rows.push(`  ${' '.repeat(digits)} | ${' '.repeat(gap)}^`);
  }
  return rows.join('\n');
}
