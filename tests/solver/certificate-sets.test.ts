import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { type Doomed, type Proof, proveBy, verifyProof } from '../../solver/index.ts';
import { at, LEVELS, level } from './impossible-levels.ts';

// Certificates that carry their sets come from whoever likes: a set that is missing, smaller than it was, or in another's place is noticed, or it was not needed.

const HOLE = { kind: 'blackHole' } as const;
const DOOMED: Readonly<Record<string, Level>> = {
  'with recoil': LEVELS.doomed,
  'a field and two asteroids': level({
    astronaut: { x: 0, y: 0, vx: -50, vy: 10 },
    asteroids: [at(100, 60), at(90, -70)],
    novae: [at(-70, 0, 40), at(-60, 70, 32), at(-60, -60, 32)],
    repulsors: [at(-30, 40, 20)],
    blackHole: { x: 300, y: 300 },
  }),
  'out of range': level({ astronaut: { x: 0, y: 0, vx: -60 }, asteroids: [at(200, 0)], blackHole: { x: 900, y: 0 } }),
};

type Layers = Doomed['layers'];
type Mutation = (layers: Layers) => Layers;
const withLayer = (layers: Layers, n: number, change: (boxes: Layers[number]) => Layers[number]): Layers =>
  layers.map((boxes, i) => (i === n ? change(boxes) : boxes));
const withBound = (layers: Layers, n: number, k: number, i: number, change: (bound: number) => number): Layers =>
  withLayer(layers, n, (boxes) => boxes.map((box, j) => (j === k ? box.map((b, at) => (at === i ? change(b) : b)) : box)));
const inward = (i: number, by: number) => (bound: number) => (i % 2 === 0 ? bound + by : bound - by);

/** A double next to another. */
function nextDouble(value: number, up: boolean): number {
  const double = new Float64Array([value]);
  const bits = new BigInt64Array(double.buffer);
  bits[0] += up === value > 0 ? 1n : -1n;
  return double[0];
}

/** Some change that makes sets fewer or smaller, or puts them elsewhere. */
const mutationOf = (layers: Layers): fc.Arbitrary<Mutation> => {
  const place = fc.nat(layers.length - 1).chain((n) => fc.tuple(fc.constant(n), fc.nat(layers[n].length - 1)));
  const bound = fc.nat(7);
  return fc.oneof(
    place.map(
      ([n, k]): Mutation =>
        (of) =>
          withLayer(of, n, (boxes) => boxes.filter((_, j) => j !== k)),
    ),
    fc.nat(layers.length - 1).map(
      (n): Mutation =>
        (of) =>
          of.filter((_, i) => i !== n),
    ),
    fc.nat(layers.length - 1).map(
      (n): Mutation =>
        (of) =>
          of.slice(0, n),
    ),
    fc.tuple(place, bound).map(
      ([[n, k], i]): Mutation =>
        (of) =>
          withBound(of, n, k, i, (b) => nextDouble(b, i % 2 === 0)),
    ),
    fc.tuple(place, bound, fc.constantFrom(1e-9, 1e-6, 1e-3, 0.1, 1, 10)).map(
      ([[n, k], i, by]): Mutation =>
        (of) =>
          withBound(of, n, k, i, inward(i, by)),
    ),
    fc.tuple(place, place).map(
      ([[n, k], [m, l]]): Mutation =>
        (of) => {
          const [a, b] = [of[n]?.[k], of[m]?.[l]];
          if (a === undefined || b === undefined) return of;
          const without = withLayer(of, n, (boxes) => boxes.map((box, j) => (j === k ? b : box)));
          return withLayer(without, m, (boxes) => boxes.map((box, j) => (j === l ? a : box)));
        },
    ),
    fc.tuple(fc.nat(layers.length - 1), fc.nat(layers.length - 1)).map(
      ([n, m]): Mutation =>
        (of) =>
          of.map((boxes, i) => (i === n ? of[m] : i === m ? of[n] : boxes) ?? []),
    ),
  );
};

describe.each(Object.keys(DOOMED))('the sets of doomed: %s', (name) => {
  const of = DOOMED[name];
  const proof = proveBy('doomed', of, HOLE) as Proof;
  const certificate = proof.certificate as Doomed;
  const { layers } = certificate;
  const accepts = (level: Level, changed: Layers) =>
    verifyProof(level, { ...proof, certificate: { ...certificate, layers: changed } }).ok;
  const everyBox = layers.flatMap((boxes, n) => boxes.map((_, k) => [n, k] as const));

  it('hold all that she may do', () => {
    expect(accepts(of, layers)).toBe(true);
    expect(everyBox.length).toBeGreaterThan(10);
  });

  it('a set that is left out is missed', () => {
    const missed = everyBox.filter(
      ([n, k]) =>
        !accepts(
          of,
          withLayer(layers, n, (boxes) => boxes.filter((_, j) => j !== k)),
        ),
    );
    // where bounds of the prover are a little wider a box may hold only what is over already
    expect(missed.length).toBeGreaterThan(0.95 * everyBox.length);
  });

  it('a layer that is left out, or in another’s place, is missed', () => {
    for (const n of layers.keys()) {
      expect(
        accepts(
          of,
          layers.filter((_, i) => i !== n),
        ),
      ).toBe(false);
      expect(accepts(of, layers.slice(0, n))).toBe(false);
    }
    expect(accepts(of, [...layers].reverse())).toBe(false);
  });

  it('a bound that moves inward by more than rounding is missed', () => {
    let refused = 0;
    let tried = 0;
    for (const [n, k] of everyBox) {
      for (let i = 0; i < 8; i++) {
        const box = layers[n][k];
        const width = box[i | 1] - box[i & 6];
        if (width < 0.01) continue;
        tried++;
        if (!accepts(of, withBound(layers, n, k, i, inward(i, Math.min(width / 2, 0.01))))) refused++;
      }
    }
    expect(tried).toBeGreaterThan(30);
    expect(refused).toBeGreaterThan(0.8 * tried);
  });

  it('a false claim stays refused whatever becomes of them', () => {
    const ways: readonly (readonly Hold[])[] = [
      [],
      [[0, 600]],
      [[6, 20]],
      [
        [0, 9],
        [15, 60],
      ],
    ];
    const falseLevels = ways.flatMap((holds) => {
      const { time, trajectory } = simulate(compile(of), holds);
      const state = new Float64Array(STATE_SIZE);
      return [0.3, 0.6, 0.9].map((share) => {
        trajectory.at(share * time, state);
        return { ...of, blackHole: { ...of.blackHole, x: state[0], y: state[1] } };
      });
    });
    const areFalse = falseLevels.filter((level) => ways.some((holds) => simulate(compile(level), holds).outcome === 'completed'));
    expect(areFalse.length).toBeGreaterThan(3);
    for (const level of areFalse) expect(accepts(level, layers)).toBe(false);
    fc.assert(
      fc.property(
        fc.constantFrom(...areFalse),
        fc.array(mutationOf(layers), { minLength: 1, maxLength: 4 }),
        (level, changes) => {
          expect(
            accepts(
              level,
              changes.reduce<Layers>((now, change) => change(now), layers),
            ),
          ).toBe(false);
        },
      ),
      { numRuns: 300 },
    );
  });
});
