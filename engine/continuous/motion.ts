import { TICK_RATE } from '../constants.ts';
import type { Scene } from '../scene.ts';
import { COAST, Flow } from './flow.ts';
import { type Integrator, integratorOf } from './integrator.ts';
import { NeighbourList } from './neighbour-list.ts';
import type { PieceRecorder } from './recording.ts';
import { HEAD, RECORDS, SLOTS } from './state.ts';

const { START, NEXT, HELD, TARGET, FIELD, KIND, MOVES } = SLOTS;
const { CHASER, ROCK } = RECORDS;

/** Two events nearer than this are the same instant, s per s of time and at least one second's worth. */
const SAME_INSTANT = 2e-14;

/** What can move her between two events. */
export const MODES = ['coast', 'pull', 'pull on a line', 'push', 'push on a line'] as const;

/**
 * A run in continuous time as it stands: the state, the piece it is on, and what every step of the method works with. One
 * record of one shape for all of them; what is done with it is in the functions of this folder.
 *
 * Places are kept relative to where she starts, and hers relative to the centre of the force that acts (the frame's
 * base), so that neither a far-off origin nor a close pass costs digits.
 */
export class Motion {
  readonly scene: Scene;
  readonly recorder: PieceRecorder | null;
  readonly integrator: Integrator;
  readonly flow = new Flow();
  readonly near: NeighbourList;
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
  readonly chaserX: Float64Array[] = [];
  readonly chaserY: Float64Array[] = [];
  /** Where in the state chasers, rocks and the minerals' flags begin. */
  readonly chasers: number;
  readonly rocks: number;
  readonly minerals: number;
  /** From here on a flag for each repulsor that contains her. */
  readonly inside: number;
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
  /** Whether an index finds some of the neighbours. */
  readonly crowded: boolean;
  /** What the last look at the piece found: places, velocities, a direction; each function says where. */
  readonly e = new Float64Array(12);
  readonly steps = new Int32Array(1);
  /** Her place relative to the origin: what chasers follow. */
  readonly wx: Float64Array;
  readonly wy: Float64Array;

  // the circle a guard is about, relative to the base
  circleX = 0;
  circleY = 0;
  circleVX = 0;
  circleVY = 0;
  circleMotion = 0;
  circleSeries = 0;

  constructor(scene: Scene, recorder: PieceRecorder | null) {
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
    this.lines = this.inside + repulsors.count;
    let end = this.lines + (this.recoils ? targets.count : 0);
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
    return 1 / (2 * this.scene.targets.r[s[TARGET]]);
  }

  /** Index into {@link MODES}. */
  get mode(): number {
    const { s } = this;
    return s[KIND] === COAST ? 0 : s[KIND] + (s[FIELD] >= 0 ? 2 : 0);
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
