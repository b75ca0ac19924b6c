import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { ACCURACIES, type AccuracyName, compile, simulate } from '../../engine/index.ts';
import { type Level, type OwnRules, RULE_NAMES, RULES, rulesOf } from '../../schema/index.ts';
import { type About, type PROVERS, type Proof, proveBy, proveImpossible, verifyProof } from '../../solver/index.ts';
import { mostPush } from '../../solver/verify/assumptions.ts';
import { expectDeep, isDeep } from '../depth.ts';
import { LEVELS } from './impossible-levels.ts';
import { crowdedLevel, someHolds, windyLevel } from './proofs-crowded.ts';
import { someRules } from './some-rules.ts';

// Levels with their own rules: they are proved where they are impossible and never where a run completes them, and a
// certificate is valid only for the rules for which it was made.

const HOLE: About = { kind: 'blackHole' };
const accuracyNames = Object.keys(ACCURACIES) as AccuracyName[];

/** The same level in other units of length. */
function scaled(level: Level, k: number): Level {
  const { pull, recoil, push, alienPull, alienSight, speedLimit, boxWidth, boxHeight } = rulesOf(level);
  const all = <T extends object>(list: readonly T[]): T[] =>
    list.map(
      (one) =>
        Object.fromEntries(Object.entries(one).map(([key, value]) => [key, typeof value === 'number' ? value * k : value])) as T,
    );
  const [astronaut] = all([level.astronaut]);
  const [blackHole] = all([level.blackHole]);
  return {
    ...level,
    astronaut,
    blackHole,
    range: level.range * k,
    asteroids: all(level.asteroids),
    novae: all(level.novae),
    repulsors: all(level.repulsors),
    aliens: all(level.aliens),
    minerals: all(level.minerals),
    rules: {
      pull: pull * k,
      recoil: recoil * k * k,
      push: push * k,
      alienPull: alienPull * k,
      alienSight: alienSight * k,
      speedLimit: speedLimit * k,
      boxWidth: boxWidth * k,
      boxHeight: boxHeight * k,
    },
  };
}

/** The levels; that of `orbits`, which takes a second to prove, in the deep set alone. */
const NAMES = Object.keys(LEVELS).filter((name) => isDeep || name !== 'orbits');

describe('the same level in other units is equally impossible', () => {
  it.each(NAMES)('%s', (name) => {
    const proof = proveImpossible(LEVELS[name]) as Proof;
    for (const k of [0.5, 0.8]) {
      const level = scaled(LEVELS[name], k);
      const same = proveImpossible(level) as Proof;
      expect(same).toMatchObject({ code: proof.code, covers: proof.covers, maxTime: proof.maxTime });
      expect(verifyProof(level, same)).toEqual({ ok: true });
      // A certificate in px of another size is refused if it contains any places.
      if (['enclosed', 'doomed', 'flowpipe'].includes(proof.code)) expect(verifyProof(level, proof).ok).toBe(false);
    }
  });
});

describe('the original’s rules, stated explicitly', () => {
  const said = Object.fromEntries(RULE_NAMES.map((name) => [name, RULES[name].default])) as OwnRules;

  it.each(NAMES)('%s: the proof is the same', (name) => {
    expect(proveImpossible({ ...LEVELS[name], rules: said })).toEqual(proveImpossible(LEVELS[name]));
  });
});

describe('lemma: nothing pulls more than the strongest push, as the engine sees it', () => {
  it('of prover and checker', () => {
    fc.assert(
      fc.property(windyLevel, someRules, (of, rules) => {
        const level = { ...of, rules };
        expect(mostPush(level, rulesOf(level))).toBeGreaterThanOrEqual((1 - 1e-12) * compile(level).strongest);
      }),
      { numRuns: 300 },
    );
  });
});

/** Proofs in levels that the run does not complete. */
const ENOUGH = 20;

describe('a level that a run completes is never proved impossible, whatever its rules', () => {
  it.each(accuracyNames)('%s', (accuracy) => {
    let completed = 0;
    let proved = 0;
    fc.assert(
      fc.property(fc.oneof(crowdedLevel, windyLevel), someRules, someHolds, (of, rules, holds) => {
        const level = { ...of, rules };
        const run = simulate(compile(level, accuracy), holds, { maxTime: 30 });
        const completes = run.outcome === 'completed';
        // Otherwise either answer may be right; a number of proofs shows that there are any to be had.
        if (!completes && proved > ENOUGH) return;
        const proof = proveImpossible(level, { accuracy, maxTime: 30 });
        if (completes) {
          completed++;
          expect(proof).toBeNull();
        } else if (proof !== null) proved++;
      }),
      { numRuns: 80 },
    );
    expectDeep(completed).toBeGreaterThan(3);
    expectDeep(proved).toBeGreaterThan(ENOUGH);
  });
});

/** Certificates with tight sets, for which a rule that is worse by a thousandth is noticed. */
const TIGHT: readonly [kind: keyof typeof PROVERS, rule: keyof OwnRules, factor: number][] = [
  ['doomed', 'pull', 1.001],
  ['flowpipe', 'speedLimit', 0.1],
  ['flowpipe', 'pull', 1.3],
  ['enclosed', 'boxWidth', 0.5],
  ['starts-in-hazard', 'boxHeight', 0.2],
];

describe('a certificate is checked against the given level', () => {
  it.each(TIGHT)('%s: %s times %d', (kind, rule, factor) => {
    const level = LEVELS[kind];
    const proof = proveBy(kind, level, HOLE) as Proof;
    expect(verifyProof(level, proof).ok).toBe(true);
    const other: Level = { ...level, rules: { [rule]: RULES[rule].default * factor } };
    expect(verifyProof(other, proof).ok).toBe(false);
  });
});
