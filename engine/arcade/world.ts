import type { Disc } from '../../schema/basics/index.ts';
import { type HazardList, hazardCount } from '../clearance.ts';
import type { Box } from '../contact.ts';
import { ALL_EFFECTS } from '../effects/index.ts';
import type { FrameRule } from '../frames.ts';
import type { IndexedCircles } from '../indexed-circles.ts';
import type { Scene } from '../scene.ts';
import { type BodyKind, expectSnapshot } from '../simulation.ts';
import type { WorkBudget } from '../work-budget.ts';
import { Chasers } from './chasers.ts';
import { BLACK_HOLE, COLLIDED, COS, HEAD, SEEN_TARGET, VX, VY, X, Y } from './layout.ts';
import { ROCK, Rocks } from './rocks.ts';
import type { Deadly } from './square.ts';

/** Indices in {@link World.numbers}. */
export const NUMBERS = { PULL: 0, RECOIL: 1, LIMIT: 2 } as const;

/** Hazards of one list in frames. */
interface DeadlyList extends Deadly {
  /** The outcome of touching one of it. */
  readonly outcome: number;
}

/** Up to this many doubles are copied faster one by one. */
const FEW = 48;

/**
 * What the parts of an `arcade` simulation share: its state, and what they read in every frame. The latter is copied from the
 * scene, because levels are objects of many shapes, and code that has met several of them becomes slower with each one.
 */
export class World {
  readonly s: Float64Array;
  readonly recoil: boolean;
  /**
   * Pull, recoil and speed limit. In a typed array, because V8 reads doubles from it directly, but boxed ones from an
   * object.
   */
  readonly numbers: Float64Array;
  readonly box: Box;
  readonly rocks: Rocks;
  readonly chasers: Chasers;
  readonly range: number;
  readonly targetR: Float64Array;
  /** What she collects by touch. */
  readonly collectables: IndexedCircles;
  readonly collectableX: Float64Array;
  readonly collectableY: Float64Array;
  readonly collectableR: Float64Array;
  /** Index in the state of the flags of what is collected. */
  readonly collected: number;
  /** What ends the run by touch, besides the black hole and what chases her. */
  readonly deadly: readonly DeadlyList[];
  // the same by its code in a neighbourhood, with the black hole; moving asteroids are kept elsewhere
  readonly deadlyX: Float64Array;
  readonly deadlyY: Float64Array;
  readonly deadlyR: Float64Array;
  /** Code of the first target; behind all codes if no asteroid ends the run. */
  readonly firstTarget: number;
  /** The targets' places, x and y alternately from `placesFrom` on, `placesStep` apart; in the state if they move. */
  readonly places: Float64Array;
  readonly placesFrom: number;
  readonly placesStep: number;
  /** Frame rules of effects that act only where levels call for them, and the index in the state of each one's doubles. */
  readonly frameRules: readonly FrameRule[];
  readonly frameStates: readonly number[];
  private readonly hazards: readonly HazardList[];
  private readonly start: Float64Array;

  constructor(
    readonly scene: Scene,
    readonly budget: WorkBudget,
  ) {
    const { level, targets } = scene;
    this.recoil = level.recoil;
    const { pull, recoil, speedLimit } = scene.rules;
    this.numbers = Float64Array.of(pull, recoil, speedLimit);
    this.box = scene.box;
    this.frameRules = ALL_EFFECTS.frameRulesOf(scene.effects);
    const collectables = ALL_EFFECTS.collectedOf(scene);
    const chase = ALL_EFFECTS.chaseOf(scene.effects);
    const chased = chase?.circles(scene).count ?? 0;
    let length = HEAD + (this.recoil ? (ROCK + 1) * targets.count : 0) + Chasers.length(chased) + collectables.count;
    this.frameStates = this.frameRules.map((rule) => {
      const at = length;
      length += rule.stateLength?.(scene) ?? 0;
      return at;
    });
    this.s = new Float64Array(length);
    this.start = new Float64Array(length);
    this.rocks = new Rocks(this.s, scene);
    this.chasers = new Chasers(this.s, scene, this.rocks.end, budget);
    this.collected = this.chasers.end;
    this.range = level.range;
    this.targetR = targets.r;
    this.collectables = collectables;
    this.collectableX = collectables.x;
    this.collectableY = collectables.y;
    this.collectableR = collectables.r;
    this.places = this.recoil ? this.s : new Float64Array(2 * targets.count);
    this.placesFrom = this.recoil ? HEAD : 0;
    this.placesStep = this.recoil ? ROCK : 2;
    this.hazards = ALL_EFFECTS.hazardsOf(scene);
    // loops and one pass: a level is often played once, and lists take longer to make than such a run
    const deadly: DeadlyList[] = [];
    let from = 1;
    for (let k = 0; k < this.hazards.length; k++) {
      const { kind, circles, first, movedBy } = this.hazards[k];
      if (movedBy === 'chase') continue;
      deadly.push({ kind, circles, first, movedBy, from, outcome: COLLIDED + k });
      from += circles.count;
    }
    this.deadly = deadly;
    this.deadlyX = new Float64Array(from);
    this.deadlyY = new Float64Array(from);
    this.deadlyR = new Float64Array(from);
    this.placeDeadly(level.blackHole);
    this.firstTarget = this.deadly.find(({ movedBy }) => movedBy === 'recoil')?.from ?? from;
    this.layOut();
    this.reset();
  }

  private placeDeadly({ x, y, radius }: Disc): void {
    const { deadly, deadlyX, deadlyY, deadlyR } = this;
    deadlyX[0] = x;
    deadlyY[0] = y;
    deadlyR[0] = radius;
    for (let k = 0; k < deadly.length; k++) {
      const { from, circles } = deadly[k];
      for (let i = 0; i < circles.count; i++) {
        deadlyX[from + i] = circles.x[i];
        deadlyY[from + i] = circles.y[i];
        deadlyR[from + i] = circles.r[i];
      }
    }
  }

  private layOut(): void {
    const { level, targets } = this.scene;
    const s = this.start;
    s[X] = level.astronaut.x;
    s[Y] = level.astronaut.y;
    s[VX] = level.astronaut.vx;
    s[VY] = level.astronaut.vy;
    s[COS] = 1;
    s[SEEN_TARGET] = -1;
    this.rocks.layOut(s);
    this.chasers.layOut(s);
    for (const [k, rule] of this.frameRules.entries()) rule.layOut?.(this.scene, s, this.frameStates[k]);
    if (this.recoil) return;
    for (let i = 0; i < targets.count; i++) {
      this.places[2 * i] = targets.x[i];
      this.places[2 * i + 1] = targets.y[i];
    }
  }

  /** How many objects end the run by touch, besides the black hole. */
  get hazardCount(): number {
    return hazardCount(this.hazards);
  }

  /** The outcome of touching what chases her. */
  get caught(): number {
    return COLLIDED + this.hazards.findIndex(({ movedBy }) => movedBy === 'chase');
  }

  /** The kind of object that she has touched, by the outcome; null if none. */
  kindTouched(outcome: number): BodyKind | null {
    if (outcome >= COLLIDED) return this.hazards[outcome - COLLIDED].kind;
    return outcome === BLACK_HOLE ? 'blackHole' : null;
  }

  /** Whether such an effect must be called wherever she is. */
  get isBusy(): boolean {
    const { frameRules, frameStates } = this;
    for (let k = 0; k < frameRules.length; k++) if (frameRules[k].isBusy?.(this.scene, this.s, frameStates[k])) return true;
    return false;
  }

  reset(): void {
    copy(this.start, this.s);
    this.chasers.forget();
  }

  snapshot(into?: Float64Array): Float64Array {
    if (into === undefined || into.length !== this.s.length) return this.s.slice();
    copy(this.s, into);
    return into;
  }

  restore(snapshot: Float64Array): void {
    expectSnapshot(snapshot, this.s.length);
    copy(snapshot, this.s);
    this.chasers.forget();
  }
}

function copy(from: Float64Array, to: Float64Array): void {
  if (from.length > FEW) {
    to.set(from);
    return;
  }
  for (let i = 0; i < from.length; i++) to[i] = from[i];
}
