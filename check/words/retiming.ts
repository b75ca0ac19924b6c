import type { Hold } from '../../schema/basics/index.ts';
import { plural } from './plural.ts';

const EDGES = ['press', 'release'] as const;

const by = (shift: number): string => `${plural(Math.abs(shift), 'tick')} ${shift < 0 ? 'earlier' : 'later'}`;

/**
 * How holds are shifted, as an instruction: `Release hold 2 5 ticks earlier.`, or what is shifted in all where that takes more
 * words.
 * @param own the holds as they were, sorted and disjoint
 * @param holds as many others
 * @param until edges from this tick on come after the end of the run, and do not count
 */
export function retimingInWords(own: readonly Hold[], holds: readonly Hold[], until: number): string {
  const shifts = holds.flat().map((edge, i) => (own.flat()[i] >= until ? 0 : edge - own.flat()[i]));
  const moved = shifts.flatMap((shift, i) => (shift === 0 ? [] : [i]));
  if (moved.length === 0) return 'Leave the holds as they are.';
  const [first] = moved;
  const hold = (first >> 1) + 1;
  const isSame = moved.every((i) => shifts[i] === shifts[first]);
  if (moved.length === 1) return `${first % 2 === 0 ? 'Press' : 'Release'} hold ${hold} ${by(shifts[first])}.`;
  if (isSame && moved.length === 2 && first % 2 === 0 && moved[1] === first + 1) return `Move hold ${hold} ${by(shifts[first])}.`;
  const counted = own.flat().filter((edge) => edge < until).length;
  if (isSame && moved.length === counted - first && moved.length > 2) {
    return `Move everything from the ${EDGES[first % 2]} of hold ${hold} on ${by(shifts[first])}.`;
  }
  const all = shifts.map(Math.abs);
  return `Move ${moved.length} presses and releases by at most ${plural(Math.max(...all), 'tick')}, ${plural(
    all.reduce((sum, shift) => sum + shift, 0),
    'tick',
  )} in all.`;
}
