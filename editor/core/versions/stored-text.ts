import { commonEnds } from '../../../check/runs/index.ts';
import { checkOf } from './version.ts';

/** The text of a version as it is stored: whole, or by what differs from the whole text of another version. */
export type StoredText =
  | { readonly whole: string; readonly check: string }
  | { readonly base: number; readonly hunks: readonly Hunk[] };

/** A whole text that others can be stored by. */
export interface Base {
  readonly number: number;
  readonly text: string;
  /** How many versions are stored by it. */
  readonly uses: number;
}

/** A text that differs in a larger part than this is stored whole. */
const LARGEST_PART = 0.3;
/** The most versions that are stored by one whole text. */
const MOST_USES = 100;

/**
 * How a text is stored. No version is stored by one that is itself stored by another, so a damaged version costs no other one;
 * and whole texts are stored twice.
 */
export function toStored(text: string, base: Base | null): StoredText {
  if (base === null || base.uses >= MOST_USES) return wholeText(text);
  const stored: StoredText = { base: base.number, hunks: deltaBetween(base.text, text) };
  return sizeOf(stored) > LARGEST_PART * text.length ? wholeText(text) : stored;
}

/** A text stored whole. */
export const wholeText = (whole: string): StoredText => ({ whole, check: checkOf(whole) });

/** The number of characters that are stored. */
export function sizeOf(stored: StoredText): number {
  if ('whole' in stored) return 2 * stored.whole.length;
  let size = 0;
  for (const [, , ...lines] of stored.hunks) size += lines.reduce((sum, line) => sum + line.length + 1, 16);
  return size;
}

type Row = { readonly whole?: unknown; readonly check?: unknown; readonly hunks?: unknown };

/** A whole text among what is stored; null if every copy is damaged. */
export function wholeIn(rows: readonly unknown[]): string | null {
  for (const row of rows as readonly (Row | null)[]) {
    if (typeof row?.whole === 'string' && checkOf(row.whole) === row.check) return row.whole;
  }
  return null;
}

/**
 * The text of a version; null if everything that has it is damaged.
 * @param copies what is stored of it
 * @param bases copies of the whole text that it is stored by
 * @param check the fingerprint of the text
 */
export function fromStored(copies: readonly unknown[], bases: readonly unknown[], check: string): string | null {
  const own = wholeIn(copies);
  if (own !== null) return checkOf(own) === check ? own : null;
  const base = wholeIn(bases);
  if (base === null) return null;
  for (const row of copies as readonly (Row | null)[]) {
    try {
      const text = withDelta(base, row?.hunks as readonly Hunk[]);
      if (checkOf(text) === check) return text;
    } catch {
      // damaged: perhaps there is another copy
    }
  }
  return null;
}

/**
 * What makes a text of another one, line by line: from line `at` of the other text on, `gone` lines are replaced by `lines`.
 * Hunks are in order and do not overlap.
 */
type Hunk = readonly [at: number, gone: number, ...lines: string[]];

/** Pairs of equal lines that occur once in each part, in the order of both: the longest such list. */
function anchorsBetween(old: readonly string[], now: readonly string[]): (readonly [old: number, now: number])[] {
  const places = new Map<string, { count: number; old: number; now: number }>();
  for (const [i, line] of old.entries()) {
    const known = places.get(line);
    if (known === undefined) places.set(line, { count: 1, old: i, now: -1 });
    else known.count = 3;
  }
  for (const [i, line] of now.entries()) {
    const known = places.get(line);
    if (known === undefined) continue;
    known.count++;
    known.now = i;
  }
  const pairs = [...places.values()].filter(({ count, now: at }) => count === 2 && at >= 0).sort((p, q) => p.now - q.now);
  // the longest rising list of old places, by patience sorting
  const piles: number[] = [];
  const before = new Array<number>(pairs.length).fill(-1);
  for (const [i, pair] of pairs.entries()) {
    let [low, high] = [0, piles.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (pairs[piles[middle]].old < pair.old) low = middle + 1;
      else high = middle;
    }
    if (low > 0) before[i] = piles[low - 1];
    piles[low] = i;
  }
  const anchors: (readonly [number, number])[] = [];
  for (let i = piles.at(-1) ?? -1; i >= 0; i = before[i]) anchors.push([pairs[i].old, pairs[i].now]);
  return anchors.reverse();
}

/** The hunks that make `after` of `before`: few where few lines differ. */
export function deltaBetween(before: string, after: string): Hunk[] {
  const [old, now] = [before.split('\n'), after.split('\n')];
  const { head: start, tail: end } = commonEnds(old, now, (a, b) => a === b);
  const [oldEnd, nowEnd] = [old.length - end, now.length - end];
  const inner = anchorsBetween(old.slice(start, oldEnd), now.slice(start, nowEnd));
  const hunks: Hunk[] = [];
  let [i, j] = [start, start];
  for (const [a, b] of [...inner.map(([p, q]) => [p + start, q + start] as const), [oldEnd, nowEnd] as const]) {
    if (a > i || b > j) hunks.push([i, a - i, ...now.slice(j, b)]);
    [i, j] = [a + 1, b + 1];
  }
  return hunks;
}

/** Makes the text of the other one. @throws RangeError if the hunks do not fit it */
export function withDelta(before: string, hunks: readonly Hunk[]): string {
  const old = before.split('\n');
  const lines: string[] = [];
  let next = 0;
  for (const [at, gone, ...come] of hunks) {
    if (!(at >= next && gone >= 0 && at + gone <= old.length)) throw new RangeError('the hunks do not fit the text');
    for (; next < at; next++) lines.push(old[next]);
    lines.push(...come);
    next = at + gone;
  }
  for (; next < old.length; next++) lines.push(old[next]);
  return lines.join('\n');
}
