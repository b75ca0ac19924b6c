import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { type Doomed, type Flowpipe, type Proof, proveBy, verifyProof } from '../../solver/index.ts';
import { itQuick } from '../depth.ts';
import { at, LEVELS, level } from './impossible-levels.ts';

// Certificates with sets may come from anybody: a set that is missing, smaller than before or moved is noticed, unless it was
// not needed.

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

/** The next double, up or down. */
function nextDouble(value: number, up: boolean): number {
  const double = new Float64Array([value]);
  const bits = new BigInt64Array(double.buffer);
  bits[0] += up === value > 0 ? 1n : -1n;
  return double[0];
}

/** A change that removes sets, shrinks them or moves them. */
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

const WAYS: readonly (readonly Hold[])[] = [
  [],
  [[0, 600]],
  [[6, 20]],
  [
    [0, 9],
    [15, 60],
  ],
];

/** The level with its black hole moved to where some run passes, so that the claim is false. */
function falseClaims(of: Level): Level[] {
  const levels = WAYS.flatMap((holds) => {
    const { time, trajectory } = simulate(compile(of), holds);
    const state = new Float64Array(STATE_SIZE);
    return [0.3, 0.6, 0.9].map((share) => {
      trajectory.at(share * time, state);
      return { ...of, blackHole: { ...of.blackHole, x: state[0], y: state[1] } };
    });
  });
  const areFalse = levels.filter((level) => WAYS.some((holds) => simulate(compile(level), holds).outcome === 'completed'));
  expect(areFalse.length).toBeGreaterThan(3);
  return areFalse;
}

describe.each(Object.keys(DOOMED))('the sets of doomed: %s', (name) => {
  const of = DOOMED[name];
  const proof = proveBy('doomed', of, HOLE) as Proof;
  const certificate = proof.certificate as Doomed;
  const { layers } = certificate;
  const accepts = (level: Level, changed: Layers) =>
    verifyProof(level, { ...proof, certificate: { ...certificate, layers: changed } }).ok;
  const everyBox = layers.flatMap((boxes, n) => boxes.map((_, k) => [n, k] as const));

  it('contain everything that she may do', () => {
    expect(accepts(of, layers)).toBe(true);
    expect(everyBox.length).toBeGreaterThan(10);
  });

  it('a missing set is noticed', () => {
    const missed = everyBox.filter(
      ([n, k]) =>
        !accepts(
          of,
          withLayer(layers, n, (boxes) => boxes.filter((_, j) => j !== k)),
        ),
    );
    // Where the bounds of the prover are slightly wider, a box may contain only what has ended.
    expect(missed.length).toBeGreaterThan(0.95 * everyBox.length);
  });

  it('a missing or misplaced layer is noticed', () => {
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

  it('a bound moved inwards by more than rounding is noticed', () => {
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

  it('a false claim stays refused whatever happens to the sets', () => {
    const areFalse = falseClaims(of);
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

const PIPES: Record<string, Level> = {
  'an alien ahead': LEVELS.flowpipe,
  'novae and a field': level({
    astronaut: { x: 0, y: 0, vx: -60, vy: 10 },
    asteroids: [at(100, 60), at(90, -70)],
    novae: [at(-70, 0, 30), at(-60, 60, 30), at(-60, -60, 30)],
    repulsors: [at(-30, 40, 20)],
    blackHole: { x: 300, y: 300 },
  }),
};

// Hot asteroids drift, so only a part of them certainly ends a run.
PIPES['hot asteroids with recoil'] = level({
  astronaut: { x: 0, y: 0, vx: -60, vy: 10 },
  asteroids: [at(100, 60), at(90, -70), { ...at(-70, 0, 30), hot: true }, { ...at(-60, 60, 30), hot: true }],
  novae: [at(-60, -60, 30)],
  blackHole: { x: 300, y: 300 },
  recoil: true,
});

type Steps = Flowpipe['layers'];
type Part = Steps[number][number][number]['parts'][number];

/** The hints with each part changed by `change`, which also receives the number of parts before it. */
function withParts(layers: Steps, change: (part: Part, index: number) => Part): Steps {
  let index = 0;
  return layers.map((sets) =>
    sets.map(([pressed, free]) => {
      const changed = (one: typeof pressed) => ({ ...one, parts: one.parts.map((part) => change(part, index++)) });
      return [changed(pressed), changed(free)] as const;
    }),
  );
}

describe.each(Object.keys(PIPES))('the hints of flowpipe: %s', (name) => {
  const of = PIPES[name];
  const proof = proveBy('flowpipe', of, HOLE) as Proof;
  const certificate = proof.certificate as Flowpipe;
  const { layers } = certificate;
  const accepts = (level: Level, changed: Steps) =>
    verifyProof(level, { ...proof, certificate: { ...certificate, layers: changed } }).ok;
  const parts = layers.flatMap((sets) => sets.flatMap((steps) => steps.flatMap((step) => step.parts)));
  const withPart = (n: number, change: (part: Part) => Part) => (of: Steps) =>
    withParts(of, (part, i) => (i === n ? change(part) : part));
  const withStrip = (n: number, k: number, change: (at: number) => number) =>
    withPart(n, (part) => ({ ...part, off: part.off.map((strip, i) => (i === k ? { ...strip, at: change(strip.at) } : strip)) }));
  const strips = parts.flatMap(({ off }, n) => off.map((_, k) => [n, k] as const));

  it('hold', () => {
    expect(accepts(of, layers)).toBe(true);
    expect(parts.length).toBeGreaterThan(10);
    expect(strips.length).toBeGreaterThan(5);
  });

  it('a strip that takes more than the hazard does is noticed', () => {
    // This does not apply to a part that has ended entirely, nor to a strip that contains nothing of the set.
    const taken = strips.filter(([n, k]) => parts[n].to !== null && k === parts[n].off.length - 1);
    expect(taken.length).toBeGreaterThan(0);
    const noticed = taken.filter(([n, k]) => !accepts(of, withStrip(n, k, (at) => at - 2)(layers)));
    expect(noticed.length).toBeGreaterThan(0.8 * taken.length);
  });

  it('a strip that is missing, or names another hazard, is noticed', () => {
    const ends = strips.filter(([n, k]) => parts[n].to === null && k === parts[n].off.length - 1);
    const missed = ends.filter(([n]) => !accepts(of, withPart(n, (part) => ({ ...part, off: part.off.slice(0, -1) }))(layers)));
    expect(missed.length).toBeGreaterThan(0.9 * ends.length);
    for (const by of [{ kind: 'nova', index: 99 }, { kind: 'alien', index: 99 }, { kind: 'asteroid', index: 0 }, HOLE, null]) {
      const other = withParts(layers, (part) => ({ ...part, off: part.off.map((strip) => ({ ...strip, by }) as never) }));
      expect(accepts(of, other)).toBe(false);
    }
  });

  itQuick('a part that goes on has not ended because the certificate says so', () => {
    const goOn = parts.flatMap(({ to }, n) => (to === null ? [] : [n]));
    const accepted = goOn.filter((n) => accepts(of, withPart(n, (part) => ({ ...part, to: null }))(layers)));
    // Slightly more may be empty or out of range for the checker than for the prover.
    expect(accepted.length).toBeLessThan(0.05 * goOn.length);
  });

  it('all sides of a cut must be accounted for', () => {
    const [[[pressed, free]], ...rest] = layers;
    expect(pressed.cuts.flat()).toEqual([]);
    const nothing: Part = { off: [], to: null };
    for (const line of [-9000, 9000]) {
      for (let axis = 0; axis < 4; axis++) {
        const cuts = [0, 1, 2, 3].map((n) => (n === axis ? [line] : []));
        const asIs = line < 0 ? [nothing, ...pressed.parts] : [...pressed.parts, nothing];
        const acceptsFirst = (parts: Part[]) => accepts(of, [[[{ cuts, parts }, free]], ...rest]);
        expect(acceptsFirst(asIs)).toBe(true);
        expect(acceptsFirst([...asIs].reverse())).toBe(false);
        expect(acceptsFirst([nothing, nothing])).toBe(false);
      }
    }
  });

  it('sets that go on need steps', () => {
    for (const n of layers.keys()) expect(accepts(of, layers.slice(0, n))).toBe(false);
    for (const [n, sets] of layers.entries()) {
      for (const k of sets.keys())
        expect(
          accepts(
            of,
            layers.map((one, i) => (i === n ? one.toSpliced(k, 1, undefined as never) : one)),
          ),
        ).toBe(false);
    }
  });

  it('a malformed step is refused', () => {
    const none: unknown[] = [undefined, null, 0, 'all', [], {}, { cuts: [], parts: [] }, { cuts: [[], [], [], []] }];
    const [[[pressed, free]], ...rest] = layers;
    const withFirst = (step: unknown) => accepts(of, [[[step, free] as never], ...rest]);
    expect(withFirst(pressed)).toBe(true);
    for (const step of none) expect(withFirst(step), JSON.stringify(step)).toBe(false);
    for (const more of [{ cuts: [[], [], []] }, { cuts: [[0], [], [], []] }, { cuts: [[Number.NaN], [], [], []] }, { parts: [] }])
      expect(withFirst({ ...pressed, ...more }), JSON.stringify(more)).toBe(false);
    const [part] = pressed.parts;
    const strip = { by: { kind: 'nova', index: 0 }, side: 0, at: 1e9 };
    for (const wrong of [{ to: -1 }, { to: 0.5 }, { to: '0' }, { off: null }, { off: [null] }, { off: [{ ...strip, side: 8 }] }])
      expect(withFirst({ ...pressed, parts: [{ ...part, ...wrong }] }), JSON.stringify(wrong)).toBe(false);
    for (const at of [Number.NaN, 1 / 0, -1 / 0, 1e10, '0', null])
      expect(withFirst({ ...pressed, parts: [{ ...part, off: [{ ...strip, at }] }] }), `${at}`).toBe(false);
    for (const layers of [undefined, null, {}, 'all', [null], [[null]]]) expect(accepts(of, layers as never)).toBe(false);
  });

  it('a false claim stays refused whatever the hints say', () => {
    const areFalse = falseClaims(of);
    for (const level of areFalse) expect(accepts(level, layers)).toBe(false);
    const nth = fc.nat(parts.length - 1);
    const by = fc.constantFrom(-1e3, -10, -1, -1e-3, -1e-9, 1e-9, 1e-3, 1, 10, 1e3);
    const mutation = fc.oneof(
      fc.tuple(fc.constantFrom(...strips), by).map(([[n, k], off]) => withStrip(n, k, (at) => at + off)),
      fc.constantFrom(...strips).map(([n, k]) => withStrip(n, k, (at) => nextDouble(at, false))),
      nth.map((n) => withPart(n, (part) => ({ ...part, to: null }))),
      nth.map((n) => withPart(n, (part) => ({ ...part, off: part.off.slice(1) }))),
      fc.tuple(nth, nth).map(([n, m]) => withPart(n, () => parts[m])),
      fc.tuple(nth, fc.nat(20)).map(([n, to]) => withPart(n, (part) => ({ ...part, to }))),
      fc.tuple(fc.nat(layers.length - 1), fc.nat(layers.length - 1)).map(
        ([n, m]) =>
          (of: Steps) =>
            of.map((sets, i) => (i === n ? of[m] : i === m ? of[n] : sets) ?? []),
      ),
      fc.nat(layers.length - 1).map((n) => (of: Steps) => of.filter((_, i) => i !== n)),
      fc.constant((of: Steps): Steps => of.map((sets) => sets.map(([pressed, free]) => [free, pressed]))),
      by.map(
        (off) => (of: Steps) =>
          of.map((sets) =>
            sets.map(([a, b]) => {
              const moved = (step: typeof a) => ({ ...step, cuts: step.cuts.map((lines) => lines.map((line) => line + off)) });
              return [moved(a), moved(b)] as const;
            }),
          ),
      ),
    );
    fc.assert(
      fc.property(fc.constantFrom(...areFalse), fc.array(mutation, { minLength: 1, maxLength: 4 }), (level, changes) => {
        expect(
          accepts(
            level,
            changes.reduce<Steps>((now, change) => change(now), layers),
          ),
        ).toBe(false);
      }),
      { numRuns: 300 },
    );
  });
});
