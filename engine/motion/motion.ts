import type { Level, Rules } from '../../schema/basics/index.ts';
import { TICK_RATE } from '../constants.ts';
import type { Box } from '../contact.ts';
import type { IndexedCircles, Indexing } from '../indexed-circles.ts';
import type { Scene } from '../scene.ts';
import type { BodyKind, Ending, RunEvent } from '../simulation.ts';
import { SAME_INSTANT, SURPLUS } from '../tolerances.ts';
import type { WorkBudget } from '../work-budget.ts';
import { COAST, Flow, type Integrator, STEADY } from './flow.ts';
import { NeighbourList, Vicinity } from './neighbour-list.ts';
import { HEAD, LINES, RECORDS, SLOTS } from './state.ts';

const { START, NEXT, HELD, TARGET, FIELD, KIND, MOVES, LINE, RIM } = SLOTS;
const { CHASER, ROCK } = RECORDS;

/** The series of a chaser that has not begun to chase, and of what no chaser follows. */
const NO_SERIES = new Float64Array(0);

/** The modes of motion between two events. */
export const MODES = ['coast', 'pull', 'pull on a line', 'push', 'push on a line', 'slide on a rim', 'steady force'] as const;

/** Records the pieces and events of a run. */
export interface Recorder {
  /** Whether pieces are recorded; otherwise only events are, and quiet steps may be skipped. */
  readonly keeps: boolean;
  /** Records the motion's current piece, which is left after `t` seconds. */
  piece(motion: Motion, t: number): void;
  event(event: RunEvent): void;
}

/** How an event ends a run: the outcome, and the kind of object that was touched. */
export interface EndOfRun {
  readonly outcome: Ending['outcome'];
  readonly touches: BodyKind | null;
}

/** What {@link EventRule.fire} returns if the run goes on. */
export const GOES_ON = -1;

/**
 * A kind of event: when it may happen, when it does happen, and what follows. Each belongs to an effect and is part of a motion
 * only if the level calls for that effect. Objects are identified by their index in the scene's list. Times are in s after the
 * start of the piece.
 */
export interface EventRule {
  readonly name: string;
  /** Its place in the order of events at the same instant, from 1; the smaller one goes first. */
  kind: number;
  /** Not null if it can end the run; `fire` decides. */
  readonly ends: EndOfRun | null;
  /** The motion goes on unchanged, so the piece is not cut. */
  readonly passing: boolean;
  /** She may go on swinging, so what is known of her swing's period stays valid. */
  readonly keepsPeriod: boolean;
  /** Adds to the neighbour list what may happen before she is `m.near.skin` px away. */
  readonly list: ((m: Motion) => void) | null;
  /** Offers the time at which it happens to an object of the neighbour list, after `from`. */
  readonly guard: ((m: Motion, i: number, from: number) => void) | null;
  /** Whether an object of the neighbour list does not matter any more. */
  readonly isOver: ((m: Motion, i: number) => boolean) | null;
  /**
   * For how long, at most `time` s, it cannot happen to an object of the neighbour list, whatever the flow does; see `m.path`.
   */
  readonly quiet: ((m: Motion, i: number, time: number) => number) | null;
  /** Offers a bound of the piece's length, before anything else is looked for. */
  readonly first: ((m: Motion, from: number) => void) | null;
  /** By when it happens at the latest on a coast without an end, s after the start of the piece; Infinity if it may never. */
  readonly latest: ((m: Motion) => number) | null;
  /** Offers the time at which it happens to objects that are in no list, after `from`; `m.path` says where she goes. */
  readonly always: ((m: Motion, from: number) => void) | null;
  /** For how long, at most `time` s, it cannot happen to those, whatever the flow does. */
  readonly alwaysQuiet: ((m: Motion, time: number) => number) | null;
  /**
   * Carries out the event with object `a`, and `b` where there are two, at `time` s from the start of the run. Returns GOES_ON,
   * or the index of the object that ended the run.
   */
  readonly fire: (m: Motion, a: number, b: number, time: number) => number;
}

/** A force towards or away from a centre. Only one acts at a time: the first active one in the order of the effects. */
export interface CentralForce {
  readonly acts: 'instead';
  /** Upper bound of its acceleration, px/s². */
  strongest(level: Level, rules: Rules): number;
  isActing(m: Motion): boolean;
  /** Moves the origin of the frame to its centre. */
  centre(m: Motion): void;
  /** Sets strength and range of the {@link Flow}. */
  set(m: Motion): void;
  /**
   * How far from the centre she could get, at distance `d` (px) and speed `v` (px/s); Infinity if it does not hold her back.
   */
  swing(m: Motion, d: number, v: number): number;
}

/** A force that is uniform while it acts, in addition to all others. */
export interface SteadyForce {
  readonly acts: 'beside';
  /** Upper bound of its acceleration, px/s². */
  strongest(level: Level, rules: Rules): number;
  /** Adds it to the flow if it acts. */
  add(m: Motion): void;
}

/** What chases her, as the level places it. */
export interface ChaserCircles extends IndexedCircles {
  /** Pairs that overlap at the start, two indices each, in the order in which they explode. */
  readonly explosions: Int32Array;
}

/** Objects that chase her: they sleep until she is in sight, then they accelerate towards her. A level has one sort of them. */
export interface Chase {
  readonly kind: BodyKind;
  circles(scene: Scene): ChaserCircles;
  /** Their acceleration, px/s². */
  pull(rules: Rules): number;
  /** How far they see, from centre to centre, px. */
  sight(rules: Rules): number;
}

/** How she slides along the rim of a field. */
export interface Sliding {
  /** Sets `m.rim` from the state at the start of the piece. */
  set(m: Motion): void;
  /**
   * Expands her motion along the rim.
   * @param longest - the longest piece wanted, s
   * @returns the length for which the piece holds, s
   */
  expand(m: Motion, longest: number): number;
  /** Writes place and velocity after `t` of the piece to out[0..3]. */
  arrive(m: Motion, t: number, out: Float64Array): void;
  /**
   * When the speed limit frees an axis: 0 for x, 1 for y.
   * @param from - where to begin, s after the start of the piece
   * @returns s after the start of the piece; -1 if not before the piece ends
   */
  letGo(m: Motion, axis: number, from: number): number;
}

/** Bodies that accelerate towards her: chasers that are awake, and the asteroid that she drags from within a field. */
export interface Following {
  /** Readies them for a new piece. Returns how many there are. */
  begin(m: Motion): number;
  /**
   * Expands their motion; hers must be known.
   * @param longest - natural length of the piece, s
   * @returns the length for which all of them hold, s
   */
  expand(m: Motion, longest: number): number;
  /** After a restore: expands them as they were when the piece began; if the run is over, copies where they are. */
  restore(m: Motion): void;
  /** Moves them to where they are after `t`. */
  arrive(m: Motion, t: number): void;
}

type Hook = (m: Motion) => void;

/** What the chosen effects contribute to a motion. */
export interface Parts {
  /** All kinds of events, by their `kind`. */
  readonly byKind: readonly EventRule[];
  // the kinds that can happen here, by the way they are found
  readonly list: readonly EventRule[];
  readonly first: readonly EventRule[];
  readonly latest: readonly EventRule[];
  readonly always: readonly EventRule[];
  readonly alwaysQuiet: readonly EventRule[];
  /** Circles that events look for, of which an index may find some. */
  readonly circles: readonly ((scene: Scene) => IndexedCircles)[];
  /** Doubles of state that effects need for themselves; none for those that the level does not call for. */
  readonly own: readonly { readonly name: string; length(scene: Scene): number }[];
  /** Finds objects where there are many. */
  readonly indexing: Indexing;
  readonly chase: Chase | null;
  readonly central: readonly CentralForce[];
  readonly steady: readonly SteadyForce[];
  /** Called when she has been moved from one place to another: updates what depends on her place. */
  readonly moved: readonly ((m: Motion, time: number) => void)[];
  /** Called before the frame and flow of a new piece are chosen. */
  readonly beforePiece: readonly Hook[];
  /** Called after they are chosen: sets how her box turns. */
  readonly turn: readonly Hook[];
  /** Null if there are no rims to slide along. */
  readonly sliding: Sliding | null;
  /** Null if nothing follows her: nothing chases her, and no asteroid recoils. */
  readonly following: Following | null;
  /** Called at the natural end of a piece: may skip time in which the motion repeats itself. */
  readonly repeat: readonly Hook[];
  /** Whether the motion may soon repeat itself, so that no pieces may be skipped by gliding. */
  readonly mayRepeat: readonly ((m: Motion) => boolean)[];
}

/**
 * Her motion at the start of the piece: place relative to the origin (px), velocity (px/s), and bounds of how far she gets
 * (px).
 */
export class Path {
  x = 0;
  y = 0;
  vx = 0;
  vy = 0;
  speed = 0;
  /** By how much she may at once be faster than this, px/s; see {@link Integrator.kicksFirst}. */
  lead = 0;
  /** Upper bound of her acceleration until the next event, px/s², with room for the error of fixed steps. */
  strongest = 0;
  /** Upper bound of her own displacement; `reach` adds what asteroids may move. */
  travel = 0;
  reach = 0;
}

/** Which chasers are awake, and where the others sleep. */
export interface Crowd {
  /** Indices of the chasers that are awake, ascending; the state has their number. */
  readonly awake: Int32Array;
  /** Those that woke, fell asleep or are gone since this list was emptied; for a recorder. */
  readonly altered: number[];
  /** Whether any of them may differ from the start. */
  changed: boolean;
  /** Reads all this from the state, after it was replaced. */
  read(): void;
}

/**
 * A run in continuous time: the state, the current piece, and the working memory of the method. It is one record of one shape;
 * the functions of this folder work on it.
 *
 * Places are kept relative to where she starts, and hers relative to the centre of the acting force (the base of the frame). So
 * neither a distant origin nor a close pass costs digits.
 */
export class Motion {
  readonly scene: Scene;
  /** The game's rules in this scene. */
  readonly rules: Rules;
  readonly box: Box;
  /** Upper bound of the distance from her centre to a circle's edge when she touches it, px. */
  readonly touchMargin: number;
  readonly recorder: Recorder | null;
  readonly flow = new Flow();
  /** What {@link Sliding} keeps: the forces that act on the rim. Null if there are no rims. */
  rim: object | null = null;
  readonly near = new NeighbourList();
  /** What the neighbour list is made of, for each kind of event that is in it, and for the targets. */
  readonly vicinities: readonly Vicinity[];
  readonly targetsNear = new Vicinity();
  /** Work done since the last reset. */
  readonly work = { pieces: 0, forceEvaluations: 0, guards: 0, roots: 0 };
  /** Time spent in each of MODES since the last reset, s. */
  readonly modeSeconds: Float64Array = new Float64Array(MODES.length);
  /** The state; see {@link SLOTS}. The series below are views of its end. */
  readonly s: Float64Array;
  /** Her place u in the frame: coefficients. */
  readonly ux: Float64Array;
  readonly uy: Float64Array;
  /** The displacement of the base: coefficients. */
  readonly px: Float64Array;
  readonly py: Float64Array;
  /** Places of the chasers while they chase: coefficients. They follow from the state and are no part of it. */
  readonly chaserX: Float64Array[];
  readonly chaserY: Float64Array[];
  /** Null if nothing chases her. */
  crowd: Crowd | null = null;
  /** How many objects chase her; the asteroid that she drags has this index. */
  readonly chaserCount: number;
  /** Their acceleration, px/s². */
  readonly chaserPull: number;
  readonly path = new Path();
  /** Asteroids that the gun has held, ascending; all others are where the level places them. Follows from the state. */
  readonly stirred: number[] = [];
  /** Index in the state at which chasers, asteroids and the minerals' flags begin. */
  readonly chasers: number;
  readonly rocks: number;
  readonly minerals: number;
  /** Index in the state at which each effect's own doubles begin, by the effect's name. */
  readonly own: Readonly<Record<string, number>>;
  /** Index from which each target that moves has the number of the line that it moves along. */
  readonly lines: number;
  /** Whether the level has recoil. Even then nothing moves before the first press. */
  readonly recoils: boolean;
  readonly originX: number;
  readonly originY: number;
  /** Places of the targets relative to the origin, px. */
  readonly targetX: Float64Array;
  readonly targetY: Float64Array;
  /** Rate of the frames at which contacts are tested, Hz; 0 for swept contacts. */
  readonly frameRate: number;
  /** Whether an index finds some of the neighbours. */
  readonly crowded: boolean;
  // what the last look at the piece found; px and px/s: x, y, x', y'
  /**
   * Her place u in the frame and its velocity. This and the following arrays hold x, y, x', y' (px, px/s) of the time that was
   * last evaluated.
   */
  readonly her: Float64Array = new Float64Array(4);
  /** The displacement of the base and its velocity. */
  readonly base: Float64Array = new Float64Array(4);
  /** The vector from her to the centre of the circle that guards examine, and its derivative. */
  readonly toCircle: Float64Array = new Float64Array(4);
  /** The same for the target; while she slides, for the centre of the force outside. */
  readonly toTarget: Float64Array = new Float64Array(4);
  /** The direction of the box's x axis: cosine and sine. */
  readonly facing: Float64Array = new Float64Array(2);
  readonly steps: Int32Array = new Int32Array(1);
  /** Her place relative to the origin, which chasers follow; empty if there are none. */
  readonly wx: Float64Array;
  readonly wy: Float64Array;

  // the circle that a guard examines: its source, what was read from there, and where it is relative to the base
  circleFromX = 0;
  circleFromY = 0;
  circleOffX = 0;
  circleOffY = 0;
  circleX = 0;
  circleY = 0;
  circleVX = 0;
  circleVY = 0;
  circleMotion = 0;
  circleSeries = 0;

  /** @param budget - limits the work of looking for events */
  constructor(
    scene: Scene,
    readonly integrator: Integrator,
    readonly parts: Parts,
    recorder: Recorder | null,
    readonly budget: WorkBudget,
  ) {
    this.scene = scene;
    this.rules = scene.rules;
    this.box = scene.box;
    this.touchMargin = scene.box.halfDiagonal + SURPLUS;
    this.recorder = recorder;
    this.frameRate = scene.accuracy.contact === 'frame' ? (scene.accuracy.rate ?? TICK_RATE) : 0;
    const { level, targets, minerals } = scene;
    this.recoils = level.recoil && targets.count > 0;
    this.crowded = targets.spatial !== null || parts.circles.some((circles) => circles(scene).spatial !== null);
    this.originX = level.astronaut.x;
    this.originY = level.astronaut.y;
    this.targetX = new Float64Array(targets.count);
    this.targetY = new Float64Array(targets.count);
    for (let i = 0; i < targets.count; i++) {
      this.targetX[i] = targets.x[i] - this.originX;
      this.targetY[i] = targets.y[i] - this.originY;
    }
    const vicinities: Vicinity[] = [];
    for (const { kind } of parts.list) vicinities[kind] = new Vicinity();
    this.vicinities = vicinities;
    this.chaserCount = parts.chase?.circles(scene).count ?? 0;
    this.chaserPull = parts.chase?.pull(scene.rules) ?? 0;
    // an asteroid that she holds while in a field is dragged along: one more chaser
    const chasers = this.chaserCount + (this.recoils ? 1 : 0);
    const length = this.integrator.degree + 1;
    this.chasers = HEAD;
    this.rocks = this.chasers + CHASER * chasers;
    this.minerals = this.rocks + (this.recoils ? ROCK * targets.count : 0);
    this.lines = this.minerals + minerals.count;
    let end = this.lines + (this.recoils ? targets.count : 0);
    const own: Record<string, number> = {};
    for (const { name, length } of parts.own) {
      own[name] = end;
      end += length(scene);
    }
    this.own = own;
    this.s = new Float64Array(end + 4 * length);
    const series = () => {
      end += length;
      return this.s.subarray(end - length, end);
    };
    this.ux = series();
    this.uy = series();
    this.px = series();
    this.py = series();
    this.chaserX = new Array<Float64Array>(chasers).fill(NO_SERIES);
    this.chaserY = this.chaserX.slice();
    this.wx = chasers === 0 ? NO_SERIES : new Float64Array(length);
    this.wy = chasers === 0 ? NO_SERIES : new Float64Array(length);
  }

  /** Whether asteroids move: from the first press on if the level has recoil. */
  get recoil(): boolean {
    return this.s[MOVES] === 1;
  }

  /** The acceleration of the target's recoil, px/s²; 0 if it has none. */
  get kappa(): number {
    const { s } = this;
    if (!this.recoil || s[HELD] === 0) return 0;
    // at rest in the very centre there is no direction to recoil in
    if (s[KIND] === COAST && s[FIELD] < 0) return 0;
    return this.rules.recoil / (2 * this.scene.targets.r[s[TARGET]]);
  }

  /** Index into {@link MODES}. */
  get mode(): number {
    const { s } = this;
    if (s[KIND] === COAST) return 0;
    return s[KIND] === STEADY ? MODES.length - 1 : s[KIND] + (s[FIELD] >= 0 ? 2 : 0);
  }

  /** Events at most this far apart are at the same instant, s. */
  get sameInstant(): number {
    return SAME_INSTANT * (1 + this.s[START]);
  }

  /** Latest time at which an event can still be the first, s after the start of the piece. */
  get horizon(): number {
    return this.s[NEXT] + this.sameInstant;
  }
}

/** The index of the k-th awake chaser. */
export function awakeAt({ crowd }: Motion, k: number): number {
  return crowd === null ? -1 : crowd.awake[k];
}

/** The central force that acts on her now, or null. */
export function actingForce(m: Motion): CentralForce | null {
  const { central } = m.parts;
  for (let k = 0; k < central.length; k++) if (central[k].isActing(m)) return central[k];
  return null;
}

/** Moves her by (dx, dy), px, at once, at `time` s from the start of the run. Her velocity stays. */
export function moveBy(m: Motion, dx: number, dy: number, time: number): void {
  const { s, ux, uy, near } = m;
  ux[0] += dx;
  uy[0] += dy;
  s[LINE] = LINES.NONE;
  s[RIM] = -1;
  near.skin = -1;
  for (const moved of m.parts.moved) moved(m, time);
}
