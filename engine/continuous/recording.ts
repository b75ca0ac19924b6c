import type { Hold } from '../../schema/basics/index.ts';
import { ChangeLog } from '../change-log.ts';
import { type Clearance, ClearanceTracker } from '../clearance.ts';
import { ALL_EFFECTS, EFFECTS, type Effect, EffectSet } from '../effects/index.ts';
import { integratorOf } from '../integrators/index.ts';
import { awakeAt, type EventRule, type Motion, PackedPieces, RECORDS, type Recorder, SLOTS } from '../motion/index.ts';
import type { Scene } from '../scene.ts';
import { joinHolds, playScript } from '../script.ts';
import type { RunEvent, Trajectory } from '../simulation.ts';
import { maxTicksOf } from '../terms.ts';
import { unlimited, type WorkBudget, WorkLimitReached } from '../work-budget.ts';
import { approachHazards, FarHazards } from './approach.ts';
import { ContinuousSimulation, type Method } from './simulation.ts';

const { START, AWAKE_COUNT } = SLOTS;
const { CHASER, ROCK } = RECORDS;

/** The method for every scene and accuracy. */
export const WHOLE_METHOD: Method = { effects: ALL_EFFECTS, integratorOf };

/** Bytes that a recorded piece takes in addition to its numbers. */
const BYTES_A_PIECE = 128;

/** The clearance is first looked for at the beginnings of this many pieces, then everywhere. */
const FIRST_LOOKS = 64;

/** Records every piece and event of a run in continuous time. */
export class PieceRecorder implements Recorder, Trajectory {
  readonly events: RunEvent[] = [];
  /** The pieces, without chasers and asteroids. */
  private readonly pieces = new PackedPieces();
  private chasers: ChangeLog | null = null;
  private rocks: ChangeLog | null = null;
  private starts: number[] = [];
  private lengths: number[] = [];
  private end = 0;
  /** A simulation on the piece that was last read. */
  private reader: ContinuousSimulation | null = null;
  private readerAt = -1;
  private played: ContinuousSimulation | null = null;

  /**
   * @param budget - limits the work and memory of the recording, and the work of computing the clearance
   * @param keeps - false to keep events only
   */
  constructor(
    private readonly scene: Scene,
    private readonly budget: WorkBudget = unlimited(),
    readonly keeps = true,
  ) {}

  /** Records the motion's current piece, which is left after `t` seconds. */
  piece(motion: Motion, t: number): void {
    if (!this.keeps) return;
    const { s, crowd, budget, chasers, rocks, minerals, stirred } = motion;
    budget.record(8 * this.pieces.add(motion) + BYTES_A_PIECE);
    const start = s[START];
    this.end = start + t;
    this.starts.push(start);
    this.lengths.push(t);
    if (rocks > chasers) {
      this.chasers ??= new ChangeLog(CHASER, s.subarray(chasers, rocks), budget);
      this.chasers.next();
      for (let k = 0; k < s[AWAKE_COUNT]; k++) this.chasers.set(awakeAt(motion, k), s, chasers + CHASER * awakeAt(motion, k));
      if (crowd !== null) {
        for (const i of crowd.altered) this.chasers.set(i, s, chasers + CHASER * i);
        crowd.altered.length = 0;
      }
      const dragged = motion.chaserCount;
      if (motion.recoils) this.chasers.set(dragged, s, chasers + CHASER * dragged);
    }
    if (minerals > rocks) {
      this.rocks ??= new ChangeLog(ROCK, s.subarray(rocks, minerals), budget);
      this.rocks.next();
      for (const i of stirred) this.rocks.set(i, s, rocks + ROCK * i);
    }
  }

  event(event: RunEvent): void {
    this.events.push(event);
  }

  get duration(): number {
    return this.end;
  }

  at(time: number, out: Float64Array): void {
    const piece = this.pieceAt(time);
    this.open(piece).stateAt(this.sinceStart(piece, time), out);
  }

  aliensAt(time: number, out: Float64Array): void {
    const piece = this.pieceAt(time);
    this.open(piece).aliensAt(this.sinceStart(piece, time), out);
  }

  asteroidsAt(time: number, out: Float64Array): void {
    const piece = this.pieceAt(time);
    this.open(piece).asteroidsAt(this.sinceStart(piece, time), out);
  }

  /** The last piece that began by `time`. */
  private pieceAt(time: number): number {
    const { starts } = this;
    // reads in order, as for samples, find the same piece or the next
    let low = this.readerAt >= 0 && starts[this.readerAt] <= time ? this.readerAt : 0;
    let high = low + 1 < starts.length && starts[low + 1] > time ? low : starts.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (starts[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /**
   * Time since a piece began. Where whole periods were skipped after it, its end, so that she is shown where the piece left
   * her.
   */
  private sinceStart(piece: number, time: number): number {
    return Math.min(this.lengths[piece], Math.max(0, time - this.starts[piece]));
  }

  /** Takes the simulation that it has recorded for its reader: to make one takes as long as some pieces. */
  readWith(simulation: ContinuousSimulation): void {
    if (this.keeps) this.played = simulation;
  }

  /** The reader, on a piece. */
  private open(piece: number): ContinuousSimulation {
    if (this.reader === null) {
      this.played?.reset();
      this.reader = this.played ?? new ContinuousSimulation(WHOLE_METHOD, this.scene, null, this.budget);
    }
    if (this.readerAt === piece) return this.reader;
    this.readerAt = piece;
    this.reader.resumePiece(this.pieces, piece, this.chasers, this.rocks);
    return this.reader;
  }

  /** The motion of the reader, on any piece, but with the chasers of this one. */
  private motionWithChasers(piece: number, chasers: ChangeLog): Motion {
    const { motion } = this.reader ?? this.open(piece);
    this.readerAt = -1;
    chasers.seek(piece, motion.s, motion.chasers);
    return motion;
  }

  /** Shows `tracker` how near to hazards she comes on a piece within `length` seconds. */
  private approach(piece: number, length: number, tracker: ClearanceTracker, far: FarHazards | null): void {
    if (far !== null && tracker.least < Number.POSITIVE_INFINITY) {
      const motion = this.chasers === null ? null : this.motionWithChasers(piece, this.chasers);
      if (far.areOn(piece, length, tracker.least, this.budget, motion)) return;
    }
    const { motion } = this.open(piece);
    approachHazards(motion, motion.s[START], length, tracker);
  }

  /** The smallest gap to a hazard. */
  clearance(): Clearance | null {
    const { scene, events, starts } = this;
    const near = new ClearanceTracker(scene, WHOLE_METHOD.effects.hazardsOf(scene));
    if (near.count === 0) return null;
    const far = FarHazards.of(scene, this.pieces, near.lists);
    // first a few samples all along the run: they spare most of the search for hazards farther away than the nearest sample
    const stride = Math.ceil(starts.length / FIRST_LOOKS);
    if (far !== null) for (let i = 0; i < starts.length; i += stride) near.most = Math.min(near.most, far.gapAtStart(i));
    for (let i = 0; i < starts.length; i += stride) this.approach(i, 0, near, far);
    for (let i = 0; i < starts.length; i++) this.approach(i, this.lengths[i], near, far);
    const { best } = near;
    if (best === null || scene.accuracy.contact === 'frame') return best;
    // rounding must not contradict the run: it ended with the contact, or there was none
    const touched = events.at(-1)?.type === 'collided';
    return { ...best, distance: touched ? Math.min(0, best.distance) : Math.max(0, best.distance) };
  }
}

/** Gives the events of a simulation to a list, and keeps nothing else. */
export class EventRecorder implements Recorder {
  readonly keeps = false;

  /** @param events - receives the events */
  constructor(private readonly events: RunEvent[]) {}

  piece(): void {}

  event(event: RunEvent): void {
    this.events.push(event);
  }
}

/** The method for every scene and accuracy, with each effect replaced by what `change` makes of it. */
export const methodWith = (change: (effect: Effect) => Effect): Method => ({
  ...WHOLE_METHOD,
  effects: new EffectSet(EFFECTS.map(change), WHOLE_METHOD.effects.indexing),
});

/** What an effect costs in a run, as counts that are the same on every machine. */
export interface EffectWork {
  /** Name of the effect. */
  readonly name: string;
  /** Guards of its events that were followed. */
  readonly guards: number;
  /** Roots of these guards that were located. */
  readonly roots: number;
  /** Its events that happened. */
  readonly events: number;
}

/**
 * Plays holds from the start of a scene, and counts what each of its effects costs. The guards and roots of all effects
 * together are those of the run as `simulate` records it.
 *
 * @param scene - the scene
 * @param holds - half-open intervals [press, release) in ticks of 1/60 s; overlapping ones are joined
 * @param budget - limits the work; where it is used up, counting ends
 * @returns an entry for each simulated effect; null under `arcade`, whose frames examine everything
 */
export function workByEffect(scene: Scene, holds: readonly Hold[], budget: WorkBudget = unlimited()): EffectWork[] | null {
  if (scene.accuracy.integrator === 'arcade') return null;
  const counts = new Map(scene.effects.simulated.map(({ name }) => [name, { guards: 0, roots: 0, events: 0 }]));
  const method = methodWith((effect) => {
    const count = counts.get(effect.name);
    return count === undefined ? effect : { ...effect, events: effect.events?.map((rule) => counted(rule, count)) ?? [] };
  });
  try {
    const simulation = new ContinuousSimulation(method, scene, new PieceRecorder(scene, budget), budget);
    playScript(simulation, joinHolds(holds), maxTicksOf(scene.terms));
  } catch (error) {
    if (!(error instanceof WorkLimitReached)) throw error;
  }
  return [...counts].map(([name, count]) => ({ name, ...count }));
}

/** A kind of event that counts what it costs. */
function counted(rule: EventRule, count: { guards: number; roots: number; events: number }): EventRule {
  const seek = <A extends unknown[]>(look: ((m: Motion, ...rest: A) => void) | null) =>
    look === null
      ? null
      : (m: Motion, ...rest: A) => {
          const { guards, roots } = m.work;
          look(m, ...rest);
          count.guards += m.work.guards - guards;
          count.roots += m.work.roots - roots;
        };
  return {
    ...rule,
    guard: seek(rule.guard),
    first: seek(rule.first),
    always: seek(rule.always),
    fire(m, a, b, time) {
      count.events++;
      return rule.fire(m, a, b, time);
    },
  };
}
