import { type Closest, type Effort, mergeSolutions, type Solution } from '../../solver/index.ts';
import type { LaneState } from './messages.ts';

/**
 * A search consists of this many independent searches, its lanes, each with random numbers of its own. The result does not
 * depend on the number of threads that share the lanes.
 */
export const LANES = 4;

/** The combined results of all lanes. */
export interface Found {
  readonly effort: Effort;
  readonly closest: Closest | null;
  /** Really different runs, best first. */
  readonly solutions: readonly Solution[];
}

/** What a search in rounds needs of whoever has the lanes. */
export interface Rounds {
  /** The limit of all lanes together, ticks; null: none. */
  readonly effort: number | null;
  /** The wanted number of really different runs. */
  readonly count: number;
  readonly isStopped: () => boolean;
  /** Called after each round with the results so far. */
  readonly onRound: (found: Found) => void;
}

/**
 * Searches until nothing can improve or a limit is reached. The lanes wait for each other after each round, so that the result does
 * not depend on the number of threads.
 * @param states the lanes once their known runs are evaluated
 * @param advance advances all lanes to a total number of ticks each
 */
export async function searchInRounds(
  states: readonly LaneState[],
  advance: (to: number) => readonly LaneState[] | Promise<readonly LaneState[]>,
  { effort, count, isStopped, onRound }: Rounds,
): Promise<Found> {
  let last = states;
  for (const to of totals(effort)) {
    last = await advance(to);
    onRound(together(last, count));
    if (isStopped() || last.some(({ finished }) => finished)) break;
  }
  return together(last, count);
}

/** The total ticks of a lane at the end of each round; rounds get longer at first. */
function* totals(effort: number | null): Generator<number> {
  const most = effort === null ? Number.POSITIVE_INFINITY : Math.ceil(effort / LANES);
  let total = 0;
  let step = 20_000;
  while (total < most) {
    total = Math.min(most, total + step);
    step = Math.min(500_000, 2 * step);
    yield total;
  }
}

function together(states: readonly LaneState[], count: number): Found {
  const closest = states.flatMap((state) => state.closest ?? []);
  return {
    effort: {
      runs: states.reduce((sum, { effort }) => sum + effort.runs, 0),
      ticks: states.reduce((sum, { effort }) => sum + effort.ticks, 0),
    },
    closest: closest.reduce<Closest | null>((best, c) => (best === null || c.distance < best.distance ? c : best), null),
    solutions: mergeSolutions(
      states.map((state) => state.solutions),
      { count },
    ),
  };
}
