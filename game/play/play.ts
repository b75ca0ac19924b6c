import type { ACCURACIES, AccuracyName, Outcome } from '../../engine/index.ts';
import { type Hold, LIMITS } from '../../schema/basics/index.ts';
import { CHECKPOINT_TICKS } from '../player/index.ts';

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

/** The first bytes of every play: 0x89, which no text begins with, and `GQR`. */
export const MAGIC = [0x89, 0x47, 0x51, 0x52] as const;

/** The version of the format. */
export const FORMAT_VERSION = 1;

/** Lengths in bytes. */
export const ENGINE_BYTES = 8;
export const LEVEL_BYTES = 32;
export const HASH_BYTES = 8;
export const CHALLENGE_BYTES = 16;

/** Accuracies by their byte. A new one is added at the end. */
export const ACCURACY_CODES: readonly AccuracyName[] = [
  'arcade',
  'fast',
  'standard',
  'precise',
] satisfies (keyof typeof ACCURACIES)[];

/** Outcomes by their byte. A new one is added at the end. */
export const OUTCOME_CODES: readonly PlayOutcome[] = ['completed', 'collided', 'lost', 'timeout', 'left'];

/** The most that a play can have. What is larger is refused before anything is allocated for it. */
export const PLAY_LIMITS = {
  /** Bytes of a file. */
  bytes: 65_536,
  /** Presses and releases together. */
  edges: 2 * LIMITS.holds,
  /** Ticks of 1/60 s: one hour. */
  ticks: LIMITS.tick,
} as const;

/** Whether a play of this outcome was still going on at its last tick. */
export const isOpen = (outcome: PlayOutcome): boolean => outcome === 'left' || outcome === 'timeout';

/** How many checkpoints a play has. The state in which it ended is covered by its hash and is no checkpoint. */
export const checkpointCount = (tick: number, outcome: PlayOutcome): number =>
  Math.floor((isOpen(outcome) ? tick : Math.max(0, tick - 1)) / CHECKPOINT_TICKS);
