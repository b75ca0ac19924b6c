import { objectName, touchedName } from '../../schema/basics/index.ts';
import type { About, Blocker, ThingRef } from './proof.ts';

/** Formats a length, rounded to a tenth of a px; whole numbers have no decimals. */
export const px = (length: number): string => `${Math.round(length * 10) / 10} px`;

/** Names what a proof is about, as the subject of a sentence. */
export const subject = (about: About): string =>
  about.kind === 'blackHole' ? 'the black hole' : objectName('mineral', about.index);

/** Names an object that ends a run: `hot asteroid 2`. */
export const thing = ({ kind, index }: ThingRef): string => touchedName(kind, index);

/** Why the object is out of reach when every run ends within some seconds. */
export function soonOverReason(about: About, seconds: number, endedBy: readonly Blocker[]): string {
  return (
    `${subject(about)} is never reached: with her velocity at the start, every run ends within ${Math.ceil(seconds * 10) / 10} s ` +
    `at ${whatEnds(endedBy)}, whatever the player presses: start slower, elsewhere or in another direction, or clear her path`
  );
}

/** Lists in words what ends the runs. */
function whatEnds(endedBy: readonly Blocker[]): string {
  const names = endedBy.map((by) => (by.kind === 'range' ? 'the edge of the range' : thing(by)));
  const last = names.pop();
  return names.length > 0 ? `${names.join(', ')} or ${last}` : `${last}`;
}
