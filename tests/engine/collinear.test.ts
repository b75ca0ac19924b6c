import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, createSimulation, STATE_SIZE } from '../../engine/index.ts';
import { expectDeep } from '../depth.ts';
import { continuousNames } from './accuracies.ts';
import { type LineRun, type LineScene, moveOnLine } from './motion-on-a-line.ts';
import { plainLevel } from './plain-level.ts';

const even = (min: number, max: number) => fc.integer({ min: 0, max: 2 ** 31 - 1 }).map((k) => min + ((max - min) * k) / 2 ** 31);
const place = fc.oneof(even(-120, 120), fc.integer({ min: -120, max: 120 }));

const lineScene: fc.Arbitrary<LineScene> = fc.record({
  start: fc.constant(0),
  velocity: fc.oneof(fc.constant(0), even(-60, 60)),
  range: fc.constantFrom(250, 400),
  recoil: fc.oneof({ weight: 4, arbitrary: fc.constant(true) }, { weight: 1, arbitrary: fc.constant(false) }),
  asteroids: fc.array(fc.record({ at: place, radius: fc.constantFrom(0.02, 0.5, 2, 16, 32) }), { minLength: 1, maxLength: 3 }),
  fields: fc.array(fc.record({ at: fc.oneof(place, fc.constant(0)), radius: fc.constantFrom(20, 32, 48, 300) }), {
    maxLength: 2,
  }),
});

/** The number of ticks of each state of the button, released first. */
const button = fc.array(fc.integer({ min: 1, max: 200 }), { minLength: 1, maxLength: 8 });

const DIRECTIONS = [
  [1, 0],
  [0, -1],
  [0.6, 0.8],
  [-0.8, 0.6],
] as const;

const TICKS = 400;
const RUNS = 25;

function heldBy(parts: readonly number[]): (tick: number) => boolean {
  const held: boolean[] = parts.flatMap((count, i) => new Array<boolean>(count).fill(i % 2 === 1));
  return (tick) => held[tick] ?? parts.length % 2 === 1;
}

/** The same by the engine: places along the direction, and her largest distance from the line. */
function play(
  scene: LineScene,
  [cos, sin]: readonly [number, number],
  held: (tick: number) => boolean,
  accuracy: AccuracyName,
  beside = 0,
) {
  const on = (at: number, radius: number) => ({ x: at * cos, y: at * sin, radius });
  const { start, velocity, range, recoil } = scene;
  const level = plainLevel({
    astronaut: { x: start * cos - beside * sin, y: start * sin + beside * cos, vx: velocity * cos, vy: velocity * sin },
    blackHole: { x: 1e6 * sin, y: -1e6 * cos },
    range,
    recoil,
    asteroids: scene.asteroids.map(({ at, radius }) => on(at, radius)),
    repulsors: scene.fields.map(({ at, radius }) => on(at, radius)),
  });
  const simulation = createSimulation(compile(level, accuracy));
  const state = new Float64Array(STATE_SIZE);
  const asteroids = new Float64Array(2 * level.asteroids.length);
  const run: LineRun = [];
  let aside = 0;
  for (let tick = 0; tick < TICKS && simulation.ending === null; tick++) {
    simulation.advance(1, held(tick));
    simulation.readState(state);
    simulation.readAsteroids(asteroids);
    run.push([
      state[0] * cos + state[1] * sin,
      ...scene.asteroids.map((_, i) => asteroids[2 * i] * cos + asteroids[2 * i + 1] * sin),
    ]);
    aside = Math.max(aside, Math.abs(state[1] * cos - state[0] * sin));
  }
  return { run, aside };
}

/** The number of ticks for which all runs stay within `px` of the first. */
function together(px: number, [first, ...others]: readonly LineRun[]): number {
  const apart = first.findIndex((row, tick) =>
    others.some((other) => tick >= other.length || row.some((v, i) => !(Math.abs(v - other[tick][i]) <= px))),
  );
  return apart < 0 ? first.length : apart;
}

describe('everything on one line', () => {
  it.each([
    ['precise', 1e-6],
    ['standard', 1e-2],
  ] as const)('goes as one dimension has it: %s, within %d px', (accuracy, px) => {
    let ticks = 0;
    fc.assert(
      fc.property(lineScene, button, fc.constantFrom(...DIRECTIONS), (scene, parts, direction) => {
        const held = heldBy(parts);
        const truth = moveOnLine(scene, TICKS, held);
        // where a start that is moved by a billionth of a pixel leads elsewhere, the truth depends on the last digits
        const moved = [-1e-9, 1e-9].map((by) => moveOnLine({ ...scene, start: scene.start + by }, TICKS, held));
        const known = together(1e-7, [truth, ...moved]);
        const { run, aside } = play(scene, direction, held, accuracy);
        expect(together(px, [truth.slice(0, known), run])).toBe(known);
        expect(aside).toBeLessThan(1e-12);
        ticks += known;
      }),
      { numRuns: RUNS },
    );
    // for most runs, the truth is known most of the time
    expectDeep(ticks).toBeGreaterThan(RUNS * 100);
  });

  it('moves like its neighbours, 1e-7 px beside it', () => {
    let ticks = 0;
    fc.assert(
      fc.property(lineScene, button, (scene, parts) => {
        // at rest exactly in the centre of a field: the neighbours are pushed out of it
        fc.pre(!scene.fields.some(({ at }) => at === scene.start));
        const held = heldBy(parts);
        const beside = (by: number) => play(scene, DIRECTIONS[0], held, 'precise', by).run;
        const [left, ...others] = [1e-7, -1e-7, 2e-7, 5e-8].map(beside);
        // as long as the neighbours agree
        const known = together(1e-4, [left, ...others]);
        expect(together(1e-3, [left.slice(0, known), beside(0)])).toBe(known);
        ticks += known;
      }),
      { numRuns: RUNS },
    );
    expectDeep(ticks).toBeGreaterThan(RUNS * 100);
  });
});

describe.each(continuousNames)('an asteroid that is dragged through her: %s', (accuracy) => {
  const rockAt = (parts: Parameters<typeof plainLevel>[0], seconds: number) => {
    const simulation = createSimulation(compile(plainLevel({ range: 400, recoil: true, ...parts }), accuracy));
    simulation.advance(60 * seconds, true);
    const places = new Float64Array(2);
    simulation.readAsteroids(places);
    return { places, pieces: simulation.work.pieces };
  };

  it('swings around her while she rests in the centre of a field', () => {
    // 1 / diameter = 0.625 px/s2 from 45 px away: a quarter of a swing lasts 12 s
    const at = { x: 27, y: 36 };
    for (const [seconds, way] of [
      [12, 0],
      [24, -45],
      [48, 45],
    ]) {
      const { places } = rockAt({ asteroids: [{ ...at, radius: 0.8 }], repulsors: [{ x: 0, y: 0, radius: 300 }] }, seconds);
      expect(places[0]).toBeCloseTo(0.6 * way, 8);
      expect(places[1]).toBeCloseTo(0.8 * way, 8);
    }
  });

  it('stays in her centre if it can follow her', () => {
    // 25 px/s2 against 20: it starts with her and never leaves her
    const parts = { asteroids: [{ x: 0, y: 0, radius: 0.02 }], repulsors: [{ x: -30, y: 0, radius: 300 }] };
    const { places, pieces } = rockAt(parts, 2);
    expect(places[0]).toBeCloseTo(40, 9);
    expect(places[1]).toBe(0);
    expect(pieces).toBeLessThan(200);
  });
});
