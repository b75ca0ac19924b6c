import { describe, expect, it } from 'vitest';
import { type Proof, verifyProof } from '../../../solver/index.ts';
import { apart, isIndex, less } from '../../../solver/verify/geometry.ts';
import { at, levelWith, proofWith, spot } from './near-miss.ts';

const level = levelWith({ minerals: [spot(4000, 0)], novae: [at(5, 0)] });
const nothing = { kind: 'nothing-in-range' } as const;
const with_ = (more: object, of = level) => {
  const verdict = verifyProof(of, { ...proofWith(nothing), ...more } as Proof);
  return verdict.ok ? null : verdict.why;
};

describe('the statements of a proof about itself', () => {
  it('is about the black hole, or a mineral of the level', () => {
    const absent = 'it is about an object that the level does not have';
    expect(with_({})).toBeNull();
    expect(with_({ about: { kind: 'mineral', index: 0 } })).toBeNull();
    const none = [
      undefined,
      null,
      {},
      { kind: 'nova', index: 0 },
      { kind: 'mineral' },
      { kind: 'mineral', index: 1 },
      { kind: 'mineral', index: '0' },
    ];
    for (const about of none) expect(with_({ about }), JSON.stringify(about)).toBe(absent);
  });

  it('covers existing accuracies, one at least', () => {
    const none = 'it does not say which accuracies it covers';
    for (const covers of [['precise'], ['arcade', 'fast']]) expect(with_({ covers })).toBeNull();
    for (const covers of [
      undefined,
      null,
      'precise',
      [],
      ['exact'],
      ['precise', 'exact'],
      ['precise', 1],
      [['precise']],
      { length: 1, every: null },
    ])
      expect(with_({ covers }), JSON.stringify(covers)).toBe(none);
  });

  it('holds for a length of time, or for any', () => {
    for (const maxTime of [1e-9, 0.5, 60, null]) expect(with_({ maxTime })).toBeNull();
    for (const maxTime of [0, -1, Number.NaN, '60', [60], undefined, {}])
      expect(with_({ maxTime })).toBe('its longest run is not a length of time');
  });

  it('needs no time, with recoil, where the start alone decides', () => {
    const dragged = { ...level, recoil: true };
    expect(with_({ maxTime: null }, dragged)).toBeNull();
    const hazard = { kind: 'starts-in-hazard', hazard: { kind: 'nova', index: 0 } } as const;
    expect(with_({ maxTime: null, code: hazard.kind, certificate: hazard }, dragged)).toBeNull();
    const far = { kind: 'out-of-range', asteroids: [] } as const;
    const needs = 'with recoil it must say how long a run may last';
    expect(with_({ maxTime: null, code: far.kind, certificate: far }, dragged)).toBe(needs);
    for (const certificate of [undefined, null, {}]) expect(with_({ maxTime: null, certificate }, dragged)).toBe(needs);
  });

  it('has a certificate of its own kind, which is known', () => {
    const other = 'its certificate is of another kind';
    expect(with_({ code: 'covered' })).toBe(other);
    for (const certificate of [undefined, null, {}, { kind: 'covered' }]) expect(with_({ certificate })).toBe(other);
    expect(with_({ code: 'magic', certificate: { kind: 'magic' } })).toBe('its kind is unknown');
  });
});

describe('comparisons that rounding cannot falsify', () => {
  it('require 1e-7 px plus 1e-10 of both lengths', () => {
    expect(less(0, 0.99e-7)).toBe(false);
    expect(less(0, 1.01e-7)).toBe(true);
    for (const [a, b] of [
      [1e6, 1e6],
      [-1e6, -1e6],
    ]) {
      const margin = 1e-7 + 2e-4;
      expect(less(a, b + 0.999 * margin)).toBe(false);
      expect(less(a, b + 1.001 * margin)).toBe(true);
    }
    for (const [a, b] of [
      [0, 1e6],
      [-1e6, 0],
    ])
      expect(less(a, b)).toBe(true);
    const none: readonly (readonly [number, number])[] = [
      [Number.NaN, 1],
      [1, Number.NaN],
      [1, Number.NEGATIVE_INFINITY],
    ];
    for (const [a, b] of none) expect(less(a, b)).toBe(false);
  });

  it('distances and indices', () => {
    expect(apart({ x: 1, y: 2 }, { x: 4, y: -2 })).toBe(5);
    expect([0, 1, 2, -1, 0.5, Number.NaN, '0', null, undefined].map((value) => isIndex(value, ['a', 'b']))).toEqual([
      true,
      true,
      false,
      false,
      false,
      false,
      false,
      false,
      false,
    ]);
  });
});
