import { deltaBetween, type Hunk, withDelta } from './text-delta.ts';
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
