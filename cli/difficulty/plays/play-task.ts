import type { Attempt, RefusedPlay } from '../../../check/plays/index.ts';
import type { Terms } from '../../../engine/index.ts';
import type { PlayVerdict } from '../../../game/index.ts';
import type { Goal } from '../../../solver/index.ts';

/** A play that a worker reads: the path of its file, or its line; null for a line that is too long. */
export type PlaySource = { readonly path: string } | { readonly line: string | null };

/** A level that plays may be of. */
export interface PlayedLevel {
  readonly hash: string;
  readonly file: string;
}

/** Plays that a worker reads and simulates together. */
export interface PlayTask {
  readonly sources: readonly PlaySource[];
  readonly levels: readonly PlayedLevel[];
  readonly terms: Terms;
  readonly goal: Goal;
}

/** What a source turned out to be. */
export type PlayFinding = {
  /** What the line calls itself; null if it has no name. */
  readonly id: string | null;
  /** Who played, as the line says; null if it does not. */
  readonly subject: string | null;
} & (
  | { readonly kind: 'empty' }
  /** The index of its play is 0. */
  | { readonly kind: 'played'; readonly hash: string; readonly replayed: Attempt | RefusedPlay }
  | { readonly kind: 'elsewhere'; readonly hash: string }
  | { readonly kind: 'refused'; readonly verdict: Exclude<PlayVerdict, 'ok'>; readonly message: string }
  | { readonly kind: 'unreadable'; readonly message: string }
);
