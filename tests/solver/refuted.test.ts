import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, createSimulation, playScript, STATE_SIZE, simulate } from '../../engine/index.ts';
import { type Hold, type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { type Certificate, type Proof, proveImpossible, proveMineralsUnreachable, verifyProof } from '../../solver/index.ts';
import { accuracyNames } from '../levels/shipped-pack.ts';

const at = (x: number, y: number, radius = 16) => ({ x, y, radius });
const level = (more: Partial<LevelFile>): Level =>
  resolveLevel({ version: 1, name: 'refuted', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 }, ...more });

/** Claims that were once proved or are easily believed, each with a run that touches the object all the same. */
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
  [
    'the range ends 16 px before she could touch the black hole, but she lingers there until recoil has carried it farther',
    level({ range: 100, recoil: true, asteroids: [at(80, 0)], blackHole: { x: 224, y: 0 } }),
    [
      [0, 110],
      [574, 611],
      [612, 829],
      [830, 1023],
      [1024, 1125],
      [1126, 1167],
      [1168, 1181],
      [1182, 1186],
      [1188, 1801],
      [2035, 2091],
      [2349, 2429],
      [2430, 2692],
      [2693, 2832],
      [2833, 2883],
    ],
    60,
    ['precise'],
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

describe('a dead end, once there is recoil', () => {
  // Beyond 125 px along the line, the second asteroid is nearer. Without recoil, all ways from there end at hazards.
  const dead = level({
    asteroids: [at(54, 0), at(160, 86)],
    novae: [at(-150, 0, 32), at(215, 0, 32), at(200, 55, 32), at(150, 60)],
    blackHole: { x: 60, y: -90 },
  });
  const leaky: Level = { ...dead, recoil: true, rules: { recoil: 1000 } };
  // The third hold pulls her off the line. She drifts on so slowly that the border, which moves with the first asteroid, overtakes
  // her. Then she swings past the centre of that asteroid.
  const off: Hold[] = [
    [0, 77],
    [116, 208],
    [286, 287],
  ];
  const run: Hold[] = [...off, [985, 1145], [1265, 1313], [1433, 1529]];

  it('is left where the border between two asteroids overtakes her', () => {
    const state = new Float64Array(STATE_SIZE);
    // her distance from the line, and the target of a press then
    const look = (tick: number) => {
      const simulation = createSimulation(compile(leaky, 'precise'));
      playScript(simulation, off, tick);
      simulation.readState(state);
      simulation.advance(1, true);
      return { aside: state[1], target: simulation.target };
    };
    expect(look(286)).toEqual({ aside: 0, target: 1 });
    expect(look(970).target).toBe(1);
    expect(look(985).target).toBe(0);
    expect(look(985).aside).toBeGreaterThan(3);
    expect(simulate(compile(leaky, 'precise'), run).outcome).toBe('completed');
  });

  it('is proved without recoil only', () => {
    const proof = proveImpossible(dead, { accuracy: 'precise', maxTime: 60 }) as Proof;
    const trap = proof.certificate as Extract<Certificate, { kind: 'line-trap' }>;
    expect(trap.front.by.kind).toBe('dead-end');
    expect(verifyProof(dead, proof)).toEqual({ ok: true });
    expect(proveImpossible(leaky, { accuracy: 'precise', maxTime: 60 })).toBeNull();
    for (const drift of [null, { back: 0, ahead: 0 }, { back: 1e5, ahead: 1e5 }]) {
      expect(verifyProof(leaky, { ...proof, maxTime: 60, certificate: { ...trap, drift } }).ok).toBe(false);
    }
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
