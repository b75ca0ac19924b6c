import {
  ALIEN_PULL,
  ALIEN_SIGHT,
  GUN_PULL,
  HALF_DIAGONAL,
  HALF_HEIGHT,
  HALF_WIDTH,
  REPULSOR_PUSH,
  SPEED_LIMIT,
  TICK_RATE,
} from '../constants.ts';
import { boxCircleGap } from '../contact/index.ts';
import type { IndexedCircles, Scene } from '../scene.ts';
import type { BodyKind, Ending, Mode, Simulation } from '../simulation.ts';
import { CENTRAL, COAST, Flow, LINEAR } from './flow.ts';
import { untilGrid } from './glide.ts';
import { type Integrator, integratorOf } from './integrator.ts';
import { safeStep } from './march.ts';
import { NeighbourList } from './neighbour-list.ts';
import { pairAt } from './polynomial.ts';
import type { PieceRecorder } from './recording.ts';

// Layout of the state: one typed array, so that a snapshot is one copy.
const START = 0; // time the piece begins, s
const FROM = 1; // events up to this time after START are behind us, s
const NEXT = 2; // time after START of the next event or the natural end, s
const EVENT = 3;
const EVENT_A = 4;
const EVENT_B = 5;
const TICK_NOW = 6;
const HELD = 7;
const TARGET = 8;
const FIELD = 9;
const COVER = 10; // an asteroid that keeps her in range
const BASE = 11; // the target whose place is the origin of the frame, or -1: a fixed point
const BASE_X = 12;
const BASE_Y = 13;
const KIND = 14; // of flow
const TURN = 15;
const COS = 16;
const SIN = 17;
const SIDE = 18; // LINEAR: +1 or -1, on which side of the centre she is along (LINE_X, LINE_Y)
const LINE_X = 19;
const LINE_Y = 20;
const LIMIT_X = 21; // +1 or -1 while the speed limit holds that axis
const LIMIT_Y = 22;
const OUTCOME = 23;
const TOUCHED = 24;
const END_TIME = 25;
const MINERALS = 26;
const LAST_EVENT = 27; // the guard that fired at START: it is at its zero, not past it
const LAST_A = 28;
const DEGREE = 29;
const LENGTH_H = 30; // natural length of the piece, s
const ACCELERATION = 31; // bound on |u''| over the piece, px/s2
const MOVES = 32; // 1 from the first press on where the level has recoil
const AWAKE_COUNT = 33;
const CROSSED = 34; // LINEAR: when she last crossed the centre, and the time before; 0 when something else happened since
const CROSSED_BEFORE = 35;
const RIM = 36; // the rim crossed last, when, and how often in no time; until when it is not watched
const RIM_TIME = 37;
const RIM_COUNT = 38;
const RIM_HOLD = 39;
const HEAD = 40;

// what turns the box
const TURN_NOT = 0;
const TURN_TO_BASE = 1;
const TURN_TO_TARGET = 2;

// events, in the order in which they happen when they fall on the same instant
const MINERAL = 1;
const NOVA = 2;
const HOT = 3;
const ALIEN_TOUCH = 4;
const HOLE = 5;
const LEAVE_COVER = 6;
const CENTRE = 7;
const SWITCH = 8;
const ENTER = 9;
const LEAVE = 10;
const WAKE = 11;
const SLEEP = 12;
const PAIR = 13;
const LIMIT = 14;
const UNLIMIT = 15;
const PIECE_END = 16;

const OUTCOME_OF: readonly (Ending['outcome'] | null)[] = [null, null, 'collided', 'collided', 'collided', 'completed', 'lost'];
const TOUCH_KIND: readonly (BodyKind | null)[] = [null, null, 'nova', 'asteroid', 'alien', 'blackHole', null];

/** Two events nearer than this are the same instant, s per s of time and at least one second's worth. */
const SAME_INSTANT = 2e-14;

/** The smallest stride past a guard that touches zero without crossing it, s. What it may overlook is below 1e-18 px deep. */
const SMALLEST_STRIDE = 1e-10;

/** A dip across the bisector of two asteroids shallower than this is within the error of the way: no change of target, px. */
const TIE = 1e-11;

/** An impact parameter that rounding can't tell from 0, px: the motion is on a line through the centre. */
const RADIAL = 1e-12;

/**
 * A swing or orbit about the centre smaller than this counts as rest in it, px: it would take more events a second than
 * anybody could wait for, and its velocity is below 3e-3 px/s.
 */
const SMALLEST_ORBIT = 1e-7;

// Per alien: place, velocity, what it is up to.
const CHASER = 5;
const ASLEEP = 0;
const AWAKE = 1;
const GONE = 2;

const ROCK = 4;

/** Two crossings of a rim nearer than this may be sliding along it, s. */
const SLIDING = 1 / 480;

/** Longest piece of a coast among so many things that an index finds the near ones, px. */
const CROWDED_REACH = 128;

/** Bound on any acceleration of hers, px/s2, with room for what a fixed step makes of it. */
const STRONGEST = 1.05 * GUN_PULL;

// how the circle of a contact moves
const STILL = 0;
const DRIFTS = 1;
const SERIES = 2;
const IS_BASE = 3;

/** What can move her between two events. */
export const MODES = ['coast', 'pull', 'pull on a line', 'push', 'push on a line'] as const;

/**
 * The game in continuous time: a hybrid automaton. Between events every body moves on a polynomial piece; guards
 * (contacts, target changes, rims, ...) are located on the piece; the earliest event ends it and may change the flow.
 * Pieces depend on what happened, not on how `advance` was called, so a run split anywhere gives the same bits.
 *
 * Places are kept relative to where she starts, and hers relative to the centre of the force that acts (the frame's
 * base), so that neither a far-off origin nor a close pass costs digits.
 */
export class ContinuousSimulation implements Simulation {
  readonly scene: Scene;
  /** Work done since the last reset. */
  readonly work = { pieces: 0, forceEvaluations: 0, guards: 0, roots: 0 };
  /** Time spent in each of MODES since the last reset, s. */
  private readonly modeSeconds = new Float64Array(MODES.length);
  private readonly s: Float64Array;
  private readonly start: Float64Array;
  private readonly ux: Float64Array;
  private readonly uy: Float64Array;
  private readonly px: Float64Array;
  private readonly py: Float64Array;
  private readonly chasers: number;
  private readonly chaserX: Float64Array[] = [];
  private readonly chaserY: Float64Array[] = [];
  private readonly rocks: number;
  private readonly minerals: number;
  /** From here on a flag for each repulsor that contains her. */
  private readonly inside: number;
  /** Whether the level has recoil; nothing moves before the first press. */
  private readonly recoils: boolean;
  private readonly originX: number;
  private readonly originY: number;
  /** Places of everything relative to the origin, px. */
  private readonly targetX: Float64Array;
  private readonly targetY: Float64Array;
  private readonly flow = new Flow();
  private readonly integrator: Integrator;
  private readonly frameRate: number;
  private readonly crowded: boolean;
  private readonly near: NeighbourList;
  private readonly recorder: PieceRecorder | null;
  private readonly e = new Float64Array(12);
  private readonly steps = new Int32Array(1);
  private readonly wx: Float64Array;
  private readonly wy: Float64Array;

  // the circle whose contact is being located, relative to the base
  private circleX = 0;
  private circleY = 0;
  private circleVX = 0;
  private circleVY = 0;
  private circleMotion = STILL;
  private circleSeries = 0;

  constructor(scene: Scene, recorder: PieceRecorder | null = null) {
    this.scene = scene;
    this.recorder = recorder;
    this.integrator = integratorOf(scene.accuracy);
    this.frameRate = scene.accuracy.contact === 'frame' ? (scene.accuracy.rate ?? TICK_RATE) : 0;
    const { level, targets, aliens, minerals, novae, repulsors } = scene;
    this.recoils = level.recoil && targets.count > 0;
    this.crowded = [targets, novae, minerals, repulsors].some(({ spatial }) => spatial !== null);
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
    let end = this.inside + repulsors.count;
    this.s = new Float64Array(end + length * (4 + 2 * chasers));
    const series = () => {
      end += length;
      return this.s.subarray(end - length, end);
    };
    this.ux = series();
    this.uy = series();
    this.px = series();
    this.py = series();
    for (let i = 0; i < chasers; i++) {
      this.chaserX.push(series());
      this.chaserY.push(series());
    }
    this.wx = new Float64Array(length);
    this.wy = new Float64Array(length);
    this.near = new NeighbourList(2 * (targets.count + aliens.count) + novae.count + minerals.count + repulsors.count + 1);
    this.layOut();
    this.start = this.s.slice();
    this.begin();
    this.start.set(this.s);
  }

  private layOut(): void {
    const { s, scene } = this;
    const { level, aliens } = scene;
    s[TARGET] = -1;
    s[FIELD] = -1;
    s[COVER] = -1;
    s[BASE] = -1;
    s[RIM] = -1;
    s[COS] = 1;
    this.ux[1] = level.astronaut.vx;
    this.uy[1] = level.astronaut.vy;
    if (this.recoils) {
      for (let i = 0; i < scene.targets.count; i++) {
        s[this.rocks + ROCK * i] = this.targetX[i];
        s[this.rocks + ROCK * i + 1] = this.targetY[i];
      }
    }
    for (let i = 0; i < aliens.count; i++) {
      const o = this.chasers + CHASER * i;
      s[o] = aliens.x[i] - this.originX;
      s[o + 1] = aliens.y[i] - this.originY;
      if (s[o] * s[o] + s[o + 1] * s[o + 1] >= ALIEN_SIGHT * ALIEN_SIGHT) continue;
      s[o + 4] = AWAKE;
      s[AWAKE_COUNT]++;
    }
    s[COVER] = this.nearest();
    this.enterFields();
    const limit = (v: number) => (v >= SPEED_LIMIT ? 1 : v <= -SPEED_LIMIT ? -1 : 0);
    s[LIMIT_X] = limit(this.ux[1]);
    s[LIMIT_Y] = limit(this.uy[1]);
    this.holdLimits();
  }

  /** Whether asteroids move: from the first press on where the level has recoil. */
  private get recoil(): boolean {
    return this.s[MOVES] === 1;
  }

  get tick(): number {
    return this.s[TICK_NOW];
  }

  get modes(): readonly Mode[] {
    const seconds = Float64Array.from(this.modeSeconds);
    seconds[this.mode] += this.sincePieceBegan;
    const all = seconds.reduce((sum, t) => sum + t, 0);
    return MODES.map((name, i) => ({ name, share: all > 0 ? seconds[i] / all : 0 })).filter(({ share }) => share > 0);
  }

  get mineralCount(): number {
    return this.s[MINERALS];
  }

  get ending(): Ending | null {
    const code = this.s[OUTCOME];
    const outcome = OUTCOME_OF[code];
    if (outcome === null) return null;
    const time = this.s[END_TIME];
    const kind = TOUCH_KIND[code];
    return {
      outcome,
      with: kind === null ? null : { kind, index: this.s[TOUCHED] },
      time,
      tick: Math.floor(time * TICK_RATE + 1e-9),
    };
  }

  reset(): void {
    this.s.set(this.start);
    if (this.scene.aliens.count > 0 || this.recoils) this.near.skin = -1;
    this.setFlow();
    this.modeSeconds.fill(0);
    const { work } = this;
    work.pieces = work.forceEvaluations = work.guards = work.roots = 0;
  }

  snapshot(into?: Float64Array): Float64Array {
    if (into === undefined || into.length !== this.s.length) return this.s.slice();
    into.set(this.s);
    return into;
  }

  restore(snapshot: Float64Array): void {
    if (snapshot.length !== this.s.length) {
      throw new RangeError(`expected a snapshot of ${this.s.length} numbers of this scene, found ${snapshot.length}`);
    }
    this.s.set(snapshot);
    if (this.scene.aliens.count > 0 || this.recoils) this.near.skin = -1;
    this.setFlow();
  }

  /** Time since the piece began at which the simulation stands, s. */
  private get sincePieceBegan(): number {
    const { s } = this;
    return Math.max(0, (s[OUTCOME] === 0 ? s[TICK_NOW] / TICK_RATE : s[END_TIME]) - s[START]);
  }

  readState(out: Float64Array): void {
    this.stateAt(this.sincePieceBegan, out);
  }

  readAliens(out: Float64Array): void {
    this.aliensAt(this.sincePieceBegan, out);
  }

  readAsteroids(out: Float64Array): void {
    this.asteroidsAt(this.sincePieceBegan, out);
  }

  /** As `readState`, `t` seconds after the piece began. */
  stateAt(t: number, out: Float64Array): void {
    const { s, e } = this;
    this.settleAt(t);
    out[0] = this.originX + (s[BASE_X] + e[4] + e[0]);
    out[1] = this.originY + (s[BASE_Y] + e[5] + e[1]);
    out[2] = e[2] + e[6];
    out[3] = e[3] + e[7];
    this.directionAt(t);
    out[4] = e[8];
    out[5] = e[9];
  }

  /** As `readAliens`, `t` seconds after the piece began. */
  aliensAt(t: number, out: Float64Array): void {
    const { s, e } = this;
    for (let i = 0; i < this.scene.aliens.count; i++) {
      this.alienPlaceAt(i, t, 0);
      out[3 * i] = this.originX + e[0];
      out[3 * i + 1] = this.originY + e[1];
      out[3 * i + 2] = s[this.chasers + CHASER * i + 4] === GONE ? 0 : 1;
    }
  }

  /** As `readAsteroids`, `t` seconds after the piece began. */
  asteroidsAt(t: number, out: Float64Array): void {
    const { targets } = this.scene;
    for (let i = 0; i < targets.count; i++) {
      this.rockAt(i, t);
      out[2 * targets.index[i]] = this.originX + this.e[0];
      out[2 * targets.index[i] + 1] = this.originY + this.e[1];
    }
  }

  /** When the present piece began, s. */
  get pieceStart(): number {
    return this.s[START];
  }

  isCollected(mineral: number): boolean {
    return this.s[this.minerals + mineral] !== 0;
  }

  advance(ticks: number, held: boolean): number {
    const { s } = this;
    if (s[OUTCOME] !== 0) return 0;
    const from = s[TICK_NOW];
    const limit = from + ticks;
    if ((s[HELD] === 1) !== held) {
      this.runUntil(from / TICK_RATE);
      if (s[OUTCOME] === 0) this.button(held, from / TICK_RATE);
    }
    this.runUntil(limit / TICK_RATE);
    s[TICK_NOW] = s[OUTCOME] === 0 ? limit : Math.min(limit, Math.max(from, Math.floor(s[END_TIME] * TICK_RATE + 1e-9) + 1));
    return s[TICK_NOW] - from;
  }

  private runUntil(time: number): void {
    const { s } = this;
    let still = 0;
    while (s[OUTCOME] === 0 && s[START] + s[NEXT] <= time) {
      still = s[NEXT] > s[FROM] ? 0 : still + 1;
      if (still > 10_000) throw new Error(`more than 10,000 events at ${s[START] + s[NEXT]} s: the run does not go on`);
      this.fire(time);
    }
  }

  /** Gives the piece that is still going on to the recorder: the run is over. */
  recordLast(): void {
    this.recorder?.piece(this, this.sincePieceBegan);
  }

  /** Presses or releases at `time`. */
  private button(held: boolean, time: number): void {
    const { s } = this;
    this.stop(time - s[START], time);
    s[HELD] = held ? 1 : 0;
    s[CROSSED] = 0;
    if (held && this.recoils) s[MOVES] = 1;
    s[TARGET] = held ? this.nearest() : -1;
    if (held) s[COVER] = s[TARGET];
    if (this.recorder !== null) {
      this.recorder.event({ time, type: held ? 'press' : 'release' });
      if (held) this.recordTarget(time);
    }
    this.begin();
  }

  private recordTarget(time: number): void {
    this.recorder?.event({ time, type: 'target', index: this.scene.targets.index[this.s[TARGET]] });
  }

  /** Index into MODES. */
  private get mode(): number {
    const { s } = this;
    return s[KIND] === COAST ? 0 : s[KIND] + (s[FIELD] >= 0 ? 2 : 0);
  }

  /** Ends the piece after `t`: everything is put where it is then, and the next piece begins at `time`. */
  private stop(t: number, time: number): void {
    const { s, e, ux, uy, px, py } = this;
    this.recorder?.piece(this, t);
    this.modeSeconds[this.mode] += t;
    this.directionAt(t);
    s[COS] = e[8];
    s[SIN] = e[9];
    const aliens = this.scene.aliens.count;
    const { degree } = this.integrator;
    for (let i = 0; i < this.chaserX.length; i++) {
      const o = this.chasers + CHASER * i;
      if (s[o + 4] !== AWAKE) continue;
      const qx = this.chaserX[i];
      const qy = this.chaserY[i];
      pairAt(qx, qy, degree, t, s, o);
      // the series begins here too, for whoever looks before the next piece is made, if one is
      qx[0] = s[o];
      qy[0] = s[o + 1];
      if (i < aliens) continue;
      const rock = this.rocks + ROCK * s[TARGET];
      for (let k = 0; k < ROCK; k++) s[rock + k] = s[o + k];
      s[o + 4] = ASLEEP;
    }
    this.settleAt(t);
    ux[0] = e[0];
    uy[0] = e[1];
    ux[1] = e[2];
    uy[1] = e[3];
    if (this.recoil) {
      const dragged = s[HELD] === 1 && s[FIELD] >= 0 ? s[TARGET] : -1;
      for (let i = 0; i < this.scene.targets.count; i++) {
        const o = this.rocks + ROCK * i;
        if (i === s[BASE] || i === dragged) continue;
        s[o] += s[o + 2] * t;
        s[o + 1] += s[o + 3] * t;
      }
      s[BASE_X] += e[4];
      s[BASE_Y] += e[5];
      px[0] = 0;
      py[0] = 0;
      px[1] = e[6];
      py[1] = e[7];
      if (s[BASE] >= 0) {
        const o = this.rocks + ROCK * s[BASE];
        s[o] = s[BASE_X];
        s[o + 1] = s[BASE_Y];
        s[o + 2] = e[6];
        s[o + 3] = e[7];
      }
    }
    s[START] = time;
    s[FROM] = 0;
    if (t > 0) s[LAST_EVENT] = 0;
  }

  /** What happens at the event that was located. */
  private fire(until: number): void {
    const { s, scene, recorder } = this;
    const kind = s[EVENT];
    const a = s[EVENT_A];
    const time = s[START] + s[NEXT];
    if (kind === MINERAL) {
      s[this.minerals + a] = 1;
      s[MINERALS]++;
      s[FROM] = s[NEXT];
      recorder?.event({ time, type: 'mineral', index: scene.minerals.index[a] });
      this.locate();
      return;
    }
    this.stop(s[NEXT], time);
    s[LAST_EVENT] = 0;
    if (kind !== CENTRE && kind !== PIECE_END) s[CROSSED] = 0;
    if (kind === PIECE_END) {
      if (this.integrator.glide !== null && recorder === null) this.skipQuietSteps(until);
      if (s[LIMIT_X] === 0 && s[LIMIT_Y] === 0) this.proceed();
      else this.begin();
      return;
    }
    switch (kind) {
      case NOVA:
      case HOT:
      case ALIEN_TOUCH:
      case HOLE:
        this.end(kind, kind === HOT ? scene.targets.index[a] : a, time);
        return;
      case LEAVE_COVER: {
        const other = this.nearest();
        if (other < 0 || other === a || this.distanceSquared(other) > scene.level.range * scene.level.range) {
          this.end(LEAVE_COVER, 0, time);
          return;
        }
        s[COVER] = other;
        break;
      }
      case CENTRE:
        this.ux[0] = 0;
        this.uy[0] = 0;
        this.skipPeriods();
        break;
      case SWITCH:
        s[LAST_EVENT] = SWITCH;
        s[LAST_A] = s[TARGET];
        s[TARGET] = a;
        s[COVER] = a;
        this.recordTarget(time);
        break;
      case ENTER:
      case LEAVE:
        s[this.inside + a] = kind === ENTER ? 1 : 0;
        s[FIELD] = this.actingField();
        s[LAST_EVENT] = kind === ENTER ? LEAVE : ENTER;
        s[LAST_A] = a;
        this.watchForSliding(a, time);
        recorder?.event({ time, type: kind === ENTER ? 'enter' : 'leave', index: a });
        break;
      case WAKE:
      case SLEEP: {
        const o = this.chasers + CHASER * a;
        s[o + 2] = 0;
        s[o + 3] = 0;
        s[o + 4] = kind === WAKE ? AWAKE : ASLEEP;
        s[AWAKE_COUNT] += kind === WAKE ? 1 : -1;
        this.near.skin = -1;
        s[LAST_EVENT] = kind === WAKE ? SLEEP : WAKE;
        s[LAST_A] = a;
        recorder?.event({ time, type: kind === WAKE ? 'wake' : 'sleep', index: a });
        break;
      }
      case PAIR:
        this.explode(a);
        this.explode(s[EVENT_B]);
        recorder?.event({ time, type: 'explosion', aliens: [a, s[EVENT_B]] });
        break;
      case LIMIT:
        s[a === 0 ? LIMIT_X : LIMIT_Y] = s[EVENT_B];
        this.holdLimits();
        break;
      case UNLIMIT:
        s[LAST_EVENT] = LIMIT;
        s[LAST_A] = a;
        s[a === 0 ? LIMIT_X : LIMIT_Y] = 0;
        break;
      default:
    }
    this.begin();
  }

  private explode(alien: number): void {
    const { s } = this;
    const o = this.chasers + CHASER * alien;
    if (s[o + 4] === AWAKE) s[AWAKE_COUNT]--;
    s[o + 4] = GONE;
    this.near.skin = -1;
  }

  private end(kind: number, index: number, time: number): void {
    const { s, recorder } = this;
    s[OUTCOME] = kind;
    s[TOUCHED] = index;
    s[END_TIME] = time;
    const ending = this.ending;
    if (ending !== null) recorder?.event({ time, type: ending.outcome, with: ending.with });
  }

  /** Keeps a limited axis at exactly the limit. */
  private holdLimits(): void {
    const { s, ux, uy, px, py } = this;
    if (s[LIMIT_X] !== 0) ux[1] = s[LIMIT_X] * SPEED_LIMIT - px[1];
    if (s[LIMIT_Y] !== 0) uy[1] = s[LIMIT_Y] * SPEED_LIMIT - py[1];
  }

  // ---- places -------------------------------------------------------------------------------------------------

  /** e[0..3]: u and its velocity after `t`; e[4..7]: the base's displacement and velocity. */
  private settleAt(t: number): void {
    const { s, e } = this;
    if (s[KIND] === COAST) pairAt(this.ux, this.uy, 1, t, e, 0);
    else this.integrator.settle(this.flow, this.ux, this.uy, t, e);
    if (this.recoil) pairAt(this.px, this.py, s[DEGREE], t, e, 4);
    else e[4] = e[5] = e[6] = e[7] = 0;
    // a fixed step may overshoot the speed limit by what its velocity errs
    const vx = e[2] + e[6];
    const vy = e[3] + e[7];
    if (vx > SPEED_LIMIT || vx < -SPEED_LIMIT) e[2] = (vx > 0 ? SPEED_LIMIT : -SPEED_LIMIT) - e[6];
    if (vy > SPEED_LIMIT || vy < -SPEED_LIMIT) e[3] = (vy > 0 ? SPEED_LIMIT : -SPEED_LIMIT) - e[7];
  }

  /** e[8], e[9]: direction of the box's x axis after `t`. */
  private directionAt(t: number): void {
    const { s, e } = this;
    e[8] = s[COS];
    e[9] = s[SIN];
    if (s[TURN] === TURN_NOT) return;
    this.placeAt(t);
    let dx = -e[0];
    let dy = -e[1];
    let dvx = -e[2];
    let dvy = -e[3];
    if (s[TURN] === TURN_TO_TARGET) {
      this.lookAt(t);
      dx = e[8];
      dy = e[9];
      dvx = e[10];
      dvy = e[11];
    }
    let d = Math.sqrt(dx * dx + dy * dy);
    if (d === 0) {
      // in the very centre: the way she will look as soon as she has left it
      dx = dvx;
      dy = dvy;
      d = Math.sqrt(dx * dx + dy * dy);
    }
    e[8] = d > 0 ? dx / d : s[COS];
    e[9] = d > 0 ? dy / d : s[SIN];
  }

  /** e[0..3]: u and its velocity on the piece as it was located; e[4..7]: the base's displacement. */
  private placeAt(t: number): void {
    const { s, e } = this;
    pairAt(this.ux, this.uy, s[DEGREE], t, e, 0);
    if (this.recoil) pairAt(this.px, this.py, s[DEGREE], t, e, 4);
  }

  /** e[0..3]: place (relative to the origin) and velocity of a target after `t`. */
  private rockAt(i: number, t: number): void {
    const { s, e } = this;
    if (!this.recoil) {
      e[0] = this.targetX[i];
      e[1] = this.targetY[i];
      e[2] = 0;
      e[3] = 0;
      return;
    }
    const dragged = this.chaserX.length - 1;
    if (i === s[BASE]) {
      pairAt(this.px, this.py, s[DEGREE], t, e, 0);
      e[0] += s[BASE_X];
      e[1] += s[BASE_Y];
    } else if (i === s[TARGET] && s[this.chasers + CHASER * dragged + 4] === AWAKE) {
      pairAt(this.chaserX[dragged], this.chaserY[dragged], this.integrator.degree, t, e, 0);
    } else {
      const o = this.rocks + ROCK * i;
      e[0] = s[o] + s[o + 2] * t;
      e[1] = s[o + 1] + s[o + 3] * t;
      e[2] = s[o + 2];
      e[3] = s[o + 3];
    }
  }

  /** Squared distance of a target at the start of the piece, exact in the frame's own digits. */
  private distanceSquared(i: number): number {
    const { s } = this;
    const rx = this.recoil ? s[this.rocks + ROCK * i] : this.targetX[i];
    const ry = this.recoil ? s[this.rocks + ROCK * i + 1] : this.targetY[i];
    const dx = rx - s[BASE_X] - this.ux[0];
    const dy = ry - s[BASE_Y] - this.uy[0];
    return dx * dx + dy * dy;
  }

  /** The nearest target; the first on a tie; -1 where there is none. */
  private nearest(): number {
    const { s, scene, ux, uy } = this;
    const { spatial, count } = scene.targets;
    let best = Number.POSITIVE_INFINITY;
    let nearest = -1;
    if (spatial !== null && !this.recoil) {
      // the index knows one of the nearest; which of them comes first is decided in our own digits
      const x = this.originX + s[BASE_X] + ux[0];
      const y = this.originY + s[BASE_Y] + uy[0];
      const reach = Math.sqrt(this.distanceSquared(spatial.nearestCentre(x, y))) * (1 + 1e-9) + 1e-6;
      for (const i of spatial.around(x, y, reach)) {
        const d = this.distanceSquared(i);
        if (d > best || (d === best && i > nearest)) continue;
        best = d;
        nearest = i;
      }
      return nearest;
    }
    for (let i = 0; i < count; i++) {
      const d = this.distanceSquared(i);
      if (d < best) {
        best = d;
        nearest = i;
      }
    }
    return nearest;
  }

  /** Marks the repulsors that contain her at the start. */
  private enterFields(): void {
    const { s, scene } = this;
    const { repulsors } = scene;
    for (let i = 0; i < repulsors.count; i++) {
      const dx = repulsors.x[i] - this.originX;
      const dy = repulsors.y[i] - this.originY;
      s[this.inside + i] = dx * dx + dy * dy < repulsors.r[i] * repulsors.r[i] ? 1 : 0;
    }
    s[FIELD] = this.actingField();
  }

  /** The first repulsor that contains her; -1 where there is none. */
  private actingField(): number {
    for (let i = 0; i < this.scene.repulsors.count; i++) if (this.s[this.inside + i] === 1) return i;
    return -1;
  }

  /**
   * Where the gun pulls into a field that pushes out she slides along its rim: in and out without end. Rims crossed again
   * and again in no time are left unwatched for a moment, which keeps her on the rim to about 1e-4 px.
   */
  private watchForSliding(field: number, time: number): void {
    const { s } = this;
    const again = s[RIM] === field && time - s[RIM_TIME] < SLIDING;
    s[RIM_COUNT] = again ? s[RIM_COUNT] + 1 : 0;
    s[RIM] = field;
    s[RIM_TIME] = time;
    s[RIM_HOLD] = s[RIM_COUNT] >= 16 ? time + SLIDING : 0;
  }

  // ---- pieces -------------------------------------------------------------------------------------------------

  /** Moves the origin of the frame to a point, or to a target with its velocity. */
  private rebase(base: number, x: number, y: number, vx: number, vy: number): void {
    const { s, ux, uy, px, py } = this;
    if (s[BASE] === base && s[BASE_X] === x && s[BASE_Y] === y) return;
    ux[0] += s[BASE_X] - x;
    uy[0] += s[BASE_Y] - y;
    ux[1] += px[1] - vx;
    uy[1] += py[1] - vy;
    s[BASE] = base;
    s[BASE_X] = x;
    s[BASE_Y] = y;
    px[1] = vx;
    py[1] = vy;
  }

  /** Chooses frame and flow at the start of a piece, expands it, and locates the first event. */
  private begin(): void {
    const { s, scene, ux, uy } = this;
    const held = s[HELD] === 1;
    const target = s[TARGET];
    const field = s[FIELD];
    if (field >= 0) {
      this.rebase(-1, scene.repulsors.x[field] - this.originX, scene.repulsors.y[field] - this.originY, 0, 0);
    } else if (held && this.recoil) {
      const o = this.rocks + ROCK * target;
      this.rebase(target, s[o], s[o + 1], s[o + 2], s[o + 3]);
    } else if (held) {
      this.rebase(target, this.targetX[target], this.targetY[target], 0, 0);
    }

    s[KIND] = COAST;
    s[TURN] = TURN_NOT;
    const x = ux[0];
    const y = uy[0];
    const vx = ux[1];
    const vy = uy[1];
    const d = Math.sqrt(x * x + y * y);
    const v = Math.sqrt(vx * vx + vy * vy);
    const free = s[LIMIT_X] === 0 && s[LIMIT_Y] === 0;
    const onLine = Math.abs(x * vy - y * vx) <= RADIAL * v;
    // how far from the centre she could get under the pull with the energy she has
    const swing = held && field < 0 ? d + (v * v) / (2 * GUN_PULL) : Number.POSITIVE_INFINITY;
    if (swing < (onLine && !this.recoil ? RADIAL : SMALLEST_ORBIT)) {
      for (let k = 0; k < 2; k++) ux[k] = uy[k] = 0;
    } else if ((field >= 0 || held) && (d > 0 || v > 0) && (free || d > SMALLEST_ORBIT)) {
      if (free && onLine) {
        s[KIND] = LINEAR;
        // close to the centre the velocity knows the line better than the place does
        const byPlace = d > 1e-6 || v === 0;
        s[LINE_X] = byPlace ? x / d : vx / v;
        s[LINE_Y] = byPlace ? y / d : vy / v;
        s[SIDE] = x * s[LINE_X] + y * s[LINE_Y] < 0 ? -1 : 1;
      } else {
        s[KIND] = CENTRAL;
      }
      if (held && field >= 0) {
        s[TURN] = TURN_TO_TARGET;
      } else if (held && s[KIND] === LINEAR) {
        s[COS] = -s[SIDE] * s[LINE_X];
        s[SIN] = -s[SIDE] * s[LINE_Y];
      } else if (held) {
        s[TURN] = TURN_TO_BASE;
      }
    } else if (held && field >= 0) {
      s[TURN] = TURN_TO_TARGET;
    }
    this.proceed();
  }

  /** The next piece of the same flow. */
  private proceed(): void {
    this.setFlow();
    this.expand();
    this.locate();
  }

  /**
   * She swings to and fro on a line through the centre, faster than the ticks: after two crossings everything is as it
   * was but the time, so whole periods are skipped, up to the next tick.
   */
  private skipPeriods(): void {
    const { s } = this;
    const period = s[CROSSED] > 0 ? s[START] - s[CROSSED_BEFORE] : 0;
    if (s[CROSSED_BEFORE] > 0 && period > 0 && !this.recoil && s[AWAKE_COUNT] === 0) {
      const tick = (Math.floor(s[START] * TICK_RATE + 1e-9) + 1) / TICK_RATE;
      const skipped = Math.floor((tick - s[START]) / period) - 1;
      if (skipped > 0) {
        s[START] += skipped * period;
        this.modeSeconds[this.mode] += skipped * period;
        s[CROSSED] += skipped * period;
      }
    }
    s[CROSSED_BEFORE] = s[CROSSED];
    s[CROSSED] = s[START];
  }

  /**
   * Makes the fixed steps during which nothing can happen, up to `until`, without looking for events: those that she
   * needs at least to cover the distance to the nearest guard. Gives the bits that piece after piece would.
   */
  private skipQuietSteps(until: number): void {
    const { s, ux, uy, flow, integrator, work } = this;
    const { rate } = this.scene.accuracy;
    if (integrator.glide === null || rate === null || this.recoil || s[KIND] === COAST) return;
    const v = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
    if (v > SPEED_LIMIT / 2) return;
    const end = Math.min(until, s[START] + this.quietTime());
    const from = s[START];
    this.steps[0] = 0;
    const start = integrator.glide(flow, ux, uy, from, end, rate, this.steps);
    const steps = this.steps[0];
    if (steps === 0) return;
    s[START] = start;
    s[DEGREE] = 1;
    this.directionAt(0);
    s[COS] = this.e[8];
    s[SIN] = this.e[9];
    this.modeSeconds[this.mode] += start - from;
    work.pieces += steps;
    work.forceEvaluations += steps * integrator.evaluations;
  }

  /**
   * For how long no guard can fire whatever the flow does, s: first strides of the march, with bounds that hold for any
   * piece. 0 while an alien is awake.
   */
  private quietTime(): number {
    const { s, scene, near, ux, uy } = this;
    if (s[AWAKE_COUNT] > 0) return 0;
    const { novae, targets, minerals, repulsors, aliens, level } = scene;
    const x = s[BASE_X] + ux[0];
    const y = s[BASE_Y] + uy[0];
    const vx = ux[1];
    const vy = uy[1];
    const v = Math.sqrt(vx * vx + vy * vy);
    const longest = 4;
    const reach = (v + STRONGEST * longest) * longest;
    // the list must hold for the whole stretch; a shorter one is better than making it anew too often
    if (!near.covers(x, y, Math.min(reach, 16), s[TARGET])) this.refresh(x, y, 64);
    const gone = Math.sqrt((x - near.x) * (x - near.x) + (y - near.y) * (y - near.y));
    let time = Math.min(longest, safeStep(Math.min(near.skin - gone, 1e6), -v, STRONGEST));
    const outOf = (cx: number, cy: number, r: number) => {
      const dx = x - cx;
      const dy = y - cy;
      const d = Math.sqrt(dx * dx + dy * dy);
      // the distance from a point is convex
      time = d > r ? Math.min(time, safeStep(d - r, (dx * vx + dy * vy) / d, STRONGEST)) : 0;
    };
    for (let n = 0; n < near.count && time > 0; n++) {
      if (near.slack[n] > gone + (v + STRONGEST * time) * time) continue;
      const i = near.index[n];
      const margin = HALF_DIAGONAL + 1e-6;
      switch (near.kind[n]) {
        case NOVA:
          outOf(novae.x[i] - this.originX, novae.y[i] - this.originY, novae.r[i] + margin);
          break;
        case HOT:
          outOf(this.targetX[i], this.targetY[i], targets.r[i] + margin);
          break;
        case HOLE:
          outOf(level.blackHole.x - this.originX, level.blackHole.y - this.originY, level.blackHole.radius + margin);
          break;
        case MINERAL:
          if (s[this.minerals + i] === 0)
            outOf(minerals.x[i] - this.originX, minerals.y[i] - this.originY, minerals.r[i] + margin);
          break;
        case ENTER: {
          const dx = x + this.originX - repulsors.x[i];
          const dy = y + this.originY - repulsors.y[i];
          const d = Math.sqrt(dx * dx + dy * dy);
          const slope = d > repulsors.r[i] ? (dx * vx + dy * vy) / d : -v;
          time = Math.min(time, safeStep(Math.max(0, Math.abs(d - repulsors.r[i]) - 1e-6), slope, STRONGEST));
          break;
        }
        case WAKE:
        case ALIEN_TOUCH: {
          const o = this.chasers + CHASER * i;
          outOf(s[o], s[o + 1], near.kind[n] === WAKE ? ALIEN_SIGHT + 1e-6 : aliens.r[i] + margin);
          break;
        }
        default: {
          const g = this.switchGuard(i, 0) - 1e-6;
          const mx = this.targetX[i] - this.targetX[s[TARGET]];
          const my = this.targetY[i] - this.targetY[s[TARGET]];
          const m = Math.sqrt(mx * mx + my * my);
          time = g > 0 ? Math.min(time, safeStep(g, this.e[9], 2 * m * STRONGEST)) : 0;
        }
      }
    }
    const left = level.range - Math.sqrt(this.distanceSquared(s[COVER])) - 1e-6;
    time = left > 0 ? Math.min(time, safeStep(left, -v, STRONGEST)) : 0;
    if (s[KIND] === LINEAR) time = Math.min(time, safeStep(Math.sqrt(ux[0] * ux[0] + uy[0] * uy[0]), -v, STRONGEST));
    return time;
  }

  /** The acceleration of the target's recoil, px/s2; 0 where it has none. */
  private get kappa(): number {
    const { s } = this;
    if (!this.recoil || s[HELD] === 0) return 0;
    // at rest in its very centre there is no direction to recoil in
    if (s[KIND] === COAST && s[FIELD] < 0) return 0;
    return 1 / (2 * this.scene.targets.r[s[TARGET]]);
  }

  /** Sets the flow from the state: after a restore it must be what it was. */
  private setFlow(): void {
    const { s, flow, scene, ux, uy } = this;
    flow.kind = s[KIND];
    flow.freeX = s[LIMIT_X] === 0;
    flow.freeY = s[LIMIT_Y] === 0;
    const inField = s[FIELD] >= 0;
    const kappa = inField ? 0 : this.kappa;
    flow.alpha = inField ? REPULSOR_PUSH : -(GUN_PULL + kappa);
    flow.beta = inField ? 0 : GUN_PULL / scene.level.range;
    if (flow.kind !== LINEAR) return;
    flow.range = inField ? 0 : scene.level.range;
    flow.extra = inField ? REPULSOR_PUSH : -kappa;
    flow.outX = s[SIDE] * s[LINE_X];
    flow.outY = s[SIDE] * s[LINE_Y];
    flow.moveTo(ux[0], uy[0]);
  }

  private expand(): void {
    const { s, flow, integrator, ux, uy, px, py, work } = this;
    const aliens = this.scene.aliens.count;
    const held = s[HELD] === 1;
    const kind = s[KIND];
    let awake = 0;
    for (let i = 0; i < aliens; i++) if (s[this.chasers + CHASER * i + 4] === AWAKE) awake++;
    const dragged = this.recoil && held && s[FIELD] >= 0;
    if (dragged) {
      const o = this.chasers + CHASER * aliens;
      const rock = this.rocks + ROCK * s[TARGET];
      for (let k = 0; k < ROCK; k++) s[o + k] = s[rock + k];
      s[o + 4] = AWAKE;
      awake++;
    }
    work.pieces++;

    // fixed steps end on a grid of their own rate, which the ticks are a part of
    let h = Number.POSITIVE_INFINITY;
    const { rate } = this.scene.accuracy;
    if ((kind !== COAST || awake > 0) && rate !== null) {
      h = untilGrid(s[START], rate);
    }
    s[DEGREE] = 1;
    s[ACCELERATION] = 0;
    if (kind === COAST && this.crowded) {
      // where an index finds the neighbours, a long path would find them all
      const speed = Math.sqrt(ux[1] * ux[1] + uy[1] * uy[1]);
      if (speed > 0) h = Math.min(h, CROWDED_REACH / speed);
    }
    if (kind === COAST && (s[LIMIT_X] !== 0 || s[LIMIT_Y] !== 0) && (s[FIELD] >= 0 || held)) {
      // at the limit through the very centre: out of it straight on
      h = Math.min(h, SMALLEST_ORBIT / SPEED_LIMIT);
    }
    if (kind !== COAST) {
      s[DEGREE] = integrator.degree;
      const kappa = this.recoil && s[FIELD] < 0 ? this.kappa : 0;
      const drags = this.recoil && kind === CENTRAL;
      h = integrator.expand(flow, ux, uy, h, drags ? px : null, drags ? py : null, kappa);
      if (this.recoil && kind === LINEAR) this.recoilOnLine(kappa);
      s[ACCELERATION] = integrator.acceleration(flow, ux, uy, h);
      work.forceEvaluations += integrator.evaluations;
    }
    if (awake > 0) h = this.expandChasers(h);
    s[LENGTH_H] = h;
  }

  /** On a line through the centre the target's recoil is constant. */
  private recoilOnLine(kappa: number): void {
    const { s, px, py } = this;
    const a = (kappa * s[SIDE]) / 2;
    px[2] = a * s[LINE_X];
    py[2] = a * s[LINE_Y];
    for (let k = 3; k <= s[DEGREE]; k++) px[k] = py[k] = 0;
  }

  /** Expands aliens that are awake, and the rock she drags from within a field. */
  private expandChasers(longest: number): number {
    const { s, scene, ux, uy, px, py, wx, wy, integrator, work } = this;
    const aliens = scene.aliens.count;
    for (let k = 0; k < wx.length; k++) {
      const known = k <= s[DEGREE];
      wx[k] = known ? ux[k] + (this.recoil ? px[k] : 0) : 0;
      wy[k] = known ? uy[k] + (this.recoil ? py[k] : 0) : 0;
    }
    wx[0] += s[BASE_X];
    wy[0] += s[BASE_Y];
    let h = longest;
    for (let i = 0; i < this.chaserX.length; i++) {
      const o = this.chasers + CHASER * i;
      if (s[o + 4] !== AWAKE) continue;
      const qx = this.chaserX[i];
      const qy = this.chaserY[i];
      qx[0] = s[o];
      qy[0] = s[o + 1];
      qx[1] = s[o + 2];
      qy[1] = s[o + 3];
      const pull = i < aliens ? ALIEN_PULL : this.kappa;
      h = Math.min(h, integrator.chase(qx, qy, wx, wy, pull, h));
      work.forceEvaluations += integrator.evaluations;
    }
    return h;
  }

  // ---- events -------------------------------------------------------------------------------------------------

  /** Locates the first event in (FROM, LENGTH_H] of the piece; the natural end where nothing happens before. */
  private locate(): void {
    const { s, e, near } = this;
    s[NEXT] = s[LENGTH_H];
    s[EVENT] = PIECE_END;
    const from = s[FROM];
    // the path stays within `reach` of its start
    this.placeAt(0);
    const x = s[BASE_X] + e[0];
    const y = s[BASE_Y] + e[1];
    const speedX = e[2] + (this.recoil ? e[6] : 0);
    const speedY = e[3] + (this.recoil ? e[7] : 0);
    const h = s[LENGTH_H];
    const speed = Math.sqrt(speedX * speedX + speedY * speedY);
    const travel = s[ACCELERATION] > 0 ? (speed + (s[ACCELERATION] + this.kappa) * h) * h : speed > 0 ? speed * h : 0;
    const rockTravel = this.recoil ? this.rockTravel(h) : 0;
    const reach = travel + rockTravel;

    if (this.recoil || !near.covers(x, y, reach, s[TARGET])) this.refresh(x, y, reach);
    const gone = Math.sqrt((x - near.x) * (x - near.x) + (y - near.y) * (y - near.y)) + reach;
    for (let i = 0; i < near.count; i++) {
      if (near.slack[i] > gone) continue;
      this.consider(near.kind[i], near.index[i], from);
    }
    if (s[AWAKE_COUNT] > 0 || (s[START] === 0 && this.scene.aliens.count > 1)) this.considerAwake(x, y, travel, from);
    this.considerCover(from);
    if (s[KIND] === LINEAR) this.offer(this.centreTime(from), CENTRE, 0, 0);
    if (speed + s[ACCELERATION] * h >= SPEED_LIMIT || s[LIMIT_X] !== 0 || s[LIMIT_Y] !== 0) this.considerLimits(from);
  }

  private get horizon(): number {
    return this.s[NEXT] + SAME_INSTANT * (1 + this.s[START]);
  }

  /** Takes an event if it is earlier than the best so far, or of the same instant and goes first. */
  private offer(time: number, kind: number, a: number, b: number): void {
    if (time < 0) return;
    const { s } = this;
    const same = SAME_INSTANT * (1 + s[START]);
    if (time > s[LENGTH_H]) return;
    const earlier = time < s[NEXT] - same;
    if (!earlier && !(time <= s[NEXT] + same && kind < s[EVENT])) return;
    s[NEXT] = Math.min(s[NEXT], time);
    s[EVENT] = kind;
    s[EVENT_A] = a;
    s[EVENT_B] = b;
  }

  /** Farthest a drifting or recoiling rock moves in `h`, px. */
  private rockTravel(h: number): number {
    const { s, scene } = this;
    let fastest = 0;
    for (let i = 0; i < scene.targets.count; i++) {
      const o = this.rocks + ROCK * i;
      fastest = Math.max(fastest, s[o + 2] * s[o + 2] + s[o + 3] * s[o + 3]);
    }
    const v = Math.sqrt(fastest);
    const a = this.kappa;
    return v > 0 || a > 0 ? (v + a * h) * h : 0;
  }

  /** Makes the neighbour list anew around (x, y) for a path of length `reach`. */
  private refresh(x: number, y: number, reach: number): void {
    const { s, scene, near, recoil } = this;
    const { targets, novae, minerals, repulsors, aliens, level } = scene;
    // places of rocks change under recoil: then the list serves one piece
    const skin = recoil ? reach : Math.max(2 * reach, 64);
    near.restart(x, y, skin, s[TARGET]);
    const levelX = x + this.originX;
    const levelY = y + this.originY;
    const margin = HALF_DIAGONAL + 1e-6;
    const distance = (cx: number, cy: number) => Math.sqrt((cx - x) * (cx - x) + (cy - y) * (cy - y));
    const touching = (kind: number, circles: IndexedCircles, i: number) =>
      near.add(kind, i, distance(circles.x[i] - this.originX, circles.y[i] - this.originY) - circles.r[i] - margin);
    const each = (circles: IndexedCircles, within: number, visit: (i: number) => void) => {
      const { spatial } = circles;
      if (spatial !== null) for (const i of spatial.around(levelX, levelY, within)) visit(i);
      else for (let i = 0; i < circles.count; i++) visit(i);
    };
    each(novae, skin + margin, (i) => touching(NOVA, novae, i));
    each(minerals, skin + margin, (i) => touching(MINERAL, minerals, i));
    each(repulsors, skin + margin, (i) => {
      const d = distance(repulsors.x[i] - this.originX, repulsors.y[i] - this.originY);
      near.add(ENTER, i, Math.abs(d - repulsors.r[i]) - 1e-6);
    });
    const hole = level.blackHole;
    near.add(HOLE, 0, distance(hole.x - this.originX, hole.y - this.originY) - hole.radius - margin);
    for (let i = 0; i < aliens.count; i++) {
      const o = this.chasers + CHASER * i;
      if (s[o + 4] !== ASLEEP) continue;
      const d = distance(s[o], s[o + 1]);
      near.add(WAKE, i, d - ALIEN_SIGHT - 1e-6);
      near.add(ALIEN_TOUCH, i, d - aliens.r[i] - margin);
    }
    const target = s[TARGET];
    const own = target < 0 ? 0 : this.rockDistance(target, x, y);
    const rock = (i: number) => {
      if (i < scene.coldCount && (target < 0 || i === target)) return;
      const d = this.rockDistance(i, x, y);
      if (i >= scene.coldCount) near.add(HOT, i, d - targets.r[i] - margin);
      if (target >= 0 && i !== target) near.add(SWITCH, i, (d - own) / 2 - 1e-6);
    };
    if (recoil) for (let i = 0; i < targets.count; i++) rock(i);
    else each(targets, Math.max(skin + margin, 2 * skin + own + 1e-3), rock);
  }

  /** Distance of a target from (x, y) at the start of the piece, px. */
  private rockDistance(i: number, x: number, y: number): number {
    const { s } = this;
    const dx = (this.recoil ? s[this.rocks + ROCK * i] : this.targetX[i]) - x;
    const dy = (this.recoil ? s[this.rocks + ROCK * i + 1] : this.targetY[i]) - y;
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** Tests one entry of the neighbour list. */
  private consider(kind: number, i: number, from: number): void {
    const { s, scene } = this;
    switch (kind) {
      case NOVA:
        this.placeCircle(scene.novae.x[i] - this.originX, scene.novae.y[i] - this.originY);
        this.offer(this.contactTime(scene.novae.r[i], 0, from), NOVA, scene.novae.index[i], 0);
        return;
      case HOT:
        this.placeRock(i);
        this.offer(this.contactTime(scene.targets.r[i], this.kappa, from), HOT, i, 0);
        return;
      case HOLE: {
        const { x, y, radius } = scene.level.blackHole;
        this.placeCircle(x - this.originX, y - this.originY);
        this.offer(this.contactTime(radius, 0, from), HOLE, 0, 0);
        return;
      }
      case MINERAL:
        if (s[this.minerals + i] !== 0) return;
        this.placeCircle(scene.minerals.x[i] - this.originX, scene.minerals.y[i] - this.originY);
        this.offer(this.contactTime(scene.minerals.r[i], 0, from), MINERAL, i, 0);
        return;
      case ENTER: {
        const inside = s[this.inside + i] === 1;
        const event = inside ? LEAVE : ENTER;
        const start = s[RIM] === i ? Math.max(from, s[RIM_HOLD] - s[START]) : from;
        if (start > s[LENGTH_H]) return;
        this.placeCircle(scene.repulsors.x[i] - this.originX, scene.repulsors.y[i] - this.originY);
        const atZero = start === from && this.justFired(event, i);
        this.offer(this.rimTime(scene.repulsors.r[i], !inside, 0, start, atZero), event, i, 0);
        return;
      }
      case WAKE:
        this.considerRim(i, WAKE, from);
        return;
      case ALIEN_TOUCH:
        this.considerAlienTouch(i, from);
        return;
      default:
        this.offer(this.switchTime(i, from), SWITCH, i, 0);
    }
  }

  private justFired(event: number, a: number): boolean {
    const { s } = this;
    return s[FROM] === 0 && s[LAST_EVENT] === event && s[LAST_A] === a;
  }

  /** Aliens that are awake, and pairs with one of them; those asleep are in the neighbour list. */
  private considerAwake(x: number, y: number, travel: number, from: number): void {
    const { s, scene } = this;
    const { aliens } = scene;
    const h = s[LENGTH_H];
    for (let i = 0; i < aliens.count; i++) {
      const o = this.chasers + CHASER * i;
      if (s[o + 4] === GONE) continue;
      for (let j = i + 1; j < aliens.count; j++) this.considerPair(i, j, from);
      if (s[o + 4] === ASLEEP) continue;
      const d = Math.sqrt((s[o] - x) * (s[o] - x) + (s[o + 1] - y) * (s[o + 1] - y));
      const moves = travel + this.alienTravel(i, h);
      if (d + moves > ALIEN_SIGHT - 1e-6) this.considerRim(i, SLEEP, from);
      if (d - moves < aliens.r[i] + HALF_DIAGONAL + 1e-6) this.considerAlienTouch(i, from);
    }
  }

  private considerRim(i: number, event: number, from: number): void {
    this.placeAlien(i);
    const pull = event === SLEEP ? ALIEN_PULL : 0;
    this.offer(this.rimTime(ALIEN_SIGHT, event === WAKE, pull, from, this.justFired(event, i)), event, i, 0);
  }

  private considerAlienTouch(i: number, from: number): void {
    this.placeAlien(i);
    const pull = this.circleMotion === SERIES ? ALIEN_PULL : 0;
    this.offer(this.contactTime(this.scene.aliens.r[i], pull, from), ALIEN_TOUCH, i, 0);
  }

  /** Farthest an alien moves in `h`, px. */
  private alienTravel(i: number, h: number): number {
    const { s } = this;
    const o = this.chasers + CHASER * i;
    if (s[o + 4] !== AWAKE) return 0;
    return (Math.sqrt(s[o + 2] * s[o + 2] + s[o + 3] * s[o + 3]) + ALIEN_PULL * h) * h;
  }

  private considerPair(i: number, j: number, from: number): void {
    const { s, scene, work } = this;
    const a = this.chasers + CHASER * i;
    const b = this.chasers + CHASER * j;
    if (s[b + 4] === GONE) return;
    const reach = scene.aliens.r[i] + scene.aliens.r[j];
    const d = Math.sqrt((s[a] - s[b]) * (s[a] - s[b]) + (s[a + 1] - s[b + 1]) * (s[a + 1] - s[b + 1]));
    const h = s[LENGTH_H];
    if (d - this.alienTravel(i, h) - this.alienTravel(j, h) > reach + 1e-6) return;
    work.guards++;
    const e = this.e;
    const horizon = Math.min(this.horizon, h);
    let t = from;
    let small = Math.min(SMALLEST_STRIDE, h * 1e-6);
    for (let n = 0; ; n++) {
      this.alienPlaceAt(i, t, 0);
      this.alienPlaceAt(j, t, 4);
      const dx = e[0] - e[4];
      const dy = e[1] - e[5];
      const vx = e[2] - e[6];
      const vy = e[3] - e[7];
      const g = dx * dx + dy * dy - reach * reach;
      if (g < 0) {
        this.offer(t, PAIR, i, j);
        return;
      }
      // (d^2)'' = 2 v^2 + 2 d a >= -2 |d| |a| while d stays below `far`
      const slope = 2 * (dx * vx + dy * vy);
      const far = Math.sqrt(dx * dx + dy * dy) + (Math.sqrt(vx * vx + vy * vy) + 2 * ALIEN_PULL * h) * h;
      const step = safeStep(g, slope, 4 * far * ALIEN_PULL);
      if (!(t + step < horizon)) return;
      if (n > 400) small *= 2;
      t = Math.min(horizon, t + Math.max(step, small));
    }
  }

  private alienPlaceAt(i: number, t: number, at: number): void {
    const { s, e } = this;
    const o = this.chasers + CHASER * i;
    if (s[o + 4] === AWAKE) {
      pairAt(this.chaserX[i], this.chaserY[i], this.integrator.degree, t, e, at);
      return;
    }
    e[at] = s[o];
    e[at + 1] = s[o + 1];
    e[at + 2] = 0;
    e[at + 3] = 0;
  }

  /** The asteroid that keeps her in range: when she leaves its range another may take over, or she is lost. */
  private considerCover(from: number): void {
    const { s, scene } = this;
    const cover = s[COVER];
    if (cover < 0) {
      this.offer(from, LEAVE_COVER, -1, 0);
      return;
    }
    this.placeRock(cover);
    this.offer(this.rimTime(scene.level.range, false, this.kappa, from, false), LEAVE_COVER, cover, 0);
  }

  // ---- the circle a guard is about ------------------------------------------------------------------------------

  private placeCircle(x: number, y: number): void {
    this.circleX = x - this.s[BASE_X];
    this.circleY = y - this.s[BASE_Y];
    this.circleMotion = STILL;
  }

  private placeRock(i: number): void {
    const { s } = this;
    if (!this.recoil) {
      this.placeCircle(this.targetX[i], this.targetY[i]);
      return;
    }
    const dragged = this.chaserX.length - 1;
    if (i === s[BASE]) {
      this.circleMotion = IS_BASE;
      return;
    }
    if (i === s[TARGET] && s[this.chasers + CHASER * dragged + 4] === AWAKE) {
      this.circleMotion = SERIES;
      this.circleSeries = dragged;
      return;
    }
    const o = this.rocks + ROCK * i;
    this.placeCircle(s[o], s[o + 1]);
    this.circleMotion = DRIFTS;
    this.circleVX = s[o + 2];
    this.circleVY = s[o + 3];
  }

  private placeAlien(i: number): void {
    const o = this.chasers + CHASER * i;
    this.placeCircle(this.s[o], this.s[o + 1]);
    if (this.s[o + 4] !== AWAKE) return;
    this.circleMotion = SERIES;
    this.circleSeries = i;
  }

  /** e[0..3]: u and its velocity; e[4..7]: the circle's centre minus hers, and its velocity, after `t`. */
  private relativeAt(t: number): void {
    const { s, e } = this;
    const degree = s[DEGREE];
    pairAt(this.ux, this.uy, degree, t, e, 0);
    if (this.circleMotion === IS_BASE) {
      e[4] = -e[0];
      e[5] = -e[1];
      e[6] = -e[2];
      e[7] = -e[3];
      return;
    }
    if (this.circleMotion === SERIES) {
      pairAt(this.chaserX[this.circleSeries], this.chaserY[this.circleSeries], this.integrator.degree, t, e, 4);
      e[4] -= s[BASE_X];
      e[5] -= s[BASE_Y];
    } else if (this.circleMotion === DRIFTS) {
      e[4] = this.circleX + this.circleVX * t;
      e[5] = this.circleY + this.circleVY * t;
      e[6] = this.circleVX;
      e[7] = this.circleVY;
    } else {
      e[4] = this.circleX;
      e[5] = this.circleY;
      e[6] = 0;
      e[7] = 0;
    }
    e[4] -= e[0];
    e[5] -= e[1];
    e[6] -= e[2];
    e[7] -= e[3];
    if (!this.recoil) return;
    pairAt(this.px, this.py, degree, t, e, 8);
    e[4] -= e[8];
    e[5] -= e[9];
    e[6] -= e[10];
    e[7] -= e[11];
  }

  // ---- guards ---------------------------------------------------------------------------------------------------

  /**
   * First time in [from, horizon] at which her box overlaps the placed circle, or -1. The gap of a convex box is a
   * convex function of the circle's place in the box's frame, so its tangent bounds it from below; what the curvature
   * of the path and the turning of the box can take away is bounded by `k`: the march can't step over a contact.
   * @param r radius, px
   * @param pull bound on the circle's own acceleration, px/s2
   */
  private sweptTime(r: number, pull: number, from: number): number {
    const { s, e, work } = this;
    work.guards++;
    const horizon = Math.min(this.horizon, s[LENGTH_H]);
    const turn = s[TURN];
    const acceleration = s[ACCELERATION] + this.kappa;
    const relative = acceleration + pull;
    const central = turn === TURN_TO_BASE;
    let small = Math.min(SMALLEST_STRIDE, s[LENGTH_H] * 1e-6);
    let t = from;
    let before = t;
    for (let n = 0; ; n++) {
      this.relativeAt(t);
      const dx = e[4];
      const dy = e[5];
      const dvx = e[6];
      const dvy = e[7];
      let cos = s[COS];
      let sin = s[SIN];
      let omega = 0;
      let k = relative;
      let cap = Number.POSITIVE_INFINITY;
      if (turn !== TURN_NOT) {
        // the direction the box looks in, how fast it turns, and bounds on both ahead
        let bx = -e[0];
        let by = -e[1];
        let bvx = -e[2];
        let bvy = -e[3];
        if (!central) {
          this.lookAt(t);
          bx = e[8];
          by = e[9];
          bvx = e[10];
          bvy = e[11];
        }
        const d2 = bx * bx + by * by;
        const d = Math.sqrt(d2);
        if (d > 0) {
          cos = bx / d;
          sin = by / d;
          const momentum = bx * bvy - by * bvx;
          omega = momentum / d2;
          const v = Math.sqrt(bvx * bvx + bvy * bvy);
          const root = Math.sqrt(relative * d);
          // within the cap the distance stays above 0.72 d and the speed below `fast`
          cap = (0.25 * d) / (v + root);
          const fast = v + 0.25 * root;
          const turning = central ? (2.5 * Math.abs(momentum)) / d2 : fast / (0.72 * d);
          const bending = central ? (7 * Math.abs(momentum) * fast) / (d2 * d) : (1.4 * relative) / d + (4 * fast * fast) / d2;
          const speed = Math.sqrt(dvx * dvx + dvy * dvy) + relative * cap;
          const lever = Math.sqrt(dx * dx + dy * dy) + speed * cap;
          k += 2 * turning * speed + lever * (bending + turning * turning);
        } else if (bvx !== 0 || bvy !== 0) {
          // in the very centre: the way she will look as soon as she has left it
          const v = Math.sqrt(bvx * bvx + bvy * bvy);
          cos = bvx / v;
          sin = bvy / v;
        }
      }
      const lx = dx * cos + dy * sin;
      const ly = dy * cos - dx * sin;
      const gx = Math.abs(lx) - HALF_WIDTH;
      const gy = Math.abs(ly) - HALF_HEIGHT;
      const nx = gx > 0 ? gx : 0;
      const ny = gy > 0 ? gy : 0;
      const norm = nx > 0 ? (ny > 0 ? Math.sqrt(nx * nx + ny * ny) : nx) : ny;
      const g = norm - r;
      if (g < 0) return t === from ? t : this.rootBetween(before, t, r);
      const lvx = dvx * cos + dvy * sin + omega * ly;
      const lvy = dvy * cos - dvx * sin - omega * lx;
      const slope = ((lx < 0 ? -nx : nx) * lvx + (ly < 0 ? -ny : ny) * lvy) / norm;
      const step = Math.min(cap, safeStep(g, slope, k));
      if (!(t + step < horizon)) return -1;
      if (n > 400) small *= 2;
      before = t;
      t = Math.min(horizon, t + Math.max(step, small));
    }
  }

  /** e[8..11]: the target's place minus hers, and its velocity, after `t`; e[0..7] are kept. */
  private lookAt(t: number): void {
    const { s, e } = this;
    const ux = e[0];
    const uy = e[1];
    const vx = e[2];
    const vy = e[3];
    this.rockAt(s[TARGET], t);
    e[8] = e[0] - s[BASE_X] - ux;
    e[9] = e[1] - s[BASE_Y] - uy;
    e[10] = e[2] - vx;
    e[11] = e[3] - vy;
    e[0] = ux;
    e[1] = uy;
    e[2] = vx;
    e[3] = vy;
  }

  /** Gap between her box and the placed circle after `t`, px. */
  private gapAt(t: number, r: number): number {
    const { s, e } = this;
    this.relativeAt(t);
    let cos = s[COS];
    let sin = s[SIN];
    if (s[TURN] !== TURN_NOT) {
      let bx = -e[0];
      let by = -e[1];
      if (s[TURN] === TURN_TO_TARGET) {
        this.lookAt(t);
        bx = e[8];
        by = e[9];
      }
      const d = Math.sqrt(bx * bx + by * by);
      if (d > 0) {
        cos = bx / d;
        sin = by / d;
      }
    }
    return boxCircleGap(e[4], e[5], cos, sin, r);
  }

  /** The moment the gap closes between a time it is open and one it isn't: bisection to the last bit that matters. */
  private rootBetween(open: number, closed: number, r: number): number {
    this.work.roots++;
    let a = open;
    let b = closed;
    for (let n = 0; n < 60; n++) {
      const middle = a + (b - a) / 2;
      if (middle <= a || middle >= b) break;
      if (this.gapAt(middle, r) < 0) b = middle;
      else a = middle;
    }
    return b;
  }

  /** First time at which a contact with the placed circle counts, or -1: when it happens, or is seen at a frame. */
  private contactTime(r: number, pull: number, from: number): number {
    const { s, frameRate } = this;
    let t = this.sweptTime(r, pull, from);
    if (frameRate === 0) return t;
    // a contact seen at a frame lies within an overlap; one that is over before the next frame is missed, as games do
    let frame = Number.NEGATIVE_INFINITY;
    while (t >= 0) {
      frame = Math.max(frame + 1, Math.ceil((s[START] + t) * frameRate - 1e-7));
      t = Math.max(0, frame / frameRate - s[START]);
      if (t > Math.min(this.horizon, s[LENGTH_H])) return -1;
      if (this.gapAt(t, r) < 0) return t;
      t = this.sweptTime(r, pull, t);
    }
    return -1;
  }

  /**
   * First time at which her centre crosses the rim of the placed circle, or -1.
   * @param inward entering it; otherwise leaving
   * @param atZero she stands on the rim, having just crossed it the other way
   */
  private rimTime(r: number, inward: boolean, pull: number, from: number, atZero: boolean): number {
    const { s, e, work } = this;
    const horizon = Math.min(this.horizon, s[LENGTH_H]);
    const a = s[ACCELERATION] + this.kappa + pull;
    const sign = inward ? 1 : -1;
    let small = Math.min(SMALLEST_STRIDE, s[LENGTH_H] * 1e-6);
    let t = from;
    let before = t;
    work.guards++;
    for (let n = 0; ; n++) {
      this.relativeAt(t);
      const d2 = e[4] * e[4] + e[5] * e[5];
      const d = Math.sqrt(d2);
      // (d - r)(d + r): the difference of squares would lose the digits of d - r
      let g = sign * (d - r) * (d + r);
      const slope = sign * 2 * (e[4] * e[6] + e[5] * e[7]);
      if (g < 0) {
        if (n > 0) return this.rimBetween(before, t, r, sign);
        if (!atZero && g < -1e-12 * r * r) return t;
        if (slope < 0 && !atZero) return t;
        g = 0;
      }
      if (t >= horizon) return -1;
      const left = horizon - t;
      const v = Math.sqrt(e[6] * e[6] + e[7] * e[7]);
      // g'' = sign (2 v^2 + 2 d.a); with a force the bound holds for `cap` only
      let cap = left;
      let k = inward ? 0 : 2 * v * v;
      if (a > 0) {
        cap = Math.min(left, v / a + Math.sqrt(d / a) + 1e-3);
        const fast = v + a * cap;
        k = 2 * (d + fast * cap) * a + (inward ? 0 : 2 * fast * fast);
      }
      const step = Math.min(cap, safeStep(g, slope, k));
      if (!(t + step < horizon)) return -1;
      if (n > 400) small *= 2;
      before = t;
      t = Math.min(horizon, t + Math.max(step, small));
    }
  }

  private rimBetween(outside: number, inside: number, r: number, sign: number): number {
    this.work.roots++;
    const { e } = this;
    let a = outside;
    let b = inside;
    for (let n = 0; n < 60; n++) {
      const middle = a + (b - a) / 2;
      if (middle <= a || middle >= b) break;
      this.relativeAt(middle);
      if (sign * (Math.sqrt(e[4] * e[4] + e[5] * e[5]) - r) < 0) b = middle;
      else a = middle;
    }
    return b;
  }

  /** First time at which asteroid `i` is nearer than the target, or -1. */
  private switchTime(i: number, from: number): number {
    const { s, e, work } = this;
    const horizon = Math.min(this.horizon, s[LENGTH_H]);
    const atZero = this.justFired(SWITCH, i);
    let small = Math.min(SMALLEST_STRIDE, s[LENGTH_H] * 1e-6);
    let t = from;
    let before = t;
    work.guards++;
    for (let n = 0; ; n++) {
      let g = this.switchGuard(i, t);
      // shallower than what the way itself may err by it is a tie, and the target stays
      if (g < -e[11]) {
        if (n > 0) return this.switchBetween(i, before, t);
        if (!atZero && (e[9] < 0 || g < -1e-9)) return t;
      }
      if (g < 0) g = 0;
      if (t >= horizon) return -1;
      // e[9]: slope, e[10]: how fast it may fall
      const step = safeStep(g, e[9], e[10]);
      if (!(t + step < horizon)) return -1;
      if (n > 400) small *= 2;
      before = t;
      t = Math.min(horizon, t + Math.max(step, small));
    }
  }

  private switchBetween(i: number, farther: number, nearer: number): number {
    this.work.roots++;
    let a = farther;
    let b = nearer;
    for (let n = 0; n < 60; n++) {
      const middle = a + (b - a) / 2;
      if (middle <= a || middle >= b) break;
      if (this.switchGuard(i, middle) < 0) b = middle;
      else a = middle;
    }
    return b;
  }

  /**
   * Squared distance to asteroid `i` minus that to the target, px2. Where both stand still it is linear in her place.
   * e[9]: its slope; e[10]: a bound on how fast the slope can fall; e[11]: what TIE px across the bisector make of it.
   */
  private switchGuard(i: number, t: number): number {
    const { s, e } = this;
    const target = s[TARGET];
    const a = s[ACCELERATION];
    if (!this.recoil) {
      const ix = this.targetX[i] - s[BASE_X];
      const iy = this.targetY[i] - s[BASE_Y];
      const tx = this.targetX[target] - s[BASE_X];
      const ty = this.targetY[target] - s[BASE_Y];
      pairAt(this.ux, this.uy, s[DEGREE], t, e, 0);
      const mx = ix - tx;
      const my = iy - ty;
      e[9] = -2 * (mx * e[2] + my * e[3]);
      const apart = Math.sqrt(mx * mx + my * my);
      e[10] = 2 * a * apart;
      e[11] = 2 * TIE * apart;
      // (i - u)^2 - (t - u)^2 = (i - t).(i + t - 2 u)
      return mx * (ix + tx - 2 * e[0]) + my * (iy + ty - 2 * e[1]);
    }
    this.placeRock(target);
    this.relativeAt(t);
    const tx = e[4];
    const ty = e[5];
    const tvx = e[6];
    const tvy = e[7];
    this.placeRock(i);
    this.relativeAt(t);
    const slope = 2 * (e[4] * e[6] + e[5] * e[7] - tx * tvx - ty * tvy);
    const left = s[LENGTH_H] - t;
    const pull = a + 2 * this.kappa;
    const fast = Math.sqrt(tvx * tvx + tvy * tvy) + pull * left;
    const far = Math.sqrt(e[4] * e[4] + e[5] * e[5]) + Math.sqrt(tx * tx + ty * ty) + 2 * fast * left;
    const g = (e[4] - tx) * (e[4] + tx) + (e[5] - ty) * (e[5] + ty);
    e[9] = slope;
    e[10] = 2 * fast * fast + 2 * far * pull;
    e[11] = 2 * TIE * Math.sqrt((e[4] - tx) * (e[4] - tx) + (e[5] - ty) * (e[5] - ty));
    return g;
  }

  /** When she comes through the centre on a straight line, or -1. */
  private centreTime(from: number): number {
    const { s, e, work } = this;
    const side = s[SIDE];
    const horizon = Math.min(this.horizon, s[LENGTH_H]);
    let t = from;
    let before = from;
    work.guards++;
    for (let n = 0; ; n++) {
      pairAt(this.ux, this.uy, s[DEGREE], t, e, 0);
      const g = side * (e[0] * s[LINE_X] + e[1] * s[LINE_Y]);
      const slope = side * (e[2] * s[LINE_X] + e[3] * s[LINE_Y]);
      if (n === 0 && g <= 0 && slope >= 0) {
        // on the centre, on the way out
      } else if (g < 0) {
        return n === 0 ? t : this.centreBetween(before, t);
      }
      if (t >= horizon) return -1;
      const step = safeStep(Math.max(g, 0), slope, s[ACCELERATION]);
      if (!(t + step < horizon)) return -1;
      before = t;
      t = Math.min(horizon, t + Math.max(step, s[LENGTH_H] * 1e-9));
    }
  }

  private centreBetween(before: number, behind: number): number {
    this.work.roots++;
    const { s, e } = this;
    let a = before;
    let b = behind;
    for (let n = 0; n < 60; n++) {
      const middle = a + (b - a) / 2;
      if (middle <= a || middle >= b) break;
      pairAt(this.ux, this.uy, s[DEGREE], middle, e, 0);
      if (s[SIDE] * (e[0] * s[LINE_X] + e[1] * s[LINE_Y]) < 0) b = middle;
      else a = middle;
    }
    return b;
  }

  /** The speed limit: each axis is held at it while the force would drive it on. */
  private considerLimits(from: number): void {
    const { s } = this;
    for (let axis = 0; axis < 2; axis++) {
      const held = s[axis === 0 ? LIMIT_X : LIMIT_Y];
      if (held !== 0) {
        const time = this.limitRoot(from, (t) => held * this.forceAt(axis, t));
        this.offer(time, UNLIMIT, axis, 0);
        continue;
      }
      for (let sign = -1; sign <= 1; sign += 2) {
        if (this.justFired(LIMIT, axis) && from === 0 && sign * this.forceAt(axis, 0) <= 0) continue;
        const time = this.limitRoot(from, (t) => SPEED_LIMIT - sign * this.velocityAt(axis, t));
        this.offer(time, LIMIT, axis, sign);
      }
    }
  }

  private velocityAt(axis: number, t: number): number {
    this.placeAt(t);
    return this.e[2 + axis] + (this.recoil ? this.e[6 + axis] : 0);
  }

  /** The acceleration along an axis that the limit does not hold back, px/s2. */
  private forceAt(axis: number, t: number): number {
    const { flow, e } = this;
    if (flow.kind === COAST) return 0;
    this.placeAt(t);
    const { freeX, freeY } = flow;
    flow.freeX = true;
    flow.freeY = true;
    flow.accelerate(e[0], e[1], e, 8);
    flow.freeX = freeX;
    flow.freeY = freeY;
    return e[8 + axis];
  }

  /** First time `guard` falls below 0: it is smooth and the piece short, so a scan in 16 parts brackets the root. */
  private limitRoot(from: number, guard: (t: number) => number): number {
    const { s } = this;
    const h = Math.min(this.horizon, s[LENGTH_H]);
    if (!Number.isFinite(h)) return guard(from) < 0 ? from : -1;
    this.work.guards++;
    if (guard(from) < 0) return from;
    let a = from;
    for (let n = 1; n <= 16; n++) {
      let b = from + ((h - from) * n) / 16;
      if (guard(b) >= 0) {
        a = b;
        continue;
      }
      this.work.roots++;
      for (let m = 0; m < 60; m++) {
        const middle = a + (b - a) / 2;
        if (middle <= a || middle >= b) break;
        if (guard(middle) < 0) b = middle;
        else a = middle;
      }
      return b;
    }
    return -1;
  }
}
