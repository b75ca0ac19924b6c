import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  ACCURACIES,
  type Accuracy,
  compile,
  createSimulation,
  type Scene,
  type Simulation,
  STATE_SIZE,
  simulate,
} from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { offLine } from './exact-line.ts';
import { plainLevel } from './plain-level.ts';

/** Every accuracy in continuous time, and tolerances of one's own. */
const accuracies: readonly Accuracy[] = [
  ACCURACIES.precise,
  ACCURACIES.standard,
  ACCURACIES.fast,
  { ...ACCURACIES.precise, name: 'precise at 1e-3', tolerance: 1e-3 },
  { ...ACCURACIES.precise, name: 'precise at 1e-12', tolerance: 1e-12 },
  { ...ACCURACIES.fast, name: 'euler', integrator: 'euler' },
];

/**
 * How far beside the exact line a place may be told, px for each px of its numbers. Its coordinates are rounded, so are those of the
 * centre that it is told from, and the slope of the line.
 */
const ROUNDING = 5e-16;

const even = (min: number, max: number) => fc.integer({ min: 0, max: 2 ** 31 - 1 }).map((k) => min + ((max - min) * k) / 2 ** 31);

interface Row {
  readonly start: readonly [number, number];
  /** asteroids, from the start */
  readonly first: readonly [number, number];
  readonly others: readonly number[];
  readonly radius: number;
  readonly range: number;
  readonly recoil: boolean;
}

/** From rest: an asteroid in range, perhaps others on the line through both, as well as doubles can say. */
const row: fc.Arbitrary<Row> = fc.record({
  start: fc.oneof(fc.constant([0, 0] as const), fc.tuple(even(-500, 500), even(-500, 500))),
  first: fc
    .tuple(fc.oneof(even(-150, 150), fc.constant(0)), fc.oneof(even(-150, 150), fc.constant(1e-3)))
    .filter(([x, y]) => Math.abs(x) + Math.abs(y) > 1e-6),
  others: fc.array(even(-4, 4), { maxLength: 2 }),
  radius: fc.constantFrom(0.05, 1, 16, 32),
  range: fc.constantFrom(250, 400, 1000),
  recoil: fc.boolean(),
});

function compileRow({ start: [x, y], first: [dx, dy], others, radius, range, recoil }: Row, accuracy: Accuracy): Scene {
  const asteroids = [1, ...others].map((k) => ({ x: x + k * dx, y: y + k * dy, radius }));
  return compile(plainLevel({ astronaut: { x, y }, range, recoil, asteroids }), accuracy);
}

/** Watches a simulation for being on the line from its start through the first asteroid. */
class Watch {
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly asteroids: Float64Array;
  private readonly start: readonly [number, number];
  private readonly end: readonly [number, number];
  private direction: readonly [number, number] | null = null;
  /** Largest share of what rounding allows. */
  worst = 0;

  constructor(readonly scene: Scene) {
    const { astronaut, asteroids } = scene.level;
    this.start = [astronaut.x, astronaut.y];
    this.end = [asteroids[0].x, asteroids[0].y];
    this.asteroids = new Float64Array(2 * asteroids.length);
  }

  /** Looks at her, and at the asteroids. */
  see(simulation: Simulation, held: boolean): void {
    const { state, asteroids, start, end } = this;
    simulation.readState(state);
    const [x, y, vx, vy, cos, sin] = state;
    const size = (px: number, py: number) => [...start, ...end, px, py].reduce((sum, c) => sum + Math.abs(c), 0);
    const share = (px: number, py: number) => Math.abs(offLine(start, end, [px, py])) / (ROUNDING * size(px, py));
    this.worst = Math.max(this.worst, share(x, y));
    if (this.scene.level.recoil) {
      simulation.readAsteroids(asteroids);
      this.worst = Math.max(this.worst, share(asteroids[0], asteroids[1]));
    }
    const aside = Math.abs(offLine([0, 0], [end[0] - start[0], end[1] - start[1]], [vx, vy]));
    this.worst = Math.max(this.worst, aside / (ROUNDING * size(0, 0) * (Math.abs(vx) + Math.abs(vy)) / 1 + 1e-300) * 1e0);
    if (!held || simulation.ending !== null) return;
    this.direction ??= [cos, sin];
    const [c, s] = this.direction;
    // the same pair of doubles, or its negative
    expect([cos === c && sin === s, cos === -c && sin === -s]).toContain(true);
  }
}
