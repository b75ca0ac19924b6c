import type { Level, Rules } from '../../schema/index.ts';
import { TICK_RATE } from '../constants.ts';
import type { Box } from '../contact/index.ts';
import type { Scene } from '../scene.ts';
import type { BodyKind, Ending, RunEvent } from '../simulation.ts';
import { SAME_INSTANT, SURPLUS } from '../tolerances.ts';
import type { WorkBudget } from '../work-budget.ts';
import { COAST, Flow, STEADY } from './flow.ts';
import type { Integrator } from './integrator.ts';
import { NeighbourList } from './neighbour-list.ts';
import { RimFlow } from './rim-flow.ts';
import { HEAD, LINES, RECORDS, SLOTS } from './state.ts';

const { START, NEXT, HELD, TARGET, FIELD, KIND, MOVES, LINE, RIM } = SLOTS;
const { CHASER, ROCK } = RECORDS;

/** A fixed step may make this much more of a force than it is. */
const FIXED_STEP_ROOM = 1.05;

/** Of a chaser that has not chased yet. */
const NO_SERIES = new Float64Array(0);

/** Whether a list of things is so long that an index finds the near ones. */
const hasIndex = (list: unknown): boolean =>
  typeof list === 'object' && list !== null && 'spatial' in list && list.spatial !== null;

/** What can move her between two events. */
export const MODES = ['coast', 'pull', 'pull on a line', 'push', 'push on a line', 'slide on a rim', 'steady force'] as const;

/** What keeps the pieces and events of a run. */
export interface Recorder {
  /** Keeps the piece that the motion is on; it is left after `t` seconds. */
  piece(motion: Motion, t: number): void;
  event(event: RunEvent): void;
}

/** How a run ends by an event: its outcome, and the kind of thing she touched. */
export interface EndOfRun {
  readonly outcome: Ending['outcome'];
  readonly touches: BodyKind | null;
}

/** What {@link EventRule.fire} returns where the run goes on. */
export const GOES_ON = -1;

/**
 * A kind of event: when it may happen, when it does, and what follows. Each belongs to an effect and is part of a motion only where
 * the level calls for that. Things are told apart by their index in the scene's list of them. Times in s after the start of the piece.
 */
export interface EventRule {
  readonly name: string;
  /** Its place in the order of events that fall on the same instant, from 1; the smaller goes first. */
  kind: number;
  /** Not null: the run ends by it, if `fire` says so. */
  readonly ends: EndOfRun | null;
  /** The motion goes on as it is: the piece is not cut. */
  readonly passing: boolean;
  /** She may be swinging on, and what is known of the period of her swing stays known. */
  readonly keepsPeriod: boolean;
  /** Adds to the neighbour list what may happen before she is `m.near.skin` px away. */
  readonly list: ((m: Motion) => void) | null;
  /** Offers when it happens to a thing of the neighbour list, after `from`. */
  readonly guard: ((m: Motion, i: number, from: number) => void) | null;
  /** Whether a thing of the neighbour list doesn't matter any more. */
  readonly isOver: ((m: Motion, i: number) => boolean) | null;
  /** For how long, at most `time` s, it can't happen to a thing of the neighbour list, whatever the flow does; see `m.path`. */
  readonly quiet: ((m: Motion, i: number, time: number) => number) | null;
  /** Offers what bounds the piece, before anything else is looked for. */
  readonly first: ((m: Motion, from: number) => void) | null;
  /** Offers when it happens to things that are in no list, after `from`; `m.path` says where she goes. */
  readonly always: ((m: Motion, from: number) => void) | null;
  /** For how long, at most `time` s, it can't happen to those, whatever the flow does. */
  readonly alwaysQuiet: ((m: Motion, time: number) => number) | null;
  /** What happens to thing `a`, with `b`, at `time` s from the start of the run; returns GOES_ON, or the index of what ended it. */
  readonly fire: (m: Motion, a: number, b: number, time: number) => number;
}

/** A force towards or away from a centre. Of several one acts at a time: the first in the order of the effects that does. */
export interface CentralForce {
  readonly acts: 'instead';
  /** The most it can accelerate her, px/s2. */
  strongest(level: Level, rules: Rules): number;
  isActing(m: Motion): boolean;
  /** Puts the origin of the frame into its centre. */
  centre(m: Motion): void;
  /** Sets strength and range of the flow; {@link Flow}. */
  set(m: Motion): void;
  /** How far from the centre she could get, at distance `d` (px) and speed `v` (px/s); Infinity where it doesn't hold her. */
  swing(m: Motion, d: number, v: number): number;
}

/** A force that is the same wherever she is while it acts, beside all others. */
export interface SteadyForce {
  readonly acts: 'beside';
  /** The most it can accelerate her, px/s2. */
  strongest(level: Level, rules: Rules): number;
  /** Adds it to the flow, if it acts. */
  add(m: Motion): void;
}

type Hook = (m: Motion) => void;

/** What the chosen effects bring to a motion. */
export interface Parts {
  /** All kinds of events there are, by their `kind`. */
  readonly byKind: readonly EventRule[];
  // those that can happen here, by how they are found
  readonly list: readonly EventRule[];
  readonly first: readonly EventRule[];
  readonly always: readonly EventRule[];
  readonly alwaysQuiet: readonly EventRule[];
  /** Numbers of state that effects need for themselves. */
  readonly own: readonly { readonly name: string; length(scene: Scene): number }[];
  readonly central: readonly CentralForce[];
  readonly steady: readonly SteadyForce[];
  /** She is somewhere else all at once: what depends on where she is follows. */
  readonly moved: readonly ((m: Motion, time: number) => void)[];
  /** Before the frame and flow of a new piece are chosen. */
  readonly beforePiece: readonly Hook[];
  /** After they are: says how her box turns. */
  readonly turn: readonly Hook[];
  /** Sets `m.rim` where she slides, from the state. */
  readonly setRim: readonly Hook[];
  /** Where a piece came to its natural end: may skip time in which all repeats itself. */
  readonly repeat: readonly Hook[];
  /** Whether all may repeat itself before long, so that no piece is to be glided over. */
  readonly mayRepeat: readonly ((m: Motion) => boolean)[];
}

/** Where she goes from the start of the piece: place relative to the origin (px), velocity (px/s), and how far (px). */
export class Path {
  x = 0;
  y = 0;
  vx = 0;
  vy = 0;
  speed = 0;
  /** Her own way at most; with what asteroids may move, too. */
  travel = 0;
  reach = 0;
}

/** Who of the aliens is awake, and where the others sleep. */
export interface Crowd {
  /** Indices of those that are awake, ascending; the state has how many. */
  readonly awake: Int32Array;
  /** Those that woke, fell asleep or exploded since this list was emptied; kept for a recorder. */
  readonly altered: number[];
  /** Whether one of them may be another than at the start. */
  changed: boolean;
  /** Finds out from the state, which has become another. */
  read(): void;
}

/**
 * A run in continuous time as it stands: the state, the piece it is on, and what every step of the method works with. One
 * record of one shape for all of them; what is done with it is in the functions of this folder.
 *
 * Places are kept relative to where she starts, and hers relative to the centre of the force that acts (the frame's
 * base), so that neither a far-off origin nor a close pass costs digits.
 */
export class Motion {
  readonly scene: Scene;
  /** The numbers of the game in this scene. */
  readonly rules: Rules;
  readonly box: Box;
  /** How far from a circle's rim her centre is at most when she touches it, px, with room. */
  readonly touchMargin: number;
  readonly recorder: Recorder | null;
  readonly flow = new Flow();
  /** What acts where she slides along a rim. */
  readonly rim = new RimFlow();
  readonly near = new NeighbourList();
  /** Work done since the last reset. */
  readonly work = { pieces: 0, forceEvaluations: 0, guards: 0, roots: 0 };
  /** Time spent in each of MODES since the last reset, s. */
  readonly modeSeconds = new Float64Array(MODES.length);
  /** The state, see {@link SLOTS}; the series below are views of its end. */
  readonly s: Float64Array;
  /** Her place in the frame, u: coefficients. */
  readonly ux: Float64Array;
  readonly uy: Float64Array;
  /** The displacement of the base. */
  readonly px: Float64Array;
  readonly py: Float64Array;
  /** Places of those that chase, while they do: coefficients. They follow from the state and are no part of it. */
  readonly chaserX: Float64Array[] = [];
  readonly chaserY: Float64Array[] = [];
  /** null where the level has no aliens. */
  crowd: Crowd | null = null;
  readonly path = new Path();
  /** Rocks that the gun has held, ascending: all others stay where the level has them. Follows from the state. */
  readonly stirred: number[] = [];
  /** Where in the state chasers, rocks and the minerals' flags begin. */
  readonly chasers: number;
  readonly rocks: number;
  readonly minerals: number;
  /** From here on a flag for each repulsor that contains her. */
  readonly inside: number;
  /** Where in the state that of each effect begins which has some of its own, by its name. */
  readonly own: Readonly<Record<string, number>>;
  /** From here on, for each target that moves, the line that it moves along. */
  readonly lines: number;
  /** Whether the level has recoil; nothing moves before the first press. */
  readonly recoils: boolean;
  readonly originX: number;
  readonly originY: number;
  /** Places of the targets relative to the origin, px. */
  readonly targetX: Float64Array;
  readonly targetY: Float64Array;
  /** Rate of the frames at which contacts are seen, or 0. */
  readonly frameRate: number;
  /** Bound on any acceleration of hers, px/s2, with room for what a fixed step makes of it. */
  readonly strongest: number;
  /** Whether an index finds some of the neighbours. */
  readonly crowded: boolean;
  // what the last look at the piece found; px and px/s: x, y, x', y'
  /** Her place u in the frame, and its velocity. */
  readonly her = new Float64Array(4);
  /** The displacement of the base, and its velocity. */
  readonly base = new Float64Array(4);
  /** The centre of the circle that guards look at minus her place, and the velocity of that. */
  readonly toCircle = new Float64Array(4);
  /** The same for the target; where she slides, for the centre of the force outside. */
  readonly toTarget = new Float64Array(4);
  /** The direction of the x axis of her box: cosine and sine. */
  readonly facing = new Float64Array(2);
  readonly steps = new Int32Array(1);
  /** Her place relative to the origin: what chasers follow. */
  readonly wx: Float64Array;
  readonly wy: Float64Array;

  // the circle a guard is about: where it was read, what was taken from that, and where it is relative to the base
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

  /**
   * @param budget what looking for events may cost
   */
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
    this.strongest = FIXED_STEP_ROOM * scene.strongest;
    this.frameRate = scene.accuracy.contact === 'frame' ? (scene.accuracy.rate ?? TICK_RATE) : 0;
    const { level, targets, aliens, minerals, novae, repulsors } = scene;
    this.recoils = level.recoil && targets.count > 0;
    this.crowded = [targets, novae, minerals, repulsors, ...Object.values(scene.own)].some(hasIndex);
    this.originX = level.astronaut.x;
    this.originY = level.astronaut.y;
    this.targetX = targets.x.map((x) => x - this.originX);
    this.targetY = targets.y.map((y) => y - this.originY);
    // the rock she holds while in a field is dragged along like an alien: one chaser more
    const chasers = aliens.count + (this.recoils ? 1 : 0);
    const length = this.integrator.degree + 1;
    this.chasers = HEAD;
    this.rocks = this.chasers + CHASER * chasers;
    this.minerals = this.rocks + (this.recoils ? ROCK * targets.count : 0);
    this.inside = this.minerals + minerals.count;
    this.lines = this.inside + repulsors.count;
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
    for (let i = 0; i < chasers; i++) {
      this.chaserX.push(NO_SERIES);
      this.chaserY.push(NO_SERIES);
    }
    this.wx = new Float64Array(length);
    this.wy = new Float64Array(length);
  }

  /** Whether asteroids move: from the first press on where the level has recoil. */
  get recoil(): boolean {
    return this.s[MOVES] === 1;
  }

  /** The acceleration of the target's recoil, px/s2; 0 where it has none. */
  get kappa(): number {
    const { s } = this;
    if (!this.recoil || s[HELD] === 0) return 0;
    // at rest in its very centre there is no direction to recoil in
    if (s[KIND] === COAST && s[FIELD] < 0) return 0;
    return this.rules.recoil / (2 * this.scene.targets.r[s[TARGET]]);
  }

  /** Index into {@link MODES}. */
  get mode(): number {
    const { s } = this;
    if (s[KIND] === COAST) return 0;
    return s[KIND] === STEADY ? MODES.length - 1 : s[KIND] + (s[FIELD] >= 0 ? 2 : 0);
  }

  /** Events no farther apart than this are the same instant, s. */
  get sameInstant(): number {
    return SAME_INSTANT * (1 + this.s[START]);
  }

  /** Up to when an event can still be the first, s after the start of the piece. */
  get horizon(): number {
    return this.s[NEXT] + this.sameInstant;
  }
}

/** The index of the k-th alien that is awake. */
export function awakeAt({ crowd }: Motion, k: number): number {
  return crowd === null ? -1 : crowd.awake[k];
}

/** The force that acts on her now, or null. */
export function actingForce(m: Motion): CentralForce | null {
  const { central } = m.parts;
  for (let k = 0; k < central.length; k++) if (central[k].isActing(m)) return central[k];
  return null;
}

/** She is moved by (dx, dy), px, all at once, at `time` s from the start of the run; her velocity stays. */
export function moveBy(m: Motion, dx: number, dy: number, time: number): void {
  const { s, ux, uy, near } = m;
  ux[0] += dx;
  uy[0] += dy;
  s[LINE] = LINES.NONE;
  s[RIM] = -1;
  near.skin = -1;
  for (const moved of m.parts.moved) moved(m, time);
}
