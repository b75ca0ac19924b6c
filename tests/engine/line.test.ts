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
import { expectDeep } from '../depth.ts';
import { continuousNames } from './accuracies.ts';
import { offLine } from './exact-line.ts';
import { plainLevel } from './plain-level.ts';

/** Every accuracy in continuous time, and custom tolerances. */
const accuracies: readonly Accuracy[] = [
  ACCURACIES.precise,
  ACCURACIES.standard,
  ACCURACIES.fast,
  { ...ACCURACIES.precise, name: 'precise at 1e-3', tolerance: 1e-3 },
  { ...ACCURACIES.precise, name: 'precise at 1e-12', tolerance: 1e-12 },
];

/**
 * The allowed distance of a place from the exact line, px for each px of its coordinates. Its coordinates are rounded, as are
 * those of the centre from which it is computed, and the slope of the line.
 */
const ROUNDING = 2e-16;

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

/** From rest: an asteroid in range, and possibly others on the line through both, as exactly as doubles allow. */
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

interface Point {
  readonly x: number;
  readonly y: number;
}

/** Checks that a simulation stays on the line from its start through the first asteroid that pulls. */
class Watch {
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly asteroids: Float64Array;
  private readonly start: readonly [number, number];
  private readonly end: readonly [number, number];
  private direction: readonly [number, number] | null = null;
  /** The largest deviation, as a share of the allowed one. */
  worst = 0;
  /** The ticks at which the direction of her box, with the gun held, is not the same pair of doubles or its negative. */
  turned = 0;

  constructor(readonly scene: Scene) {
    const { astronaut, asteroids } = scene.level;
    const distance = ({ x, y }: Point) => Math.hypot(x - astronaut.x, y - astronaut.y);
    const nearest = asteroids.reduce((best, other) => (distance(other) < distance(best) ? other : best));
    this.start = [astronaut.x, astronaut.y];
    this.end = [nearest.x, nearest.y];
    this.asteroids = new Float64Array(2 * asteroids.length);
  }

  /** Checks her place, and those of the asteroids. */
  see(simulation: Simulation, held: boolean): void {
    const { state, asteroids, start, end } = this;
    simulation.readState(state);
    const [x, y, vx, vy, cos, sin] = state;
    const size = (px: number, py: number) => [...start, ...end, px, py].reduce((sum, c) => sum + Math.abs(c), 0);
    const share = (px: number, py: number) => Math.abs(offLine(start, end, [px, py])) / (ROUNDING * size(px, py));
    this.worst = Math.max(this.worst, share(x, y));
    if (this.scene.level.recoil) {
      simulation.readAsteroids(asteroids);
      for (let i = 0; i < asteroids.length; i += 2) this.worst = Math.max(this.worst, share(asteroids[i], asteroids[i + 1]));
    }
    const aside = Math.abs(offLine([0, 0], [end[0] - start[0], end[1] - start[1]], [vx, vy]));
    if (vx !== 0 || vy !== 0) this.worst = Math.max(this.worst, aside / (ROUNDING * (Math.abs(vx) + Math.abs(vy))));
    if (!held || simulation.ending !== null) return;
    this.direction ??= [cos, sin];
    const [c, s] = this.direction;
    if (!((cos === c && sin === s) || (cos === -c && sin === -s))) this.turned++;
  }
}

/** The lengths of presses and releases in ticks; many are one tick. */
const script = fc.array(fc.oneof(fc.constant(1), fc.integer({ min: 1, max: 40 }), fc.integer({ min: 1, max: 150 })), {
  minLength: 4,
  maxLength: 20,
});

describe.each(accuracies.map((a) => [a.name, a] as const))('from rest she stays on the line: %s', (_name, accuracy) => {
  it('whatever the gun does, through snapshots', () => {
    let worst = 0;
    fc.assert(
      fc.property(row, script, fc.boolean(), (of, ticks, first) => {
        const scene = compileRow(of, accuracy);
        const watch = new Watch(scene);
        let simulation = createSimulation(scene);
        let held = first;
        for (const count of ticks) {
          for (let k = 0; k < count && simulation.ending === null; k++) {
            simulation.advance(1, held);
            watch.see(simulation, held);
          }
          const next = createSimulation(scene);
          next.restore(simulation.snapshot());
          simulation = next;
          held = !held;
        }
        worst = Math.max(worst, watch.worst);
        expect(watch.worst).toBeLessThan(1);
        expect(watch.turned).toBe(0);
      }),
      { numRuns: 10 },
    );
    expectDeep(worst).toBeGreaterThan(0);
  });

  it('even if a search tries to move her off it', () => {
    fc.assert(
      fc.property(row, fc.nat(2 ** 30), (of, seed) => {
        const scene = compileRow(of, accuracy);
        const watch = new Watch(scene);
        const simulation = createSimulation(scene);
        const random = generator(seed);
        // greedy: of eight continuations, the one that ends farthest off the line; of equals, the slowest at the centre
        let best = simulation.snapshot();
        for (let round = 0; round < 12; round++) {
          let farthest = -1;
          const from = best;
          for (let way = 0; way < 8; way++) {
            simulation.restore(from);
            const tap = random() < 0.5;
            watch.worst = 0;
            let held = random() < 0.5;
            for (let k = 0; k < 4; k++) {
              const count = tap && held ? 1 : 1 + Math.floor(random() * 60);
              simulation.advance(count, held);
              watch.see(simulation, held);
              held = !held;
            }
            expect(watch.worst).toBeLessThan(1);
            expect(watch.turned).toBe(0);
            if (simulation.ending !== null || watch.worst <= farthest) continue;
            farthest = watch.worst;
            best = simulation.snapshot();
          }
        }
      }),
      { numRuns: 10 },
    );
  });
});

/** Pseudo-random numbers from 0 to 1 for a seed. */
function generator(seed: number): () => number {
  let s = seed;
  return () => {
    s = (Math.imul(s, 1664525) + 1013904223) >>> 0;
    return s / 2 ** 32;
  };
}

describe.each(continuousNames)('beside the target, where only a turning box would reach: %s', (accuracy) => {
  // 34.55 px from the asteroid's centre, at right angles to her path: more than 18 + 16, less than 18 + half the box's diagonal
  const level = plainLevel({
    range: 250,
    asteroids: [{ x: 64.2, y: 102.7, radius: 32 }],
    blackHole: { x: 34.903, y: 121.014 },
  });
  // a search found each of these when rounding moved her off the line
  const runs: readonly (readonly Hold[])[] = [
    [
      [0, 528],
      [608, 800],
      [878, 1227],
    ],
  ];

  it('the black hole is not reached', () => {
    for (const holds of runs) expect(simulate(compile(level, accuracy), holds).outcome).not.toBe('completed');
  });
});
