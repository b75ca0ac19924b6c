import type { Level, ObjectList, RuleName, Rules } from '../../schema/basics/index.ts';
import type { HazardList } from '../clearance.ts';
import type { FrameRule } from '../frames.ts';
import type { IndexedCircles, Indexing } from '../indexed-circles.ts';
import type { CentralForce, Chase, EventRule, Following, Motion, Sliding, SteadyForce } from '../motion/index.ts';
import type { Scene } from '../scene.ts';

/**
 * A part of the game that is simulated only where a level calls for it. All members that take a `Motion` belong to the
 * simulation in continuous time.
 */
export interface Effect {
  /** Its name; where it has objects of its own, the name of their list in a level. */
  readonly name: string;
  /**
   * Describes what the effect does.
   *
   * @param rules - the game's rules
   * @returns one line for people, with the numbers of these rules
   */
  summary(rules: Rules): string;
  /**
   * Decides whether a level calls for the effect.
   *
   * @param level - the level
   * @returns `called`: whether the effect is simulated; `because`: why, in words
   */
  calledFor(level: Level): { readonly called: boolean; readonly because: string };
  /** The rules that belong to it. */
  readonly rules?: readonly RuleName[];
  /** How it accelerates her, if it does. */
  readonly force?: CentralForce | SteadyForce;
  /** Set if it can move her from one place to another at once. */
  readonly jumps?: true;
  /** Set if it moves objects of the level. */
  readonly moves?: true;
  /** Set if touching it ends the run with `collided`. */
  readonly kills?: true;

  /**
   * Derives from the level what the effect needs while it is simulated.
   *
   * @param level - the level
   * @param indexing - finds objects where there are many
   * @returns what {@link Scene.own} keeps under the effect's name
   */
  prepare?(level: Level, indexing: Indexing): unknown;
  /**
   * The effect's own events: for each `what` of a {@link RunEvent} of type `effect`, a function that takes the index of the
   * object, from 0, and returns a sentence without its subject.
   */
  readonly tells?: Readonly<Record<string, (index: number) => string>>;

  /** What it does in frames of `arcade`; left out where the frames themselves include it. */
  readonly frame?: FrameRule;

  // The rest is for continuous time; see `Parts`.
  /**
   * How many doubles of state it needs; they begin at `m.own[name]`.
   *
   * @param scene - the scene
   * @returns the number of doubles
   */
  stateLength?(scene: Scene): number;
  /**
   * Adjusts its state after an effect has moved her from one place to another.
   *
   * @param m - the motion
   * @param time - when, s from the start of the run
   */
  moved?(m: Motion, time: number): void;
  /** Its kinds of events. */
  readonly events?: readonly EventRule[];
  /**
   * Creates data for a motion that is not part of its state.
   *
   * @param m - the motion
   */
  attach?(m: Motion): void;
  /**
   * Sets its state to that at the start of a run.
   *
   * @param m - the motion
   */
  layOut?(m: Motion): void;
  /**
   * Called before the frame of reference and the flow of a new piece are chosen.
   *
   * @param m - the motion
   */
  beforePiece?(m: Motion): void;
  /**
   * Called after they are chosen; sets how the collision box turns.
   *
   * @param m - the motion
   */
  turn?(m: Motion): void;
  /** How she slides along the rims of its objects, if she does. */
  readonly sliding?: Sliding;
  /** Its part in moving what follows her, if anything does. */
  readonly following?: Following;
  /**
   * Called at the natural end of a piece; may skip time during which the motion repeats itself.
   *
   * @param m - the motion
   */
  repeat?(m: Motion): void;
  /**
   * Tells whether the motion may soon repeat itself, so that no pieces are skipped by other means.
   *
   * @param m - the motion
   * @returns whether it may
   */
  mayRepeat?(m: Motion): boolean;
}

/** An effect as the engine's parts declare it. */
export interface EngineEffect extends Effect {
  /** Its objects, if they chase her. */
  readonly chase?: Chase;
  /**
   * Its objects, if touching one ends the run.
   *
   * @param scene - the scene
   * @returns which of them do, and what moves them
   */
  hazard?(scene: Scene): HazardList;
  /**
   * Its objects, if she collects them by touch.
   *
   * @param scene - the scene
   * @returns the circles
   */
  collects?(scene: Scene): IndexedCircles;
  /**
   * The circles that its events look for. Where there are many, an index finds those near her.
   *
   * @param scene - the scene
   * @returns the circles
   */
  circles?(scene: Scene): IndexedCircles;
}

/** Calls for an effect where the level has at least one object in `list`. */
export function whereAny(list: ObjectList, one: string): Effect['calledFor'] {
  const notCalled = { called: false, because: `no ${list}` };
  return (level) => {
    const n = level[list].length;
    return n > 0 ? { called: true, because: `${n} ${n === 1 ? one : list}` } : notCalled;
  };
}
