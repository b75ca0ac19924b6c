import type { BodyKind } from '../../engine/index.ts';
import type { PlayOutcome, PlayVerdict } from '../../game/index.ts';

/**
 * Why an attempt failed: she touched a hazard; she was `lost`; the time was up (`timeout`); the player
 * gave up (`left`); or she reached the black hole with too few `minerals`.
 */
export type FailureCause =
  | {
      /** The kind of the object; `asteroid` means a deadly one. */
      readonly kind: Exclude<BodyKind, 'blackHole'>;
      /** Index within the level's list of that kind, from 0. */
      readonly index: number;
    }
  | {
      /** What happened. */
      readonly kind: 'lost' | 'timeout' | 'left' | 'minerals';
      /** No object is to blame. */
      readonly index: null;
    };

/** What one play turned out to be when it was simulated again. */
export interface Attempt {
  /** Index of the play within the plays that were given, from 0. */
  readonly play: number;
  /** How it ended. */
  readonly outcome: PlayOutcome;
  /** Why it failed; null when it succeeded. */
  readonly cause: FailureCause | null;
  /** Where her centre was at its end, px. */
  readonly x: number;
  /** See {@link Attempt.x}, px. */
  readonly y: number;
  /** Ticks that it lasted. */
  readonly tick: number;
  /** When it ended, s from the start. */
  readonly time: number;
  /** Different minerals that she collected. */
  readonly minerals: number;
  /** The ticks at which the button changed before its end: press, release, press, and so on. */
  readonly edges: readonly number[];
  /** The asteroids that the gun pulled her towards, in order, without repetitions in a row; indices from 0. */
  readonly route: readonly number[];
}

/** A play that does not count, and why. */
export interface RefusedPlay {
  /** Index of the play within the plays that were given, from 0. */
  readonly play: number;
  /**
   * `unknown-engine`: made with another engine; `stale-level`: of another level, or another version of it; `other-accuracy`: at
   * another accuracy; `claim-differs`: it does not end as it claims; `too-long`: it takes too much work or lasts too long.
   */
  readonly verdict: Extract<PlayVerdict, 'unknown-engine' | 'stale-level' | 'other-accuracy' | 'claim-differs' | 'too-long'>;
  /** What was expected and what was found. */
  readonly message: string;
}

/** Whether a play counts as an attempt. */
export const isAttempt = (replayed: Attempt | RefusedPlay): replayed is Attempt => 'outcome' in replayed;
