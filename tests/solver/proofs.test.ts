import { describe, expect, it } from 'vitest';
import { type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { type Proof, proofPicture, proveImpossible, proveMineralsUnreachable, verifyProof } from '../../solver/index.ts';

const base: LevelFile = {
  version: 1,
  name: 'fine',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: [{ x: 150, y: 0, radius: 16 }],
};
const level = (more: Partial<LevelFile>): Level => resolveLevel({ ...base, ...more });
const at = (x: number, y: number, radius = 16) => ({ x, y, radius });
const hot = (x: number, y: number, radius = 16) => ({ x, y, radius, hot: true });

/**
 * `count` circles of radius 16 on a circle around (x, y), so close together that she does not fit between them: gaps of 28 px
 * at most.
 */
const ring = (x: number, y: number, r: number, gaps = 0) => {
  const count = Math.ceil((2 * Math.PI * r) / 28);
  return Array.from({ length: count - gaps }, (_, i) => {
    const turn = (2 * Math.PI * i) / count;
    return at(x + r * Math.cos(turn), y + r * Math.sin(turn));
  });
};

const ALL = ['arcade', 'fast', 'standard', 'precise'];
const CONTINUOUS = ['fast', 'standard', 'precise'];
const EXACT = ['precise'];

// A second asteroid above the line keeps her from being bound to it.
const roomy = { asteroids: [at(150, 0), at(0, 160)] };

// Some speed keeps her from being bound to the line.
const drifts = { astronaut: { x: 0, y: 0, vy: 1 } };

// What each kind proves, for which accuracies, and the nearest level that it must not prove.
const CASES: [what: string, code: Proof['code'], covers: string[], wrong: Partial<LevelFile>, right: Partial<LevelFile>][] = [
  ['one px beyond the range', 'nothing-in-range', ALL, { astronaut: { x: -101, y: 0 } }, { astronaut: { x: -100, y: 0 } }],
  ['no asteroid', 'nothing-in-range', ALL, { asteroids: [] }, {}],
  [
    'the black hole is touched before she is lost',
    'nothing-in-range',
    ALL,
    { asteroids: [] },
    { asteroids: [], blackHole: { x: 27, y: 0 } },
  ],
  [
    'upright she touches a nova below, turned she does not',
    'starts-in-hazard',
    CONTINUOUS,
    { novae: [at(0, 31)] },
    { novae: [at(0, 33)] },
  ],
  ['however turned she touches it', 'starts-in-hazard', ALL, { novae: [at(0, 25)] }, { novae: [at(0, 33)] }],
  ['a hot asteroid', 'starts-in-hazard', ALL, { asteroids: [hot(25, 0)] }, { asteroids: [at(25, 0)] }],
  ['an alien', 'starts-in-hazard', ALL, { aliens: [{ x: -34, y: 0 }] }, { aliens: [{ x: -36, y: 0 }] }],
  // range 250 + radius 18 + half the diagonal 18.868
  ['the black hole too far', 'out-of-range', ALL, { blackHole: { x: 437, y: 0 } }, { ...drifts, blackHole: { x: 436, y: 0 } }],
  [
    'a gap that a frame can not jump',
    'out-of-range',
    ALL,
    { blackHole: { x: 760, y: 0 }, asteroids: [at(150, 0), at(660, 0)] },
    { blackHole: { x: 760, y: 0 }, asteroids: [at(150, 0), at(649, 0)] },
  ],
  [
    'a gap that a frame might jump',
    'out-of-range',
    CONTINUOUS,
    { blackHole: { x: 760, y: 0 }, asteroids: [at(150, 0), at(651, 0)] },
    { blackHole: { x: 760, y: 0 }, asteroids: [at(150, 0), at(649, 0)] },
  ],
  [
    'recoil may bring them together',
    'out-of-range',
    ALL,
    { blackHole: { x: 437, y: 0 } },
    { blackHole: { x: 437, y: 0 }, recoil: true },
  ],
  [
    'even with recoil',
    'out-of-range',
    ALL,
    { ...drifts, blackHole: { x: 495, y: 0 }, recoil: true },
    { ...drifts, blackHole: { x: 493, y: 0 }, recoil: true },
  ],
  [
    'a ring about the black hole',
    'enclosed',
    ALL,
    { ...roomy, novae: ring(300, 0, 70) },
    { ...roomy, novae: ring(300, 0, 70, 2) },
  ],
  ['a ring about the start', 'enclosed', ALL, { ...drifts, novae: ring(0, 0, 90) }, { ...drifts, novae: ring(0, 0, 90, 2) }],
  [
    'a wall from one end of the range to the other',
    'enclosed',
    ALL,
    { novae: Array.from({ length: 29 }, (_, i) => at(220, -378 + 27 * i)), asteroids: [at(120, 120), at(120, -120)] },
    { novae: Array.from({ length: 25 }, (_, i) => at(220, -378 + 27 * i)), asteroids: [at(120, 120), at(120, -120)] },
  ],
  [
    'hot asteroids block as long as they stay',
    'enclosed',
    ALL,
    { ...roomy, asteroids: [...roomy.asteroids, ...ring(300, 0, 70).map((c) => ({ ...c, hot: true }))] },
    { ...roomy, recoil: true, asteroids: [...roomy.asteroids, ...ring(300, 0, 70).map((c) => ({ ...c, hot: true }))] },
  ],
  ['a nova on the line of the fall', 'line-trap', ALL, { novae: [at(80, 30)] }, { novae: [at(80, 33)] }],
  [
    'a nova on the line, with recoil',
    'line-trap',
    ALL,
    { recoil: true, novae: [at(80, 30)] },
    { recoil: true, novae: [at(80, 33)] },
  ],
  [
    'the target itself burns',
    'line-trap',
    ALL,
    { asteroids: [hot(150, 0)] },
    { asteroids: [hot(150, 0)], blackHole: { x: 120, y: 60 }, astronaut: { x: 0, y: 0, vy: 1 } },
  ],
  ['the black hole beside the line', 'line-trap', CONTINUOUS, { blackHole: { x: 300, y: 35 } }, { blackHole: { x: 300, y: 33 } }],
  [
    'a nova beyond the asteroid',
    'line-trap',
    CONTINUOUS,
    { novae: [at(220, 0)] },
    { novae: [at(220, 0)], astronaut: { x: 0, y: 0, vy: 1 } },
  ],
  [
    'another asteroid becomes the nearer one',
    'line-trap',
    CONTINUOUS,
    { novae: [at(220, 0)], asteroids: [at(150, 0), at(260, 180)] },
    { novae: [at(220, 0)], asteroids: [at(150, 0), at(190, 40)] },
  ],
  [
    'another asteroid pulls her off the line into novae',
    'line-trap',
    EXACT,
    { asteroids: [at(60, 0), at(160, 60)], novae: [at(-60, 0), at(176, 0, 32), at(150, 66, 32)] },
    { asteroids: [at(60, 0), at(160, 60)], novae: [at(-60, 0), at(200, 0, 32)] },
  ],
  [
    'off the line she turns towards what pulls her, and no farther',
    'line-trap',
    EXACT,
    { asteroids: [at(60, 0), at(150, 50)], novae: [at(-60, 0), at(174, 0, 32)] },
    { asteroids: [at(60, 0), at(150, 50)], novae: [at(-60, 0), at(182, 0, 32)] },
  ],
  [
    'recoil adds up to little as she swings to and fro',
    'line-trap',
    CONTINUOUS,
    { recoil: true, asteroids: [at(60, 0), at(0, 120)], novae: [at(150, 0), at(-60, 0)] },
    { recoil: true, asteroids: [at(60, 0), at(0, 95)], novae: [at(150, 0), at(-60, 0)] },
  ],
  [
    'recoil carries it less to the side on which she comes less far',
    'line-trap',
    CONTINUOUS,
    { recoil: true, asteroids: [at(60, 0), at(0, 100)], novae: [at(120, 0), at(-60, 0)] },
    { recoil: true, asteroids: [at(60, 0), at(0, 90)], novae: [at(120, 0), at(-60, 0)] },
  ],
  // Recoil carries the first asteroid up to 56.8 px either way. Where she is lost, she is 250 px from it.
  [
    'recoil carries the end of the range along, and another asteroid is out of range there',
    'line-trap',
    CONTINUOUS,
    { recoil: true, blackHole: { x: 150, y: 35 }, asteroids: [at(60, 0), at(310, 251)] },
    { recoil: true, blackHole: { x: 150, y: 35 }, asteroids: [at(60, 0), at(310, 249)] },
  ],
  [
    'a field pushes her off the line',
    'line-trap',
    CONTINUOUS,
    { novae: [at(220, 0)], repulsors: [at(100, 50, 48)] },
    { novae: [at(220, 0)], repulsors: [at(100, 47, 48)] },
  ],
  [
    'novae over the black hole',
    'covered',
    CONTINUOUS,
    { ...roomy, novae: [at(306, 0, 22), at(294, 0, 22)] },
    { ...roomy, novae: [at(306, 0, 22)] },
  ],
  [
    'too fast to stop before a nova',
    'doomed',
    ALL,
    { astronaut: { x: 0, y: 0, vx: -60 }, novae: [at(-60, 0, 32), at(-60, 60, 32), at(-60, -60, 32)] },
    { astronaut: { x: 0, y: 0, vx: -20 }, novae: [at(-60, 0, 32), at(-60, 60, 32), at(-60, -60, 32)] },
  ],
  [
    'an alien in her way',
    'flowpipe',
    CONTINUOUS,
    { astronaut: { x: 0, y: 0, vx: 60 }, aliens: [{ x: 110, y: 10 }] },
    { astronaut: { x: 0, y: 0, vx: 60 }, aliens: [{ x: 110, y: 70 }] },
  ],
  [
    'a nova that only a corner of her turned box touches',
    'flowpipe',
    CONTINUOUS,
    { astronaut: { x: 0, y: 0, vx: 60 }, novae: [at(60, 28), at(100, -31)] },
    { astronaut: { x: 0, y: 0, vx: 60 }, novae: [at(60, 33), at(100, -33)] },
  ],
];

describe.each(CASES)('%s', (_, code, covers, wrong, right) => {
  it('is proved, the checker agrees, and there is something to draw', () => {
    const proof = proveImpossible(level(wrong));
    expect(proof).toMatchObject({ code, covers, about: { kind: 'blackHole' } });
    expect(verifyProof(level(wrong), proof as Proof)).toEqual({ ok: true });
    // What a file keeps of the proof is sufficient.
    expect(verifyProof(level(wrong), JSON.parse(JSON.stringify(proof)))).toEqual({ ok: true });
    const { discs, lines } = proofPicture(level(wrong), proof as Proof);
    expect(discs.filter(({ role }) => role === 'thing')).toHaveLength(1);
    for (const { points } of lines) expect(points.length).toBeGreaterThan(1);
  });

  it('is not proved where it only nearly holds', () => {
    expect(proveImpossible(level(right))).toBeNull();
  });
});

describe('the options', () => {
  const jumpable = level({ blackHole: { x: 760, y: 0 }, asteroids: [at(150, 0), at(651, 0)] });

  it('a proof for an accuracy covers that accuracy', () => {
    expect(proveImpossible(jumpable, { accuracy: 'arcade' })).toBeNull();
    expect(proveImpossible(jumpable, { accuracy: 'precise' })?.covers).toContain('precise');
  });

  it('recoil moves asteroids for as long as a run lasts', () => {
    const drifting = level({ ...drifts, blackHole: { x: 495, y: 0 }, recoil: true });
    expect(proveImpossible(drifting)?.maxTime).toBe(60);
    expect(proveImpossible(drifting, { maxTime: 61 })).toBeNull();
    expect(proveImpossible(level({ blackHole: { x: 437, y: 0 } }))?.maxTime).toBeNull();
  });

  it('each mineral has its own proof, and the black hole blocks the path to minerals', () => {
    const minerals = level({
      ...roomy,
      minerals: [at(20, 20, 7), at(460, 0, 7), at(300, 0, 7)],
      blackHole: { x: 300, y: 0, radius: 30 },
    });
    const proofs = proveMineralsUnreachable(minerals);
    // Touching the black hole ends the run, so a mineral deep inside it is never touched.
    expect(proofs.map(({ about, code }) => [about, code])).toEqual([
      [{ kind: 'mineral', index: 1 }, 'out-of-range'],
      [{ kind: 'mineral', index: 2 }, 'enclosed'],
    ]);
    expect(proveImpossible(minerals)).toBeNull();
  });

  it('the reason says what a designer can do', () => {
    expect(proveImpossible(level({ blackHole: { x: 562, y: 0 } }))?.reason).toBe(
      'the black hole is 412 px from the nearest asteroid, asteroid 1; she is lost beyond 250 px, and her collision box touches it from at most ' +
        '36.9 px: move it, or add an asteroid within 286.9 px of it',
    );
    expect(proveImpossible(level({ novae: [at(80, 30)] }))?.reason).toContain('nova 1, which her collision box hits after');
    expect(proveImpossible(level({ ...roomy, novae: ring(300, 0, 70) }))?.reason).toContain(
      'is closed off from the start by nova 12, nova 11',
    );
  });
});
