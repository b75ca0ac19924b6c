import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, simulate } from '../../engine/index.ts';
import { type Hold, type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { type Certificate, type Proof, proveImpossible, proveMineralsUnreachable, verifyProof } from '../../solver/index.ts';
import { accuracyNames } from '../levels/shipped-pack.ts';

const at = (x: number, y: number, radius = 16) => ({ x, y, radius });
const level = (more: Partial<LevelFile>): Level =>
  resolveLevel({ version: 1, name: 'refuted', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 }, ...more });

/** Claims that were once proved, each with a run that touches the object all the same. */
const REFUTED: [what: string, of: Level, holds: Hold[], maxTime: number, at?: readonly AccuracyName[]][] = [
  [
    'at the speed limit on one axis she bends off the line',
    level({ range: 7e5, asteroids: [at(21_000, 15_000)], blackHole: { x: 30_128, y: 22_340 } }),
    [[0, 3600]],
    60,
  ],
  [
    'frames hold each axis of an asteroid’s velocity, too: one that recoil makes so fast leaves the line, and draws her with it',
    level({
      range: 1e6,
      recoil: true,
      asteroids: [at(3e5, 4e5, 0.001)],
      novae: [at(3600, 4800, 150)],
      blackHole: { x: 3000 - 0.8 * 34.2, y: 4000 + 0.6 * 34.2 },
    }),
    [[0, 3600]],
    60,
    ['arcade'],
  ],
];

describe.each(REFUTED)('%s', (_, of, holds, maxTime, at = accuracyNames) => {
  it.each(at)('is completed, and is not proved impossible: %s', (accuracy) => {
    expect(simulate(compile(of, accuracy), holds, { maxTime }).outcome).toBe('completed');
    expect(proveImpossible(of, { accuracy, maxTime })).toBeNull();
  });
});

describe('a line along an axis', () => {
  // A fall of the same length: there the limit applies to one axis only.
  const along = level({ range: 7e5, asteroids: [at(26_000, 0)], blackHole: { x: 30_000, y: 60 } });

  it('is not bent by the speed limit, and stays proved', () => {
    const proof = proveImpossible(along, { accuracy: 'precise' });
    expect(proof?.code).toBe('line-trap');
    expect(verifyProof(along, proof as Proof)).toEqual({ ok: true });
    const run = simulate(compile(along), [[0, 3600]], { maxTime: 60 });
    expect(Math.abs(run.final.y)).toBe(0);
    expect(run.final.vx).toBeLessThanOrEqual(1000);
  });

  it('has a proof that is refused for a slanted line, and with recoil', () => {
    const found = proveImpossible(along, { accuracy: 'precise' }) as Proof;
    const trap = found.certificate as Extract<Certificate, { kind: 'line-trap' }>;
    const wider = { ...trap, back: { ...trap.back, at: trap.back.at - 10 }, front: { ...trap.front, at: trap.front.at + 10 } };
    const proof: Proof = { ...found, certificate: wider };
    expect(verifyProof(along, proof)).toEqual({ ok: true });
    const slanted = { ...along, asteroids: [{ ...along.asteroids[0], y: 400 }] };
    expect(verifyProof(slanted, proof)).toEqual({ ok: false, why: 'she may reach the speed limit and leave the line' });
    expect(proveImpossible(slanted, { accuracy: 'precise' })).toBeNull();
    expect(proveImpossible({ ...along, recoil: true }, { accuracy: 'precise' })).toBeNull();
  });
});

describe('proofs for frames on a slanted line', () => {
  const slanted = level({
    asteroids: [at(150, 70)],
    novae: [at(75, 35)],
    minerals: [{ x: 150, y: -60 }],
    blackHole: { x: 220, y: 110 },
  });

  it('state the length of a run, because rounding adds up', () => {
    const proof = proveImpossible(slanted, { accuracy: 'arcade' }) as Proof;
    expect(proof).toMatchObject({ code: 'line-trap', maxTime: 60 });
    expect(verifyProof(slanted, proof)).toEqual({ ok: true });
    expect(verifyProof(slanted, { ...proof, maxTime: null }).ok).toBe(false);
    expect(verifyProof(slanted, { ...proof, maxTime: 1e6 }).ok).toBe(false);
    expect(verifyProof(slanted, { ...proof, maxTime: null, covers: ['fast', 'standard', 'precise'] }).ok).toBe(true);
    expect(proveMineralsUnreachable(slanted, { accuracy: 'arcade' })).toHaveLength(1);
  });

  it('are not made far out, where coordinates are coarse', () => {
    const by = 1e8;
    const far: Level = {
      ...slanted,
      astronaut: { ...slanted.astronaut, x: by, y: by },
      asteroids: slanted.asteroids.map((a) => ({ ...a, x: a.x + by, y: a.y + by })),
      novae: slanted.novae.map((a) => ({ ...a, x: a.x + by, y: a.y + by })),
      blackHole: { ...slanted.blackHole, x: slanted.blackHole.x + by, y: slanted.blackHole.y + by },
    };
    expect(proveImpossible(far, { accuracy: 'arcade' })).toBeNull();
    expect(proveImpossible(far, { accuracy: 'precise' })?.code).toBe('line-trap');
  });
});
