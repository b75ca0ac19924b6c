import type { Accuracy } from '../accuracy.ts';
import type { ChangeLog } from '../change-log.ts';
import { TICK, TICK_RATE } from '../constants.ts';
import type { EffectSet } from '../effects/index.ts';
import {
  ALERTNESS,
  arriveAndTurnAt,
  chaserPlaceAt,
  type Integrator,
  MODES,
  Motion,
  ONSETS,
  type PackedPieces,
  RECORDS,
  type Recorder,
  readRocks,
  rockAt,
  SLOTS,
} from '../motion/index.ts';
import { objectLists, type Scene } from '../scene.ts';
import { type Ending, expectSnapshot, type Mode, type Simulation, type Work } from '../simulation.ts';
import { type WorkBudget, WorkLimitReached } from '../work-budget.ts';
import { begin, layOut, setFlow } from './begin.ts';
import { button, endingOf, fire } from './fire.ts';

const { START, NEXT, ONSET, TICK_NOW, HELD, TARGET, BASE_X, BASE_Y, OUTCOME, END_TIME, MINERALS, AWAKE_COUNT } = SLOTS;
const { CHASER } = RECORDS;
const { AWAKE, GONE } = ALERTNESS;
const { TOUCHES } = ONSETS;

/** What a simulation in continuous time is made of. */
export interface Method {
  /** The effects that scenes may call for. */
  readonly effects: EffectSet;
  /** The integrator of an accuracy. */
  readonly integratorOf: (accuracy: Accuracy) => Integrator;
}

/**
 * More events than this at one instant mean that the run does not advance: all objects of a level may take part in an instant,
 * some of them several times.
 */
const MOST_AT_ONCE = { inAnyLevel: 10_000, byEachObject: 4 };

// working memory: the place of a body
const body = new Float64Array(4);

/**
 * The game in continuous time, as a hybrid automaton. Between events every body moves on a polynomial piece. Guards (contacts,
 * target changes, rims, ...) are located on the piece, and the earliest event ends it and may change the flow. Pieces depend on
 * what happened, not on how `advance` was called, so a run that is split anywhere gives the same bits.
 */
export class ContinuousSimulation implements Simulation {
  readonly scene: Scene;
  readonly work: Work;
  /** The run as the files of this folder see it. */
  readonly motion: Motion;
  private readonly start: Float64Array;
  /** Set if the budget is too small even for the start of the run. */
  private readonly refusal: WorkLimitReached | null = null;
  private readonly startHead: Float64Array;
  private readonly startRest: Float64Array;

  /**
   * @param method - effects and integrator
   * @param budget - limits the work; once it is used up, every further advance throws a WorkLimitReached
   */
  constructor({ effects: included, integratorOf }: Method, scene: Scene, recorder: Recorder | null, budget: WorkBudget) {
    const effects = included.of(scene.effects);
    const motion = new Motion(scene, integratorOf(scene.accuracy), included.partsOf(scene.effects), recorder, budget);
    for (const effect of effects) effect.attach?.(motion);
    this.scene = scene;
    this.work = motion.work;
    this.motion = motion;
    try {
      layOut(motion, effects);
      begin(motion);
    } catch (error) {
      if (!(error instanceof WorkLimitReached)) throw error;
      this.refusal = error;
    }
    this.start = motion.s.slice();
    if (motion.crowd !== null) motion.crowd.changed = false;
    this.startHead = this.start.subarray(0, motion.chasers);
    this.startRest = this.start.subarray(motion.chasers + CHASER * motion.chaserCount);
  }

  get tick(): number {
    return this.motion.s[TICK_NOW];
  }

  get modes(): readonly Mode[] {
    const { mode, modeSeconds } = this.motion;
    const seconds = Float64Array.from(modeSeconds);
    seconds[mode] += this.sincePieceBegan;
    const all = seconds.reduce((sum, t) => sum + t, 0);
    return MODES.map((name, i) => ({ name, share: all > 0 ? seconds[i] / all : 0 })).filter(({ share }) => share > 0);
  }

  get time(): number {
    const { s } = this.motion;
    return s[OUTCOME] === 0 ? s[TICK_NOW] * TICK : s[END_TIME];
  }

  get target(): number | null {
    const { s } = this.motion;
    return s[HELD] === 0 || s[TARGET] < 0 || s[OUTCOME] !== 0 ? null : this.scene.targets.index[s[TARGET]];
  }

  get mineralCount(): number {
    return this.motion.s[MINERALS];
  }

  get ending(): Ending | null {
    return endingOf(this.motion);
  }

  reset(): void {
    const { modeSeconds, work } = this.motion;
    const { motion, start } = this;
    const { s, crowd } = motion;
    if (s[AWAKE_COUNT] === 0 && !crowd?.changed) {
      // all chasers sleep where the level has them
      s.set(this.startHead);
      s.set(this.startRest, s.length - this.startRest.length);
      if (motion.recoils) motion.near.skin = -1;
      motion.stirred.length = 0;
      setFlow(motion);
    } else {
      s.set(start);
      motion.stirred.length = 0;
      this.resume();
    }
    modeSeconds.fill(0);
    work.pieces = work.forceEvaluations = work.guards = work.roots = 0;
  }

  snapshot(into?: Float64Array): Float64Array {
    const { s } = this.motion;
    if (into === undefined || into.length !== s.length) return s.slice();
    into.set(s);
    return into;
  }

  restore(snapshot: Float64Array): void {
    const { motion } = this;
    expectSnapshot(snapshot, motion.s.length);
    motion.s.set(snapshot);
    if (motion.recoils) readRocks(motion);
    this.resume();
    if (motion.crowd !== null) motion.crowd.changed = true;
  }

  /**
   * Puts the simulation on piece `i` of a record, to be read but not advanced.
   * @param chasers - where the chasers were; null if there are none
   * @param rocks - where the asteroids were; null if they don't move
   */
  resumePiece(pieces: PackedPieces, i: number, chasers: ChangeLog | null, rocks: ChangeLog | null): void {
    const { motion } = this;
    pieces.restore(i, motion);
    chasers?.seek(i, motion.s, motion.chasers);
    rocks?.seek(i, motion.s, motion.rocks);
    this.resume();
  }

  /** Restores what follows from the state after this was replaced. */
  private resume(): void {
    const { motion } = this;
    const { crowd } = motion;
    if (crowd !== null) {
      crowd.read();
      crowd.changed = false;
    }
    // moving objects may be elsewhere than in the neighbour list
    if (crowd !== null || motion.recoils) motion.near.skin = -1;
    setFlow(motion);
    motion.parts.following?.restore(motion);
  }

  /** Time from the beginning of the piece to the present, s. */
  private get sincePieceBegan(): number {
    const { s } = this.motion;
    return Math.max(0, (s[OUTCOME] === 0 ? s[TICK_NOW] / TICK_RATE : s[END_TIME]) - s[START]);
  }

  readState(out: Float64Array): void {
    this.stateAt(this.sincePieceBegan, out);
  }

  readAliens(out: Float64Array): void {
    this.aliensAt(this.sincePieceBegan, out);
  }

  get mayAliensHaveStirred(): boolean {
    const { s, crowd } = this.motion;
    return crowd !== null && (crowd.changed || s[AWAKE_COUNT] > 0);
  }

  readAsteroids(out: Float64Array): void {
    this.asteroidsAt(this.sincePieceBegan, out);
  }

  /** Like `readState`, `t` seconds after the piece began. */
  stateAt(t: number, out: Float64Array): void {
    const { motion } = this;
    const { s, her, base, facing, originX, originY } = motion;
    arriveAndTurnAt(motion, t);
    out[0] = originX + (s[BASE_X] + base[0] + her[0]);
    out[1] = originY + (s[BASE_Y] + base[1] + her[1]);
    out[2] = her[2] + base[2];
    out[3] = her[3] + base[3];
    out[4] = facing[0];
    out[5] = facing[1];
  }

  /** Like `readAliens`, `t` seconds after the piece began. */
  aliensAt(t: number, out: Float64Array): void {
    const { motion } = this;
    const { s, originX, originY, chasers } = motion;
    const count = this.motion.chaserCount;
    for (let i = 0; i < count; i++) {
      const o = chasers + CHASER * i;
      // nearly all of many stand still
      if (s[o + 4] === AWAKE) {
        chaserPlaceAt(motion, i, t, body);
        out[3 * i] = originX + body[0];
        out[3 * i + 1] = originY + body[1];
      } else {
        out[3 * i] = originX + s[o];
        out[3 * i + 1] = originY + s[o + 1];
      }
      out[3 * i + 2] = s[o + 4] === GONE ? 0 : 1;
    }
  }

  /** Like `readAsteroids`, `t` seconds after the piece began. */
  asteroidsAt(t: number, out: Float64Array): void {
    const { motion } = this;
    const { targets } = this.scene;
    for (let i = 0; i < targets.count; i++) {
      rockAt(motion, i, t, body);
      out[2 * targets.index[i]] = motion.originX + body[0];
      out[2 * targets.index[i] + 1] = motion.originY + body[1];
    }
  }

  isCollected(mineral: number): boolean {
    const { s, minerals } = this.motion;
    return s[minerals + mineral] !== 0;
  }

  advance(ticks: number, held: boolean): number {
    const { motion } = this;
    const { s } = motion;
    if (this.refusal !== null) throw this.refusal;
    if (s[OUTCOME] !== 0) return 0;
    const from = s[TICK_NOW];
    const limit = from + ticks;
    if ((s[HELD] === 1) !== held) {
      this.runUntil(from / TICK_RATE);
      if (s[OUTCOME] === 0) button(motion, held, from / TICK_RATE);
    }
    this.runUntil(limit / TICK_RATE);
    s[TICK_NOW] = s[OUTCOME] === 0 ? limit : Math.min(limit, Math.max(from, Math.floor(s[END_TIME] * TICK_RATE + 1e-9) + 1));
    return s[TICK_NOW] - from;
  }

  /** Carries out all events up to `time`. A mere touch at that very time waits: the button may change, and lead her away. */
  private runUntil(time: number): void {
    const { motion } = this;
    const { s } = motion;
    let instant = Number.NEGATIVE_INFINITY;
    let events = 0;
    while (s[OUTCOME] === 0 && (s[START] + s[NEXT] < time || (s[START] + s[NEXT] === time && s[ONSET] !== TOUCHES))) {
      if (s[START] + s[NEXT] > instant + motion.sameInstant) {
        instant = s[START] + s[NEXT];
        events = 0;
      }
      if (++events > MOST_AT_ONCE.inAnyLevel) this.limitEvents(events);
      fire(motion, time);
    }
  }

  /** @throws {@link WorkLimitReached} if so many events at one instant mean that the run does not advance */
  private limitEvents(events: number): void {
    const objects = objectLists(this.scene.level).reduce((sum, [, list]) => sum + list.length, 0);
    const most = MOST_AT_ONCE.inAnyLevel + MOST_AT_ONCE.byEachObject * objects;
    if (events > most) throw new WorkLimitReached(most, 'events');
  }

  /** Gives the unfinished piece at the end of a run to the recorder. */
  recordLast(): void {
    const { recorder } = this.motion;
    recorder?.piece(this.motion, this.sincePieceBegan);
  }
}
