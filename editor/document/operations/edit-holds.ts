import { joinHolds } from '../../../engine/index.ts';
import { type Hold, type LevelFile, LIMITS } from '../../../schema/index.ts';
import type { Recipe } from '../edited-level.ts';

type Span = [press: number, release: number];

/** The effective holds of a run: sorted, and joined where they overlap. All indices of holds refer to these. */
export function holdsOf(file: LevelFile, run: string): Hold[] {
  return joinHolds(file.runs?.find(({ name }) => name === run)?.holds ?? []);
}

function onHolds(run: string, change: (holds: Span[]) => Span[]): Recipe {
  return (draft) => {
    const found = draft.runs?.find(({ name }) => name === run);
    if (found !== undefined) found.holds = change(holdsOf(draft, run).map(([press, release]): Span => [press, release]));
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

export interface RippleOption {
  /** Whether everything later moves as well (Alt); otherwise the hold stops a tick before its neighbours. */
  readonly ripple?: boolean;
}

/** Moves a hold by whole ticks. */
export function moveHold(run: string, index: number, by: number, { ripple = false }: RippleOption = {}): Recipe {
  return onHolds(run, (holds) => {
    const hold = holds[index];
    if (hold === undefined) return holds;
    const ticks = Math.round(by);
    if (ripple) {
      const [least, most] = rippleRoom(holds, index, hold[0]);
      shiftFrom(holds, index, clamp(ticks, least, most));
      return holds;
    }
    const shift = clamp(ticks, leastPress(holds, index) - hold[0], mostRelease(holds, index) - hold[1]);
    holds[index] = [hold[0] + shift, hold[1] + shift];
    return holds;
  });
}

/**
 * Moves one edge of a hold to a tick; the hold stays at least one tick long. With ripple everything after the edge moves as
 * well.
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
    if (hold === undefined) return holds;
    const [press, release] = hold;
    const wanted = Math.round(tick);
    if (edge === 'press' && ripple) {
      const [least, most] = rippleRoom(holds, index, press);
      shiftFrom(holds, index, clamp(wanted - press, least, most));
    } else if (edge === 'press') {
      holds[index] = [clamp(wanted, leastPress(holds, index), release - 1), release];
    } else if (ripple) {
      const by = clamp(wanted - release, press + 1 - release, LIMITS.tick - holds[holds.length - 1][1]);
      holds[index] = [press, release + by];
      shiftFrom(holds, index + 1, by);
    } else {
      holds[index] = [press, clamp(wanted, press + 1, mostRelease(holds, index))];
    }
    return holds;
  });
}

/** Adds a hold; overlapping holds are joined with it. */
export function addHold(run: string, press: number, release: number): Recipe {
  return onHolds(run, (holds) =>
    joinHolds([...holds, [Math.round(Math.min(press, release)), Math.round(Math.max(press, release))]]).map(
      ([a, b]): Span => [a, b],
    ),
  );
}

/** Releases the gun for one tick inside a hold, which makes two. Does nothing at a tick where one of them would be empty. */
export function splitHold(run: string, index: number, tick: number): Recipe {
  return onHolds(run, (holds) => {
    const hold = holds[index];
    const at = Math.round(tick);
    if (hold === undefined || at <= hold[0] || at >= hold[1] - 1) return holds;
    holds.splice(index, 1, [hold[0], at], [at + 1, hold[1]]);
    return holds;
  });
}

/** Deletes holds. With ripple, later holds move earlier by the length of each. */
export function deleteHolds(run: string, indices: Iterable<number>, { ripple = false }: RippleOption = {}): Recipe {
  return onHolds(run, (holds) => {
    const gone = new Set(indices);
    let earlier = 0;
    const left: Span[] = [];
    for (const [i, [press, release]] of holds.entries()) {
      if (gone.has(i)) earlier += ripple ? release - press : 0;
      else left.push([press - earlier, release - earlier]);
    }
    // holds that touch after that are joined
    return joinHolds(left).map(([press, release]): Span => [press, release]);
  });
}
