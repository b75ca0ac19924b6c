import { joinHolds } from '../../engine/basics/index.ts';
import { type Hold, type Level, objectName } from '../../schema/basics/index.ts';
import type { Change, ObjectRef, Proposal, Vector } from '../../solver/index.ts';
import { plural } from './figures.ts';

/** A number with at most one decimal place, as proposals have them. */
const number = (value: number): string => String(Math.round(value * 10) / 10);

const vector = ({ x, y }: Vector): string => `(${number(x)}, ${number(y)})`;

function nameOf(level: Level, { kind, index }: ObjectRef): string {
  if (kind === 'astronaut') return 'the start';
  if (kind === 'blackHole') return 'the black hole';
  return objectName(kind, index, (kind === 'asteroid' ? level.asteroids[index] : undefined) ?? {});
}

/**
 * A change of a level as an instruction: `Move nova 3 from (600, 620) to (595.4, 620.1).`
 * @param level the level before the change
 */
function changeInWords(level: Level, change: Change): string {
  switch (change.what) {
    case 'move':
      return `Move ${nameOf(level, change.object)} from ${vector(change.from)} to ${vector(change.to)}.`;
    case 'resize':
      return `Make ${nameOf(level, change.object)} ${change.to > change.from ? 'larger' : 'smaller'}: radius ${number(change.to)} px, not ${number(change.from)} px.`;
    case 'drop':
      return `Remove ${nameOf(level, change.object)}.`;
    case 'range':
      return `${change.to > change.from ? 'Enlarge' : 'Reduce'} the range from ${number(change.from)} px to ${number(change.to)} px.`;
    case 'velocity':
      return `Start with the velocity ${vector(change.to)} px/s, not ${vector(change.from)} px/s.`;
  }
}

/**
 * A proposal as an instruction.
 * @param level the level before the change
 */
export function proposalInWords(level: Level, { change, run, origin }: Proposal): string {
  if (change !== null) return changeInWords(level, change);
  if (origin.from === 'adjusted') {
    const { name, holds } = level.runs[origin.index];
    return `In run ${JSON.stringify(name)}: ${retimingInWords(joinHolds(holds), run.holds, run.tick)}`;
  }
  return 'Add a run that a search found: the level can be completed as it is.';
}

/** Which run completes the level after a proposal: `run "solution"`. */
export function proposalRunInWords(level: Level, { origin }: Proposal): string {
  switch (origin.from) {
    case 'own':
      return `run ${JSON.stringify(level.runs[origin.index].name)}`;
    case 'adjusted':
      return `run ${JSON.stringify(level.runs[origin.index].name)} with other holds`;
    case 'search':
      return 'a run that a search found';
  }
}

/** How the sizes of changes compare, in one sentence. */
export const SIZE_MEANS =
  'The size is how far an object is moved, or by how much a radius or the range differs; for a velocity, how far away she is after a second; for an object that is removed, its diameter.';

const EDGES = ['press', 'release'] as const;

const by = (shift: number): string => `${plural(Math.abs(shift), 'tick')} ${shift < 0 ? 'earlier' : 'later'}`;

/**
 * How holds are shifted, as an instruction: `Release hold 2 5 ticks earlier.`, or what is shifted in all where that takes more
 * words.
 * @param own the holds as they were, sorted and disjoint
 * @param holds as many others
 * @param until edges from this tick on come after the end of the run, and do not count
 */
function retimingInWords(own: readonly Hold[], holds: readonly Hold[], until: number): string {
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
