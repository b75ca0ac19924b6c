import { joinHolds } from '../../../engine/index.ts';
import { type Hold, type LevelFile, LIMITS, notesInOrder, type RunNote } from '../../../schema/index.ts';
import type { Recipe } from './edited-level.ts';

type Span = [press: number, release: number];

/** The effective holds of a run: sorted, and joined where they overlap. All indices of holds refer to these. */
export function holdsOf(file: LevelFile, run: string): Hold[] {
  return joinHolds(file.runs?.find(({ name }) => name === run)?.holds ?? []);
}

/** Where the note of a tick goes; null: it is deleted together with its hold. */
type Carry = (tick: number) => number | null;

const STAYS: Carry = (tick) => tick;

/** @param change returns the holds, which it may have changed in place, and what becomes of notes */
function onHolds(run: string, change: (holds: Span[]) => readonly [holds: Span[], carry: Carry]): Recipe {
  return (draft) => {
    const found = draft.runs?.find(({ name }) => name === run);
    if (found === undefined) return;
    const [holds, carry] = change(holdsOf(draft, run).map(([press, release]): Span => [press, release]));
    found.holds = holds;
    if (found.notes === undefined || carry === STAYS) return;
    const carried = found.notes.flatMap((note) => {
      const tick = carry(note.tick);
      return tick === null ? [] : [{ ...note, tick }];
    });
    putNotes(found, carried);
  };
}

const clamp = (value: number, least: number, most: number): number => Math.max(least, Math.min(most, value));

// neighbours stay at least a tick apart, or they would be one hold
const leastPress = (holds: readonly Span[], index: number): number => (index === 0 ? 0 : holds[index - 1][1] + 1);
const mostRelease = (holds: readonly Span[], index: number): number =>
  index === holds.length - 1 ? LIMITS.tick : holds[index + 1][0] - 1;

/** How far everything from an index on can move. */
const rippleRoom = (holds: readonly Span[], index: number, from: number): [least: number, most: number] => [
  (index === 0 ? 0 : holds[index - 1][1] + 1) - from,
  LIMITS.tick - holds[holds.length - 1][1],
];

function shiftFrom(holds: Span[], index: number, by: number): void {
  for (let i = index; i < holds.length; i++) holds[i] = [holds[i][0] + by, holds[i][1] + by];
}

const shiftedFrom =
  (from: number, by: number): Carry =>
  (tick) =>
    tick >= from ? tick + by : tick;

interface RippleOption {
  /** Whether everything later moves as well (Alt); otherwise the hold stops a tick before its neighbours. */
  readonly ripple?: boolean;
}

/** Moves a hold by whole ticks, with the notes from its press to its release. */
export function moveHold(run: string, index: number, by: number, { ripple = false }: RippleOption = {}): Recipe {
  return onHolds(run, (holds) => {
    const hold = holds[index];
    if (hold === undefined) return [holds, STAYS];
    const [press, release] = hold;
    const ticks = Math.round(by);
    if (ripple) {
      const [least, most] = rippleRoom(holds, index, press);
      const shift = clamp(ticks, least, most);
      shiftFrom(holds, index, shift);
      return [holds, shiftedFrom(press, shift)];
    }
    const shift = clamp(ticks, leastPress(holds, index) - press, mostRelease(holds, index) - release);
    holds[index] = [press + shift, release + shift];
    return [holds, (tick) => (press <= tick && tick <= release ? tick + shift : tick)];
  });
}

/**
 * Moves one edge of a hold to a tick, with the notes at that edge; the hold stays at least one tick long. With ripple everything
 * after the edge moves as well.
 */
export function stretchHold(
  run: string,
  index: number,
  edge: 'press' | 'release',
  tick: number,
  { ripple = false }: RippleOption = {},
): Recipe {
  return onHolds(run, (holds) => {
    const hold = holds[index];
    if (hold === undefined) return [holds, STAYS];
    const [press, release] = hold;
    const wanted = Math.round(tick);
    if (edge === 'press' && ripple) {
      const [least, most] = rippleRoom(holds, index, press);
      const by = clamp(wanted - press, least, most);
      shiftFrom(holds, index, by);
      return [holds, shiftedFrom(press, by)];
    }
    if (edge === 'press') {
      const to = clamp(wanted, leastPress(holds, index), release - 1);
      holds[index] = [to, release];
      return [holds, (at) => (at === press ? to : at)];
    }
    if (ripple) {
      const by = clamp(wanted - release, press + 1 - release, LIMITS.tick - holds[holds.length - 1][1]);
      holds[index] = [press, release + by];
      shiftFrom(holds, index + 1, by);
      const rest = shiftedFrom(release, by);
      // a note inside the hold stays inside
      return [holds, (at) => (press < at && at < release ? Math.min(at, release + by) : rest(at))];
    }
    const to = clamp(wanted, press + 1, mostRelease(holds, index));
    holds[index] = [press, to];
    return [holds, (at) => (at === release ? to : at)];
  });
}

/** Adds a hold; overlapping holds are joined with it. */
export function addHold(run: string, press: number, release: number): Recipe {
  return onHolds(run, (holds) => {
    const added: Hold = [Math.round(Math.min(press, release)), Math.round(Math.max(press, release))];
    return [joinHolds([...holds, added]).map(([a, b]): Span => [a, b]), STAYS];
  });
}

/** Releases the gun for one tick inside a hold, which makes two. Does nothing at a tick where one of them would be empty. */
export function splitHold(run: string, index: number, tick: number): Recipe {
  return onHolds(run, (holds) => {
    const hold = holds[index];
    const at = Math.round(tick);
    if (hold === undefined || at <= hold[0] || at >= hold[1] - 1) return [holds, STAYS];
    holds.splice(index, 1, [hold[0], at], [at + 1, hold[1]]);
    return [holds, STAYS];
  });
}

/**
 * Deletes holds, with the notes at their presses. With ripple, what comes later moves earlier by the length of each.
 */
export function deleteHolds(run: string, indices: Iterable<number>, { ripple = false }: RippleOption = {}): Recipe {
  return onHolds(run, (holds) => {
    const gone = new Set(indices);
    let earlier = 0;
    const left: Span[] = [];
    const deleted = holds.filter((_, i) => gone.has(i));
    for (const [i, [press, release]] of holds.entries()) {
      if (gone.has(i)) earlier += ripple ? release - press : 0;
      else left.push([press - earlier, release - earlier]);
    }
    const carry: Carry = (tick) => {
      if (deleted.some(([press]) => press === tick)) return null;
      const before = deleted.map(([press, release]) => Math.max(0, Math.min(tick, release) - press));
      return ripple ? tick - before.reduce((sum, ticks) => sum + ticks, 0) : tick;
    };
    // holds that touch after that are joined
    return [joinHolds(left).map(([press, release]): Span => [press, release]), carry];
  });
}

type RunFile = NonNullable<LevelFile['runs']>[number];

/** Gives a run of a draft its notes, sorted; without any, it has no list. */
export function putNotes(run: RunFile, notes: readonly RunNote[]): void {
  if (notes.length === 0) delete run.notes;
  else run.notes = notesInOrder(notes);
}
