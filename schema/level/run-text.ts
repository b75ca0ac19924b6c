import type { Hold, RunNote } from '../basics/index.ts';
import { notesInOrder } from './shape.ts';

/** What a run as text says. */
export interface RunScript {
  /** When the gun is held. */
  readonly holds: readonly Hold[];
  /** Notes at ticks, sorted by tick. */
  readonly notes: readonly RunNote[];
}

/** A place in a run as text. */
export interface RunTextPlace {
  /** From 0, in UTF-16 code units. */
  readonly offset: number;
  /** From 1. */
  readonly line: number;
  /** From 1, in UTF-16 code units. */
  readonly column: number;
}

/** What the reader did that its text does not say: holds were joined, or a time was rounded. */
export interface RunTextRemark extends RunTextPlace {
  /** A sentence without its first capital and its full stop. */
  readonly message: string;
}

/** What a run as text says, or what is wrong with the text. */
export type RunTextReading =
  | (RunScript & { readonly ok: true; readonly remarks: readonly RunTextRemark[] })
  | (RunTextPlace & {
      readonly ok: false;
      /** What was expected, and what was found. */
      readonly message: string;
      /** What to do. */
      readonly hint: string;
    });

/**
 * Writes a run as text: `60-150, 200-410 # first swing`. A line of holds ends at a hold that has a note at its press. A note at
 * the release of the hold before it, or at tick 0 before the first hold, has a line of its own: `# text`. Any other note says its
 * tick: `@300 # text`. {@link readRunText} reads the same holds and notes from it.
 *
 * @param script - holds that are sorted and neither overlap nor touch, and notes in any order
 * @returns the text, without a line end at its end; `none` for a run without holds and notes
 */
export function formatRunText({ holds, notes }: RunScript): string {
  if (holds.length === 0 && notes.length === 0) return 'none';
  const lines: string[] = [];
  let row: string[] = [];
  const endRow = (comment: string) => {
    if (row.length > 0) lines.push(row.join(', ') + comment);
    row = [];
  };
  const left = notesInOrder(notes);
  let next = 0;
  /** Notes before a tick, each on a line of its own. @param usual the tick that such a line means by itself */
  const putUpTo = (tick: number, usual: number) => {
    for (; next < left.length && left[next].tick < tick; next++) {
      endRow('');
      const at = left[next].tick === usual ? '' : `@${left[next].tick} `;
      lines.push(`${at}# ${left[next].text}`);
    }
  };
  let before = 0;
  for (const [press, release] of holds) {
    putUpTo(press, before);
    row.push(`${press}-${release}`);
    if (next < left.length && left[next].tick === press) endRow(` # ${left[next++].text}`);
    before = release;
  }
  putUpTo(Number.POSITIVE_INFINITY, before);
  endRow('');
  return lines.join('\n');
}
