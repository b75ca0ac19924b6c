import { TICK } from '../../../engine/index.ts';
import type { OrbitGrid, Orbits } from '../../prove/index.ts';
import { farFromLimit } from '../assumptions.ts';
import type { Claim } from '../claim.ts';
import { isCount, isFrom } from '../turned-scene.ts';
import { Stepper } from './advance.ts';
import { mostSquare } from './arithmetic.ts';
import { Boxes, SIZE } from './boxes.ts';
import { Forces } from './forces.ts';
import { Places } from './places.ts';
import { Drifts, ON_RIM, ROUNDING, type Scene, sceneOf } from './scene.ts';
import { asteroidOf, isNear, Sorter } from './sort-in.ts';

/** The most boxes of all times together, and the most pieces of boxes to examine. */
const MOST_BOXES = 600_000;
const MOST_PIECES = 24_000_000;
const TOO_MANY = 'following her takes too many boxes';

/** Beyond this, px, rounding errors of squares are too large. */
const FAR_OUT = 1e6;

/**
 * Checks `orbits`: it computes by itself the sets of states that she can reach, from the grid alone, until nothing is left.
 *
 * Around the nearest asteroid her angular momentum is preserved, held or not and with recoil (lemma `momentum`), so states are
 * boxes of distance, angle, rate of distance and angular momentum about one asteroid; near its centre, of x, y, their velocities
 * and angular momentum. What other asteroids, fields and winds can do is added as accelerations along both axes, so a box may
 * stay with its asteroid until another one is certainly nearer. Recoil moves asteroids by at most their drift (lemma `drift`),
 * and only one at a time, which widens every place and velocity that is taken from one asteroid to another.
 *
 * After each step boxes are cut along the grid, and those of one cell are joined. A piece has ended when all of it lies in one
 * hazard or out of every range. No place of a step may touch the object or a wormhole. Aliens only end runs and are ignored.
 */
export function checkOrbits(claim: Claim, { grid, steps }: Orbits): string | null {
  if (claim.frames || claim.steps) return 'with fixed steps her angular momentum is not preserved';
  if (!isGrid(grid)) return 'its grid is not valid';
  if (!isCount(1, 10_000, steps)) return 'its number of steps is not valid';
  const sets = new OrbitSets(claim, grid);
  while (sets.why === null && sets.boxes.count > 0 && sets.step < steps) sets.advance();
  return sets.why ?? (sets.boxes.count > 0 ? `some runs may continue after ${steps} steps` : null);
}

const isGrid = (grid: OrbitGrid | undefined): grid is OrbitGrid =>
  isFrom(0.25, 50, grid?.place) &&
  isFrom(0.25, 1000, grid?.speed) &&
  isFrom(1, 1e6, grid?.momentum) &&
  isCount(1, 60, grid?.frames);

/** All numbers between two. */
type Interval = readonly [number, number];

/** A set of states relative to an asteroid, wherever recoil has moved it: places in px, velocities in px/s, angles in rad. */
export type OrbitBox = {
  readonly asteroid: number;
  /** Angular momentum, px²/s. */
  readonly momentum: Interval;
} & (
  | { readonly kind: 'far'; readonly distance: Interval; readonly angle: Interval; readonly rate: Interval }
  | { readonly kind: 'near'; readonly x: Interval; readonly y: Interval; readonly vx: Interval; readonly vy: Interval }
);

/** The sets of states that she can reach, a step at a time. */
export class OrbitSets {
  /** What she can reach after the steps so far. */
  boxes = new Boxes();
  /** Steps so far. */
  step = 0;
  /** Boxes so far. */
  total = 0;
  /** Why the sets do not contain everything or cannot be followed any further; null while all is well. */
  why: string | null;
  private next = new Boxes();
  private readonly claim: Claim;
  private readonly scene: Scene;
  /** Up to the end of the step that is being made. */
  private readonly drifts: Drifts;
  private readonly stepper: Stepper;
  private readonly sorter: Sorter;
  private readonly box = new Float64Array(SIZE);

  constructor(claim: Claim, grid: OrbitGrid) {
    this.claim = claim;
    this.scene = sceneOf(claim, grid.frames * TICK);
    const places = new Places();
    this.drifts = new Drifts(this.scene);
    this.stepper = new Stepper(this.scene, places, new Forces(this.scene, places, this.drifts));
    this.sorter = new Sorter(this.scene, this.drifts, grid, MOST_PIECES);
    this.why = this.start();
  }

  /** Puts in the start: a point, in the chart of the nearest asteroid, in x and y. */
  private start(): string | null {
    const { scene, claim, box } = this;
    const { vx, vy } = claim.level.astronaut;
    const { charts } = scene;
    if (charts.length === 0) return 'there is no asteroid';
    if (!(scene.range <= FAR_OUT)) return 'the range is too large';
    const i = charts.reduce((best, { start }, k) => (start.r < charts[best].start.r ? k : best), 0);
    const { x, y, r } = charts[i].start;
    if (!(r <= FAR_OUT)) return 'she starts too far from every asteroid';
    const momentum = x * vy - y * vx;
    const blur = 1e-6 + 1e-6 * (r + Math.sqrt(vx * vx + vy * vy));
    const bounds = [x, y, vx, vy].flatMap((n) => [n - ROUNDING, n + ROUNDING]);
    box.set([...bounds, momentum - blur, momentum + blur]);
    // What is over at the start is dropped at once, so this is where she could touch anything.
    this.stepper.places.rectangle(box[0], box[1], box[2], box[3]);
    const touches = this.whyNotSafe(i);
    if (touches !== null) return touches;
    this.sorter.into(this.boxes);
    this.sorter.near(i, box);
    this.total = this.boxes.count;
    return this.sorter.isTooMuch ? TOO_MANY : null;
  }

  /** The boxes after the steps so far, for whoever wants to compare them with what she does. */
  *all(): Generator<OrbitBox> {
    for (let n = 0; n < this.boxes.count; n++) {
      const b = new Float64Array(SIZE);
      this.boxes.read(n, b);
      const chart = this.boxes.chartOf(n);
      const asteroid = asteroidOf(chart);
      yield isNear(chart)
        ? { kind: 'near', asteroid, momentum: [b[8], b[9]], x: [b[0], b[1]], y: [b[2], b[3]], vx: [b[4], b[5]], vy: [b[6], b[7]] }
        : { kind: 'far', asteroid, momentum: [b[6], b[7]], distance: [b[0], b[1]], angle: [b[2], b[3]], rate: [b[4], b[5]] };
    }
  }

  /** Makes one step, unless there is a reason not to. */
  advance(): void {
    this.why ??= this.advanced();
  }

  private advanced(): string | null {
    const { scene, box, boxes, next, sorter, stepper } = this;
    const time = ++this.step * scene.seconds;
    next.clear();
    this.drifts.until(time);
    sorter.into(next);
    let touches: string | null = null;
    const isSafe = (i: number) => {
      touches = this.whyNotSafe(i);
      return touches === null;
    };
    for (let n = 0; n < boxes.count; n++) {
      const chart = boxes.chartOf(n);
      const i = asteroidOf(chart);
      boxes.read(n, box);
      if (this.isTooFast(chart, box, time)) return 'she may reach the speed limit';
      const isDone = isNear(chart) ? stepper.near(i, box, isSafe) : stepper.polar(i, box, isSafe);
      if (!isDone) return touches ?? 'its steps are too long near an asteroid';
      if (isNear(chart)) sorter.near(i, box);
      else sorter.polar(i, box);
      if (sorter.isTooMuch || this.total + next.count > MOST_BOXES) return TOO_MANY;
    }
    this.total += next.count;
    this.boxes = next;
    this.next = boxes;
    return null;
  }

  /** What she may touch at the places of the step that is being made: the object or a wormhole; else null. */
  private whyNotSafe(i: number): string | null {
    const { places } = this.stepper;
    const drift = this.drifts.of(i);
    const { thing, mouths } = this.scene.charts[i];
    if (!places.areBeyond(thing, thing.radius + drift + ROUNDING)) return `she may touch it in step ${this.step}`;
    return mouths.every((mouth) => places.areBeyond(mouth, mouth.radius + drift + ON_RIM))
      ? null
      : `she may enter a wormhole in step ${this.step}`;
  }

  /** Whether she could come to the speed limit within a step that begins in this box and ends at some time. */
  private isTooFast(chart: number, box: Float64Array, time: number): boolean {
    const { scene, claim } = this;
    const across = mostSquare(box[6], box[7]);
    const speed = Math.sqrt(mostSquare(box[4], box[5]) + (isNear(chart) ? across : across / (box[0] * box[0])));
    const absolute = speed + scene.recoil * time;
    if (this.step > 1 && !(absolute <= farFromLimit(claim.rules))) return true;
    return !(absolute + claim.push * (scene.seconds + TICK) <= claim.rules.speedLimit);
  }
}
