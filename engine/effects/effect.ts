import type { Level } from '../../schema/index.ts';

/** A part of the game that a level may or may not call for. */
export interface Effect {
  readonly name: string;
  /** One line for a person: what it does. */
  readonly summary: string;
  /** Why this level calls for the effect, or why it doesn't. */
  calledFor(level: Level): { readonly called: boolean; readonly because: string };
}
