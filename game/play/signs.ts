import { joinHolds } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/basics/index.ts';
import type { Play } from './play.ts';

/** A person does not press and release within fewer ticks than this. */
const FASTEST = 2;

/** What may mean that a play is no person's. None of it proves anything, and none of it rejects a play. */
export interface PlaySigns {
  /** How many presses and releases come less than 2 ticks after the one before. */
  readonly fastEdges: number;
  /** The name of the level's own run that the play repeats to the tick; null if it repeats none. */
  readonly publishedRun: string | null;
}

const isSame = (a: readonly Hold[], b: readonly Hold[]): boolean =>
  a.length === b.length && a.every(([press, release], i) => press === b[i][0] && release === b[i][1]);

/** The holds as a play of this length has them. */
const upTo = (holds: readonly Hold[], end: number): Hold[] =>
  joinHolds(holds.map(([press, release]) => [press, Math.min(release, end)]));

/** Looks for signs in a play. */
export function signsOf(level: Level, { holds, claim }: Play): PlaySigns {
  let fastEdges = 0;
  for (const [i, [press, release]] of holds.entries()) {
    if (release - press < FASTEST && release < claim.tick) fastEdges++;
    if (i > 0 && press - holds[i - 1][1] < FASTEST) fastEdges++;
  }
  const published = holds.length === 0 ? undefined : level.runs.find((run) => isSame(upTo(run.holds, claim.tick), holds));
  return { fastEdges, publishedRun: published?.name ?? null };
}
