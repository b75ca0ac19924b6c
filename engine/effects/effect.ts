import type { Level, RuleName, Rules } from '../../schema/index.ts';
import type { FrameRule } from '../frames/index.ts';
import type { CentralForce, EventRule, Motion, SteadyForce } from '../motion/index.ts';
import type { Scene } from '../scene.ts';

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

  /** Makes of the level what it needs while it is simulated: {@link Scene.own}. */
  prepare?(level: Level): unknown;
  /** What its own events are called: `what` of the event, and a sentence without a subject, about thing `index`. */
  readonly tells?: Readonly<Record<string, (index: number) => string>>;

  /** In `arcade`; left out where the frames of the original have it. */
  readonly frame?: FrameRule;

  // in continuous time, see Parts
  /** Numbers of state that it needs for itself; they begin at `m.own[name]`. */
  stateLength?(scene: Scene): number;
  moved?(m: Motion, time: number): void;
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
