import { describe, expect, it } from 'vitest';
import { ACCURACIES, type AccuracyName, compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { type About, type Proof, proveBy, proveImpossible, verifyProof } from '../../solver/index.ts';
import type { Prover } from '../../solver/prove/proof.ts';
import { isDeep } from '../depth.ts';
import { at, LEVELS, level } from './impossible-levels.ts';

// Proofs keep clear of winds and wormholes or follow them; where one of them makes a level completable, there is no proof.

const HOLE: About = { kind: 'blackHole' };
const accuracyNames = Object.keys(ACCURACIES) as AccuracyName[];

/** The levels; that of `orbits`, which takes a second to prove, in the deep set alone. */
const NAMES = Object.keys(LEVELS).filter((name) => isDeep || name !== 'orbits');

const wind = (x: number, y: number, radius: number, ax: number, ay: number) => ({ id: null, x, y, radius, ax, ay });
const wormhole = (x: number, y: number, toX: number, toY: number, radius: number) => ({ id: null, x, y, toX, toY, radius });
const AFAR = { winds: [wind(-4000, 900, 60, 20, 30)], wormholes: [wormhole(-4000, 0, -4000, 500, 30)] };

describe('winds and wormholes that she never comes near change nothing', () => {
  it.each(NAMES)('%s', (name) => {
    const of: Level = { ...LEVELS[name], ...AFAR };
    const before = proveImpossible(LEVELS[name]) as Proof;
    const proof = proveImpossible(of) as Proof;
    // With wormholes a frame may be as long as the speed limit allows.
    expect(proof.code).toBe(before.code);
    expect(verifyProof(of, proof)).toEqual({ ok: true });
  });
});

const WAYS: readonly (readonly Hold[])[] = [[], [[0, 600]], [[6, 20]], [[0, 30]]];

/** The level with a wormhole from a place on a run to where her box overlaps the black hole, and that run. */
function shortCuts(of: Level, accuracy: AccuracyName): { level: Level; holds: readonly Hold[] }[] {
  return WAYS.flatMap((holds) => {
    const { time, trajectory } = simulate(compile(of, accuracy), holds);
    const state = new Float64Array(STATE_SIZE);
    return [0.4, 0.7, 0.9].flatMap((share) => {
      trajectory.at(share * time, state);
      const { x, y } = of.blackHole;
      const short = { ...of, wormholes: [wormhole(state[0], state[1], x, y, 6)] };
      return simulate(compile(short, accuracy), holds).outcome === 'completed' ? [{ level: short, holds }] : [];
    });
  });
}

describe.each(NAMES.filter((name) => !['nothing-in-range', 'starts-in-hazard', 'covered'].includes(name)))(
  'a wormhole to the black hole: %s',
  (name) => {
    it.each(accuracyNames)('%s: there is no proof, and the old one is refused', (accuracy) => {
      const old = proveImpossible(LEVELS[name], { accuracy });
      const cuts = shortCuts(LEVELS[name], accuracy);
      expect(cuts.length).toBeGreaterThan(0);
      for (const { level: short } of cuts) {
        expect(proveImpossible(short, { accuracy })).toBeNull();
        if (old === null) continue;
        expect(verifyProof(short, old).ok).toBe(false);
        // Listing mouths, or none, does not help either.
        if (old.certificate.kind !== 'out-of-range') continue;
        for (const mouths of [[], [0], [1], [0, 1]])
          expect(verifyProof(short, { ...old, certificate: { ...old.certificate, mouths } }).ok).toBe(false);
      }
    });
  },
);

describe('wormholes that proofs follow', () => {
  const island = level({ blackHole: { x: 2000, y: 0 }, asteroids: [at(150, 0), at(1000, 400)] });
  const toIsland: Level = { ...island, wormholes: [wormhole(250, 0, 1000, 200, 30)] };

  it('out-of-range: to other asteroids that are just as far away', () => {
    const proof = proveBy('out-of-range', toIsland, HOLE) as Proof;
    expect(proof.certificate).toEqual({ kind: 'out-of-range', asteroids: [0, 1], mouths: [0, 1] });
    expect(verifyProof(toIsland, proof)).toEqual({ ok: true });
    const without = (certificate: object) => verifyProof(toIsland, { ...proof, certificate: certificate as never });
    expect(without({ kind: 'out-of-range', asteroids: [0], mouths: [0, 1] })).toMatchObject({ ok: false });
    expect(without({ kind: 'out-of-range', asteroids: [0, 1] })).toMatchObject({ ok: false });
    expect(without({ kind: 'out-of-range', asteroids: [0], mouths: [] })).toMatchObject({ ok: false });
    for (const mouths of [[2], [-1], [0.5], 'all', null, {}]) {
      expect(without({ kind: 'out-of-range', asteroids: [0, 1], mouths }).ok).toBe(false);
    }
  });

  it('out-of-range: a mouth that she cannot reach is not listed', () => {
    const of: Level = { ...island, wormholes: [wormhole(250, 900, 2000, 0, 30)] };
    const proof = proveBy('out-of-range', of, HOLE) as Proof;
    expect(proof.certificate).toEqual({ kind: 'out-of-range', asteroids: [0], mouths: [] });
    expect(verifyProof(of, proof)).toEqual({ ok: true });
    // From where another mouth takes her, it is near.
    const chain: Level = { ...of, wormholes: [...of.wormholes, wormhole(250, 0, 250, 860, 30)] };
    expect(proveBy('out-of-range', chain, HOLE)).toBeNull();
    expect(verifyProof(chain, proof).ok).toBe(false);
  });

  it('enclosed: with both mouths on her side, and not across the barrier', () => {
    const inside: Level = { ...LEVELS.enclosed, wormholes: [wormhole(60, 60, 100, -120, 20)] };
    const proof = proveBy('enclosed', inside, HOLE) as Proof;
    expect(verifyProof(inside, proof)).toEqual({ ok: true });
    const across: Level = { ...LEVELS.enclosed, wormholes: [wormhole(60, 60, 300, 20, 20)] };
    expect(proveBy('enclosed', across, HOLE)).toBeNull();
    expect(verifyProof(across, proof)).toEqual({ ok: false, why: 'a wormhole leads through the barrier' });
    const on: Level = { ...LEVELS.enclosed, wormholes: [wormhole(60, 60, 235, 0, 20)] };
    expect(verifyProof(on, proof).ok).toBe(false);
  });

  describe('enclosed: through a wormhole into a ring of novae', () => {
    const ring = (x: number, y: number, radius: number) =>
      Array.from({ length: 40 }, (_, i) => ({
        id: null,
        ...at(x + radius * Math.cos((i * Math.PI) / 20), y + radius * Math.sin((i * Math.PI) / 20), 16),
      }));
    const vault = (exit: number, inner: number): Level => ({
      ...level({ blackHole: { x: 500, y: 0 }, asteroids: [at(100, 0), at(400, 0)], range: 400 }),
      novae: [...ring(500, 0, 200), ...ring(500, 0, inner).filter((_, i) => i % 2 === 0)],
      wormholes: [wormhole(60, 60, exit, 0, 20)],
    });

    it('the black hole in a smaller ring is out of reach, however near the mouth is to that', () => {
      for (const exit of [400, 408]) {
        const of = vault(exit, 60);
        const proof = proveBy('enclosed', of, HOLE, { accuracy: 'precise' }) as Proof;
        expect(verifyProof(of, proof)).toEqual({ ok: true });
        if (proof.certificate.kind !== 'enclosed') throw new Error('expected a barrier');
        // the outer ring alone is none
        for (const { by } of proof.certificate.barrier) expect(by).toSatisfy((by) => by.kind === 'range' || by.index >= 40);
      }
    });

    it('without the smaller ring, with gaps in it, or with the mouth across it there is no proof', () => {
      expect(proveBy('enclosed', { ...vault(400, 60), novae: ring(500, 0, 200) }, HOLE)).toBeNull();
      expect(proveBy('enclosed', vault(400, 150), HOLE)).toBeNull();
      for (const exit of [450, 460, 480]) expect(proveBy('enclosed', vault(exit, 60), HOLE)).toBeNull();
    });
  });

  it('covered: claims nothing about minerals, which count before a hazard', () => {
    const of = level({ novae: [at(90, 60, 60)], asteroids: [at(150, 0), at(0, 160)] });
    const about: About = { kind: 'mineral', index: 0 };
    const proof = proveBy('covered', of, about) as Proof;
    expect(verifyProof(of, proof)).toEqual({ ok: true });
    const short: Level = { ...of, wormholes: [wormhole(0, 40, 90, 60, 5)] };
    expect(proveBy('covered', short, about)).toBeNull();
    expect(verifyProof(short, proof)).toEqual({ ok: false, why: 'a wormhole may take her to it' });
    const run = simulate(compile({ ...short, astronaut: { x: 0, y: 0, vx: 0, vy: 20 } }), []);
    expect(run.minerals.map(({ index }) => index)).toEqual([0]);
  });

  it('in frames: falling through one again and again she reaches the speed limit, and jumps over what otherwise stops her', () => {
    const of = level({ range: 400, asteroids: [at(300, 0), at(1110, 0)], blackHole: { x: 1400, y: 0 } });
    expect(proveBy('out-of-range', of, HOLE, { accuracy: 'arcade' })).not.toBeNull();
    const again: Level = { ...of, wormholes: [wormhole(250, 0, -60, 0, 20)] };
    expect(proveBy('out-of-range', again, HOLE, { accuracy: 'arcade' })).toBeNull();
    const proof = proveBy('out-of-range', of, HOLE, { accuracy: 'arcade' }) as Proof;
    for (const mouths of [[], [0, 1]])
      expect(verifyProof(again, { ...proof, certificate: { ...proof.certificate, mouths } as never }).ok).toBe(false);
  });
});

describe('winds that proofs follow', () => {
  it('doomed: blown against the wall', () => {
    const of: Level = { ...LEVELS.doomed, winds: [wind(-20, 0, 90, -30, 0)] };
    const proof = proveBy('doomed', of, HOLE) as Proof;
    expect(verifyProof(of, proof)).toEqual({ ok: true });
    // Without the wind, or with one that differs by a thousandth, the sets are wrong.
    for (const winds of [[], [wind(-20, 0, 90, -30.03, 0)], [wind(-20, 0, 90, -29.97, 0)], [wind(-20, 0, 90, -30, 0.03)]])
      expect(verifyProof({ ...of, winds }, proof).ok).toBe(false);
  });

  it.each(['line-trap', 'line-trap with a dead end', 'flowpipe', 'doomed'])('%s: not where a wind blows on her', (name) => {
    const proof = proveImpossible(LEVELS[name]) as Proof;
    const of: Level = { ...LEVELS[name], winds: [wind(0, 0, 300, 60, 100)] };
    expect(verifyProof(of, proof).ok).toBe(false);
    const kind = (name === 'line-trap with a dead end' ? 'dead-end' : name) as Prover;
    if (kind !== 'doomed') expect(proveBy(kind, of, HOLE)).toBeNull();
  });
});
