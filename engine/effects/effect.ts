import type { Level, RuleName, Rules } from '../../schema/index.ts';
import type { CentralForce, EventRule, Motion, SteadyForce } from '../motion/index.ts';

/** A part of the game that a level may or may not call for. */
export interface Effect {
  readonly name: string;
  /** One line for a person: what it does under these rules. */
  summary(rules: Rules): string;
  /** Why this level calls for the effect, or why it doesn't. */
  calledFor(level: Level): { readonly called: boolean; readonly because: string };
  /** The rules that are about it. */
  readonly rules?: readonly RuleName[];
  /** How it accelerates her, if it does. */
  readonly force?: CentralForce | SteadyForce;
  /** She may be somewhere else from one moment to the next. */
  readonly jumps?: true;
  /** Things of the level move. */
  readonly moves?: true;
  /** Touching it ends the run badly. */
  readonly kills?: true;

  // in continuous time, see Parts
  /** What can happen by it. */
  readonly events?: readonly EventRule[];
  /** Makes for a motion what is no part of its state. */
  attach?(m: Motion): void;
  /** Puts its things where the level has them. */
  layOut?(m: Motion): void;
  beforePiece?(m: Motion): void;
  turn?(m: Motion): void;
  setRim?(m: Motion): void;
  repeat?(m: Motion): void;
  mayRepeat?(m: Motion): boolean;
}
