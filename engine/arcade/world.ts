import type { Box } from '../contact/index.ts';
import { effectsOf } from '../effects/index.ts';
import type { FrameRule } from '../frames/index.ts';
import type { Scene } from '../scene.ts';
import { expectSnapshot } from '../snapshot.ts';
import type { WorkBudget } from '../work-budget.ts';
import { Aliens } from './aliens.ts';
import { COS, HEAD, VX, VY, X, Y } from './layout.ts';
import { ROCK, Rocks } from './rocks.ts';

/** Places in {@link World.numbers}. */
export const NUMBERS = { PULL: 0, PUSH: 1, RECOIL: 2, LIMIT: 3 } as const;

/** Up to this many numbers are copied faster one by one. */
const FEW = 48;

/**
 * What the parts of an `arcade` simulation share: its state, and what they look at in every frame. That is copied out of the
 * scene, for levels are objects of many shapes, and code that has met a few of them runs slower with every one.
 */
export class World {
  readonly s: Float64Array;
  readonly recoil: boolean;
  /** Pull, push, recoil and speed limit: in a typed array, for V8 reads doubles from it and from an object it reads boxes. */
  readonly numbers: Float64Array;
  readonly box: Box;
  readonly rocks: Rocks;
  readonly aliens: Aliens;
  readonly range: number;
  readonly targetR: Float64Array;
  readonly mineralX: Float64Array;
  readonly mineralY: Float64Array;
  readonly mineralR: Float64Array;
  readonly repulsorX: Float64Array;
  readonly repulsorY: Float64Array;
  readonly repulsorR: Float64Array;
  /** Where the flags of collected minerals are kept. */
  readonly collected: number;
  // what ends the run by touch, by its code in a neighbourhood; asteroids that move are elsewhere
  readonly deadlyX: Float64Array;
  readonly deadlyY: Float64Array;
  readonly deadlyR: Float64Array;
  /** Code of the first target. */
  readonly firstTarget: number;
  /** The targets' places, x and y in turn from `placesFrom` on, `placesStep` apart: the state's where they move. */
  readonly places: Float64Array;
  readonly placesFrom: number;
  readonly placesStep: number;
  /** What effects beyond the original's do in a frame, and where in the state each has its own. */
  readonly frameRules: readonly FrameRule[];
  readonly frameStates: readonly number[];
  private readonly start: Float64Array;

  constructor(
    readonly scene: Scene,
    readonly budget: WorkBudget,
  ) {
    const { level, targets, novae, repulsors, aliens, minerals } = scene;
    const { blackHole } = level;
    this.recoil = level.recoil;
    const { pull, push, recoil, speedLimit } = scene.rules;
    this.numbers = Float64Array.of(pull, push, recoil, speedLimit);
    this.box = scene.box;
    this.frameRules = effectsOf(scene.effects).flatMap(({ frame }) => frame ?? []);
    let length = HEAD + (this.recoil ? (ROCK + 1) * targets.count : 0) + Aliens.length(aliens.count) + minerals.count;
    this.frameStates = this.frameRules.map((rule) => {
      const at = length;
      length += rule.stateLength?.(scene) ?? 0;
      return at;
    });
    this.s = new Float64Array(length);
    this.start = new Float64Array(length);
    this.rocks = new Rocks(this.s, scene);
    this.aliens = new Aliens(this.s, scene, this.rocks.end, budget);
    this.collected = this.aliens.end;
    this.range = level.range;
    this.targetR = targets.r;
    this.mineralX = minerals.x;
    this.mineralY = minerals.y;
    this.mineralR = minerals.r;
    this.repulsorX = repulsors.x;
    this.repulsorY = repulsors.y;
    this.repulsorR = repulsors.r;
    this.places = this.recoil ? this.s : new Float64Array(2 * targets.count);
    this.placesFrom = this.recoil ? HEAD : 0;
    this.placesStep = this.recoil ? ROCK : 2;
    this.deadlyX = Float64Array.from([blackHole.x, ...novae.x, ...targets.x]);
    this.deadlyY = Float64Array.from([blackHole.y, ...novae.y, ...targets.y]);
    this.deadlyR = Float64Array.from([blackHole.radius, ...novae.r, ...targets.r]);
    this.firstTarget = 1 + novae.count;
    this.layOut();
    this.reset();
  }

  private layOut(): void {
    const { level, targets } = this.scene;
    const s = this.start;
    s[X] = level.astronaut.x;
    s[Y] = level.astronaut.y;
    s[VX] = level.astronaut.vx;
    s[VY] = level.astronaut.vy;
    s[COS] = 1;
    this.rocks.layOut(s);
    this.aliens.layOut(s);
    for (const [k, rule] of this.frameRules.entries()) rule.layOut?.(this.scene, s, this.frameStates[k]);
    if (this.recoil) return;
    for (let i = 0; i < targets.count; i++) {
      this.places[2 * i] = targets.x[i];
      this.places[2 * i + 1] = targets.y[i];
    }
  }

  /** Whether an effect beyond the original's is to be asked wherever she is. */
  get isBusy(): boolean {
    const { frameRules, frameStates } = this;
    for (let k = 0; k < frameRules.length; k++) if (frameRules[k].isBusy?.(this.scene, this.s, frameStates[k])) return true;
    return false;
  }

  reset(): void {
    copy(this.start, this.s);
    this.aliens.forget();
  }

  snapshot(into?: Float64Array): Float64Array {
    if (into === undefined || into.length !== this.s.length) return this.s.slice();
    copy(this.s, into);
    return into;
  }

  restore(snapshot: Float64Array): void {
    expectSnapshot(snapshot, this.s.length);
    copy(snapshot, this.s);
    this.aliens.forget();
  }
}

function copy(from: Float64Array, to: Float64Array): void {
  if (from.length > FEW) {
    to.set(from);
    return;
  }
  for (let i = 0; i < from.length; i++) to[i] = from[i];
}
