import { joinHolds } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Proof } from '../../prove/index.ts';
import type { AnytimeProof } from '../../search/anytime/index.ts';
import type { Moment } from '../../search/explore/index.ts';
import { cutHolds } from '../../verified-run.ts';
import type { proveLost } from './prove-lost.ts';

/** What is known about a state: whether the black hole can still be reached from it. `is` tells the kinds apart. */
export type Standing =
  | {
      /** Not examined yet. */
      readonly is: 'unknown';
    }
  | {
      /** A run through this state completes the level; a replay from the start has confirmed it. */
      readonly is: 'open';
    }
  | {
      /** It is proved that no run completes the level from here. */
      readonly is: 'proved';
      /**
       * The proof, about the level that starts in this state, or in one before it on the way; the separate checker has confirmed
       * it.
       */
      readonly proof: Proof;
    }
  | {
      /** No run was found. This proves nothing. */
      readonly is: 'not found';
      /** How long the search from this state was, ticks. */
      readonly ticks: number;
    };

/** A state in which a run can be, and she is alive. */
export interface SurveyedState extends Moment {
  /** x of her centre, px. */
  readonly x: number;
  /** y of her centre, px. */
  readonly y: number;
  /** Whether the black hole can be reached from it. */
  readonly standing: Standing;
  /** The longest that she was seen alive after it, ticks; 0 where nothing was looked at. */
  readonly alive: number;
  /** Index of the level's own run that passes through it; null for a state that a search reached. */
  readonly run: number | null;
}

/** A place where a run goes from states from which the black hole can be reached to states from which it cannot. */
export interface LostPlace extends SurveyedState {
  /** The last tick on the way here at which the black hole could still be reached; null if none is known. */
  readonly open: number | null;
  /** How many of the states that were examined lie beyond: they are lost, and were reached near this place. */
  readonly states: number;
}

/** Since when a run was lost that does not complete the level, as far as it is known. All moments are moments of the run. */
export interface RunLoss {
  /** The holds of the run. */
  readonly holds: readonly Hold[];
  /** The last tick at which she is alive, or at which the longest run is over. */
  readonly last: number;
  /** Whether the run completes the level; then it is lost at no time. */
  readonly completes: boolean;
  /** The last tick at which the black hole is known to be in reach; null if none is known. */
  readonly open: number | null;
  /** The first moment that was examined from which no run was found, or that is proved lost; null if none is known. */
  readonly lost: SurveyedState | null;
  /** The first moment that is proved lost; null if none is. */
  readonly proved: SurveyedState | null;
}

/** A state while it is examined. */
export type Examined = { -readonly [K in keyof SurveyedState]: SurveyedState[K] } & {
  readonly vx: number;
  readonly vy: number;
  /** The holds of a run through this state that completes the level; null while none is known. */
  onward: readonly Hold[] | null;
  /** How proofs were sought. */
  readonly sought: Set<typeof proveLost>;
  /** The search for a proof with ever finer sets; null: there is none for this state, undefined: not begun. */
  proving: AnytimeProof | null | undefined;
  /** Whether it was tried how runs go on from similar states. */
  isKnownTried: boolean;
};

/** The part of holds before a tick. */
export const upTo = (holds: readonly Hold[], tick: number): Hold[] => (tick === 0 ? [] : cutHolds(joinHolds(holds), tick - 1));

/** Whether a run passes through the state that other holds lead to. */
export const leadsThrough = (run: readonly Hold[], holds: readonly Hold[], tick: number): boolean =>
  commonTicks(run, holds, tick) >= tick;

/** For how many ticks two sorted and disjoint lists of holds say the same, at most `tick`. */
export function commonTicks(a: readonly Hold[], b: readonly Hold[], tick: number): number {
  const [edges, others] = [a.flat(), b.flat()];
  for (let i = 0; i < edges.length || i < others.length; i++) {
    if (edges[i] !== others[i]) {
      return Math.min(tick, edges[i] ?? Number.POSITIVE_INFINITY, others[i] ?? Number.POSITIVE_INFINITY);
    }
  }
  return tick;
}

/** Holds that lead to a state and then go on as a run did after another tick, some ticks earlier or later. */
export function continued({ holds, tick }: Moment, onward: readonly Hold[], from: number, shift: number): Hold[] {
  const later = onward
    .filter(([, release]) => release > from)
    .map(([press, release]): Hold => {
      const at = Math.max(0, press - from + (press > from ? shift : 0));
      return [tick + at, tick + Math.max(at + 1, release - from + shift)];
    });
  return joinHolds([...holds, ...later]);
}
