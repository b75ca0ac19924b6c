import { notesInOrder } from '../notes.ts';
import type { RunScript } from './run-script.ts';

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
