import { describe, expect, it } from 'vitest';
import { compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import { DEFAULT_RULES, type Hold } from '../../schema/index.ts';
import { continuousNames } from '../engine/accuracies.ts';
import { type PlainLevel, plainLevel } from '../engine/plain-level.ts';
import { checkPieces, dearestSecond } from '../judges/pieces.ts';
import { propertySettings } from '../property-settings.ts';
import { degenerateScene } from '../scenes/degenerate-scene.ts';

const HELD: Hold[] = [[0, 3600]];

interface Dear {
  readonly name: string;
  readonly parts: PlainLevel;
  readonly holds: readonly Hold[];
  /** The pieces of the most expensive second: at `precise`, and with fixed steps. */
  readonly most: readonly [precise: number, steps: number];
}

const rim = (name: string, repulsors: PlainLevel['repulsors'], parts: PlainLevel = {}): Dear => ({
  name,
  parts: { range: 250, astronaut: { x: -50 }, asteroids: [{ x: 62, y: 0.25, radius: 16 }], repulsors, ...parts },
  holds: HELD,
  most: [150, 400],
});

const field = { x: 0, y: 0, radius: 50 };

const CASES: readonly Dear[] = [
  rim('on a rim', [field]),
  rim('on two equal rims', [field, { ...field }]),
  ...[1e-14, 1e-13, 1e-12, 1e-11, 1e-9, 1e-6].flatMap((apart) => [
    rim(`on rims ${apart} px apart`, [field, { ...field, x: apart }]),
    rim(`on a rim ${apart} px within another`, [{ ...field, radius: 50 - apart }, field]),
  ]),
  rim('where a smaller field touches from within', [field, { x: -10, y: 0, radius: 40 }]),
  rim('where it touches from within and comes first', [{ x: -10, y: 0, radius: 40 }, field]),
  rim('where another touches from without', [field, { x: -100, y: 0, radius: 50 }]),
  rim('between two fields that overlap', [field, { x: -80, y: 30, radius: 50 }]),
  {
    ...rim('in the corner of two fields', [
      { x: -50, y: 50, radius: 50 },
      { x: 0, y: 0, radius: 50 },
    ]),
    most: [4000, 4000],
  },
  {
    name: 'in a tiny orbit that drags a tiny asteroid',
    parts: {
      range: 250,
      recoil: true,
      astronaut: { x: 3e-7, vy: 0.0127 },
      asteroids: [{ x: 0, y: 0, radius: 0.001 }],
    },
    holds: HELD,
    most: [500, 4000],
  },
  {
    name: 'in a tiny orbit',
    parts: { range: 250, astronaut: { x: 2e-7, y: 1e-7, vx: 0.0005, vy: 0.001 }, asteroids: [{ x: 0, y: 0, radius: 16 }] },
    holds: HELD,
    most: [500, 4000],
  },
  {
    name: 'in a tiny swing that drags a tiny asteroid',
    parts: { range: 250, recoil: true, astronaut: { x: 6e-7, y: 8e-7 }, asteroids: [{ x: 0, y: 0, radius: 0.001 }] },
    holds: HELD,
    most: [500, 1000],
  },
];

describe.each(continuousNames)('pieces per second: %s', (accuracy) => {
  it.each(CASES)('$name', ({ parts, holds, most }) => {
    const bound = most[accuracy === 'precise' ? 0 : 1];
    expect(dearestSecond(compile(plainLevel(parts), accuracy), holds, 3, 20_000).pieces).toBeLessThan(bound);
  });
});

it('random degenerate scenes take bounded work (the soak tests more of them)', () => {
  const found = Array.from({ length: 10 * propertySettings(process.env).runs }, (_, seed) =>
    checkPieces(degenerateScene(seed)).filter((f) => f.kind === 'bug'),
  ).flat();
  expect(found).toEqual([]);
});

/** A circle around an asteroid that recoils: the two move evenly as a whole, and she circles. */
describe.each([
  [2e-7, 0.001, 1e-10],
  [5e-6, 0.001, 1e-10],
  [1e-4, 0.01, 1e-9],
])('a circle of %d px about a drawn asteroid of radius %d', (size, radius, within) => {
  it('has its exact size and place, orbit after orbit', () => {
    const kappa = 1 / (2 * radius);
    const pull = DEFAULT_RULES.pull * (1 - size / 250) + kappa;
    const rate = Math.sqrt(pull / size);
    const speed = size * rate;
    const level = plainLevel({
      range: 250,
      recoil: true,
      astronaut: { x: size, y: 0, vy: speed },
      asteroids: [{ x: 0, y: 0, radius }],
    });
    const run = simulate(compile(level, 'precise'), HELD, { maxTime: 2 });
    const state = new Float64Array(STATE_SIZE);
    for (const tick of [1, 2, 30, 60, 119, 120]) {
      const time = tick / 60;
      run.trajectory.at(time, state);
      const [c, s] = [Math.cos(rate * time), Math.sin(rate * time)];
      const drawn = kappa / pull;
      // the asteroid circles opposite to her, and keeps its mean velocity
      const x = size * c - drawn * size * (c - 1);
      const y = size * s - drawn * size * s + drawn * speed * time;
      expect(Math.hypot(state[0] - x, state[1] - y)).toBeLessThan(within);
    }
  });
});
