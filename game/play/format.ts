import type { ACCURACIES, AccuracyName } from '../../engine/index.ts';
import { LIMITS } from '../../schema/basics/index.ts';
import { CHECKPOINT_TICKS } from '../player/index.ts';
import type { PlayOutcome } from './play.ts';

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
