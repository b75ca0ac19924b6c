import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation } from '../../engine/index.ts';
import type { Level, LevelFile } from '../../schema/index.ts';
import { proofPicture, proveBy, proveImpossible, verifyProof } from '../../solver/index.ts';
import { followOrbits } from '../../solver/prove/orbits/index.ts';
import { NUMBERS } from '../../solver/prove/orbits/layer.ts';
import { atan2, cos, sin } from '../../solver/prove/orbits/trigonometry.ts';
import { settingOf, thingOf } from '../../solver/prove/setting.ts';
import { expectDeep, itQuick } from '../depth.ts';
import { real } from '../real.ts';
import { at, LEVELS, level } from './impossible-levels.ts';

const HOLE = { kind: 'blackHole' } as const;
const whole = (min: number, max: number) => fc.integer({ min, max });
const script = fc.array(fc.tuple(whole(1, 60), fc.boolean()), { minLength: 3, maxLength: 20 });

interface Seen {
  readonly x: number;
  readonly y: number;
  readonly vx: number;
  readonly vy: number;
  /** Places of the asteroids, x and y in turn. */
  readonly rocks: readonly number[];
  /** The gun is held in the next tick. */
  readonly held: boolean;
}

/** What the engine says at each tick while the run goes on. */
function statesOf(of: Level, plan: readonly (readonly [number, boolean])[]): Seen[] {
  const simulation = createSimulation(compile(of, 'precise'));
  const state = new Float64Array(6);
  const rocks = new Float64Array(2 * of.asteroids.length);
  const all: Seen[] = [];
  for (const [ticks, held] of plan) {
    for (let n = 0; n < ticks; n++) {
      if (simulation.ending !== null) return all;
      simulation.readState(state);
      simulation.readAsteroids(rocks);
      const [x, y, vx, vy] = state;
      all.push({ x, y, vx, vy, rocks: [...rocks], held });
      simulation.advance(1, held);
    }
  }
  return all;
}

/** The asteroid nearest to her. */
function nearestOf({ x, y, rocks }: Seen): number {
  let best = 0;
  const far = (i: number) => Math.hypot(rocks[2 * i] - x, rocks[2 * i + 1] - y);
  for (let i = 1; i < rocks.length / 2; i++) if (far(i) < far(best)) best = i;
  return best;
}

/**
 * Her state about an asteroid. The engine does not tell an asteroid's velocity, but in ticks without the gun it is constant, so it
 * follows from two places.
 */
function about(i: number, now: Seen, next: Seen) {
  const x = now.x - now.rocks[2 * i];
  const y = now.y - now.rocks[2 * i + 1];
  const vx = now.vx - (next.rocks[2 * i] - now.rocks[2 * i]) * 60;
  const vy = now.vy - (next.rocks[2 * i + 1] - now.rocks[2 * i + 1]) * 60;
  const d = Math.hypot(x, y);
  return { x, y, vx, vy, d, direction: Math.atan2(y, x), w: (x * vx + y * vy) / d, momentum: x * vy - y * vx };
}

const anyLevel = fc
  .record({
    vx: real(-90, 90),
    vy: real(-90, 90),
    rocks: fc.array(fc.tuple(real(-220, 220), real(-220, 220), fc.constantFrom(16, 32)), { minLength: 1, maxLength: 4 }),
    recoil: fc.boolean(),
  })
  .map(({ vx, vy, rocks, recoil }) => ({
    astronaut: { x: 0, y: 0, vx, vy },
    blackHole: { x: 5000, y: 0 },
    minerals: [],
    asteroids: [at(100, 60), ...rocks.map(([x, y, r]) => at(x, y, r))],
    recoil,
  }));

describe('momentum: about the nearest asteroid it is constant while neither a field nor a wind acts', () => {
  it('precise', () => {
    let looks = 0;
    let pulled = 0;
    fc.assert(
      fc.property(anyLevel, script, (file, plan) => {
        const states = statesOf(level(file), plan);
        let last: { readonly i: number; readonly momentum: number; wasHeld: boolean } | null = null;
        for (const [n, now] of states.entries()) {
          const i = nearestOf(now);
          if (last !== null && last.i !== i) last = null;
          if (now.held && last !== null) last.wasHeld = true;
          const next = states[n + 1];
          if (next === undefined || now.held) continue;
          const { momentum } = about(i, now, next);
          if (last !== null) {
            looks++;
            if (last.wasHeld) pulled++;
            expect(Math.abs(momentum - last.momentum)).toBeLessThan(1e-6 * Math.abs(momentum) + 1e-4);
          }
          last = { i, momentum, wasHeld: false };
        }
      }),
      { numRuns: 60 },
    );
    // Otherwise the test would be vacuous.
    expectDeep(looks).toBeGreaterThan(500);
    expectDeep(pulled).toBeGreaterThan(20);
  });
});

const GRIDS = [
  { place: 6, speed: 6, momentum: 1500, frames: 6 },
  { place: 10, speed: 8, momentum: 900, frames: 12 },
];

/** Forces that act besides the nearest asteroid's. */
const FORCES: Record<string, Partial<LevelFile>> = {
  'asteroids only': {},
  'a repulsor': { repulsors: [at(40, -50, 48)] },
  'a wind': { winds: [{ ...at(-30, 50, 80), ax: 12, ay: -9 }] },
  'hot asteroids and novae': {
    asteroids: [{ ...at(100, 60), hot: true }, at(-90, 40), { ...at(-20, -120, 32), hot: true }],
    novae: [at(90, -60, 32), at(-120, -60)],
  },
};

describe.each(Object.keys(FORCES))('each state of the engine lies in a box: %s', (name) => {
  it.each(GRIDS)('place $place, $frames ticks', (grid) => {
    let looks = 0;
    fc.assert(
      fc.property(anyLevel, fc.array(script, { minLength: 3, maxLength: 5 }), (file, plans) => {
        const of = level({ ...file, ...FORCES[name] });
        const runs = plans.map((plan) => statesOf(of, plan));
        // Out of reach of everything, so that all that ends it is the number of boxes.
        const goal = thingOf(of, of.blackHole);
        const layer: NonNullable<Parameters<typeof followOrbits>[5]>['layer'] = ({ size, charts, boxes }, step) => {
          const tick = step * grid.frames;
          for (const run of runs) {
            const now = run[tick];
            const next = run[tick + 1];
            // With recoil velocities are known between ticks without the gun only.
            if (next === undefined || (of.recoil && now.held)) continue;
            // The numbers of a box in each chart.
            const states = of.asteroids.flatMap((_, i) => {
              const { x, y, vx, vy, d, direction, w, momentum } = about(i, now, next);
              const rest = [momentum, (vx * vx + vy * vy) / 2];
              return [
                [d, (direction + 2 * Math.PI) % (2 * Math.PI), w, 0, ...rest],
                [x, y, vx, vy, ...rest],
              ];
            });
            let found = false;
            for (let b = 0; b < size && !found; b++) {
              found = states[charts[b]].every((v, k) => boxes[b * NUMBERS + 2 * k] <= v && v <= boxes[b * NUMBERS + 2 * k + 1]);
            }
            looks++;
            if (!found) expect.fail(JSON.stringify({ step, now, states }));
          }
        };
        followOrbits(settingOf(of, 60, false), HOLE, goal, grid, { steps: 40, boxes: 1500 }, { layer });
      }),
      { numRuns: 10 },
    );
    expectDeep(looks).toBeGreaterThan(100);
  });
});

describe('a proof', () => {
  itQuick('is found where neither doomed nor flowpipe finds one, at precise only', () => {
    const proof = proveImpossible(LEVELS.orbits, { accuracy: 'precise' });
    expect(proof).toMatchObject({ code: 'orbits', covers: ['precise'], maxTime: null });
    expect(proof?.reason).toContain('at the edge of the range');
    expect(proveBy('doomed', LEVELS.orbits, HOLE)).toBeNull();
    expect(proveBy('flowpipe', LEVELS.orbits, HOLE)).toBeNull();
    expect(proveImpossible(LEVELS.orbits, { accuracy: 'standard' })).toBeNull();
  });

  itQuick('has a picture in which every place of a run is marked', () => {
    const proof = proveBy('orbits', LEVELS.orbits, HOLE);
    if (proof === null) throw new Error('expected a proof');
    const squares = proofPicture(LEVELS.orbits, proof).lines.filter(({ role }) => role === 'reach');
    for (const plan of [
      [[600, true]],
      [[600, false]],
      [
        [90, false],
        [600, true],
      ],
    ] as const) {
      for (const { x, y } of statesOf(LEVELS.orbits, plan)) {
        const isMarked = squares.some(({ points: [a, , b] }) => a.x <= x && x <= b.x && a.y <= y && y <= b.y);
        expect(isMarked).toBe(true);
      }
    }
  });

  it('is not found where a run completes the level, on any grid', () => {
    const states = statesOf(LEVELS.orbits, [
      [200, true],
      [100, false],
    ]);
    const { x, y } = states[states.length - 30];
    const of = { ...LEVELS.orbits, blackHole: { x, y, radius: 18 } };
    for (const fineness of [0, 1, 2]) expect(proveBy('orbits', of, HOLE, { fineness })).toBeNull();
    // The random plays that are sampled first do not hide it.
    for (const grid of GRIDS) {
      const most = { steps: 100, boxes: 50_000 };
      expect(followOrbits(settingOf(of, 60, false), HOLE, thingOf(of, of.blackHole), grid, most).closed).toBe(false);
    }
  });
});

describe('the checker accepts what the prover finds', () => {
  // Each is a case in which it once did not.
  const cases: Record<string, readonly [Partial<LevelFile>, number]> = {
    'a slow flight through a centre to a nova': [
      {
        astronaut: { x: 0, y: 0, vx: 16, vy: -57.8 },
        asteroids: [at(6.4, -23.1, 32)],
        novae: [at(25.7, -92.9, 25), at(66, -64.2, 25), at(-23.6, -89, 16)],
        range: 80,
      },
      0,
    ],
    'a fast flight through a centre': [
      { astronaut: { x: 0, y: 0, vx: -307, vy: 368.9 }, asteroids: [at(-52, 62.5, 32)], range: 150 },
      0,
    ],
    'a fast flight from afar through a centre that burns': [
      {
        astronaut: { x: 0, y: 0, vx: -90.9, vy: 285.9 },
        asteroids: [{ ...at(-36.3, 114.2), hot: true }, at(-60.8, -103.3, 32)],
        range: 150,
      },
      0,
    ],
    'a close pass with a short way to a nova': [
      {
        astronaut: { x: 0, y: 0, vx: 101, vy: -94 },
        asteroids: [at(120, 0), at(300, -80)],
        novae: [at(130, -98, 32)],
        range: 250,
      },
      3,
    ],
  };
  it.each(Object.keys(cases))('%s', (name) => {
    const [file, fineness] = cases[name];
    const of = level({ blackHole: { x: 5000, y: 0 }, minerals: [], ...file });
    const proof = proveBy('orbits', of, HOLE, { accuracy: 'precise', fineness });
    if (proof === null) throw new Error('expected a proof');
    expect(verifyProof(of, proof)).toEqual({ ok: true });
  });
});

it('sine, cosine and the angle of a vector are those of the standard library', () => {
  fc.assert(
    fc.property(real(-20, 20), real(-5, 5), real(-5, 5), (angle, x, y) => {
      expect(sin(angle)).toBeCloseTo(Math.sin(angle), 13);
      expect(cos(angle)).toBeCloseTo(Math.cos(angle), 13);
      expect(atan2(y, x)).toBeCloseTo(Math.atan2(y, x), 13);
    }),
  );
});
