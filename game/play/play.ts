import type { AccuracyName, Outcome } from '../../engine/index.ts';
import type { Hold } from '../../schema/basics/index.ts';

/** How a play ended: as a run does, or `left` if the player left while it went on. */
export type PlayOutcome = Outcome | 'left';

/** What a play says of itself. */
export interface PlayClaim {
  /** Ticks of 1/60 s that were played, as {@link Player.tick} says. */
  readonly tick: number;
  /** Minerals that were collected. */
  readonly minerals: number;
  /** How it ended. */
  readonly outcome: PlayOutcome;
}

/**
 * A recorded play, as a `.gqr` file contains it: what the player did, and what it claims to have led to. The player's inputs
 * alone decide the play, so `verifyPlay` can repeat it.
 */
export interface Play {
  /** The identity of the engine that it was played with, 16 hexadecimal digits. See {@link ENGINE_ID}. */
  readonly engine: string;
  /** The hash of the level, 64 hexadecimal digits. See {@link levelHash}. */
  readonly level: string;
  /** The accuracy. */
  readonly accuracy: AccuracyName;
  /** What the server gave the player before the play, 32 hexadecimal digits; null if there was none. */
  readonly challenge: string | null;
  /**
   * The holds, half-open intervals [press, release) in ticks of 1/60 s: sorted, and neither empty nor touching each other. One
   * that lasted to the end of the play has its last tick as release.
   */
  readonly holds: readonly Hold[];
  /** What it claims. */
  readonly claim: PlayClaim;
  /** The hash of the play, 16 hexadecimal digits. */
  readonly hash: string;
  /** The hashes at every multiple of 600 ticks. They say in which of these spans a replay first differs. */
  readonly checkpoints: readonly string[];
}
