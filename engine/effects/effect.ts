import type { Level } from '../../schema/index.ts';
import type { EventRule, Motion } from '../motion/index.ts';

/** A part of the game that a level may or may not call for. */
export interface Effect {
  readonly name: string;
  /** One line for a person: what it does. */
  readonly summary: string;
  /** Why this level calls for the effect, or why it doesn't. */
  calledFor(level: Level): { readonly called: boolean; readonly because: string };
  /**
   * The most it can accelerate her, px/s2. Forces of which one replaces the other say `instead`, and the strongest of them counts;
   * others add up. Left out where it doesn't accelerate her.
   */
  readonly force?: { readonly strongest: (level: Level) => number; readonly acts: 'instead' | 'beside' };
  /** She may be somewhere else from one moment to the next. */
  readonly jumps?: true;
  /** Things of the level move. */
  readonly moves?: true;
  /** Touching it ends the run badly. */
  readonly kills?: true;
  /** What can happen by it in continuous time. */
  readonly events?: readonly EventRule[];
  /** Makes for a motion in continuous time what is no part of its state. */
  attach?(m: Motion): void;
  /** Puts its things where the level has them, in continuous time. */
  layOut?(m: Motion): void;
}
