import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, simulate } from '../../engine/index.ts';
import { type Hold, type Level, RULE_NAMES, RULES, rulesOf } from '../../schema/index.ts';
import { createSearch, type Proof, proveImpossible, proveMineralsUnreachable, verifyProof } from '../../solver/index.ts';
import { accuracyNames, pack } from '../levels/shipped-pack.ts';
import { importedLevels } from '../truth/imported-levels.ts';
import { hasTruth } from '../truth/recordings.ts';
import { anyLevel, someHolds } from './proofs-crowded.ts';

/** What the proofs for an accuracy claim to be out of reach: `blackHole`, and indices of minerals. */
function unreachable(level: Level, accuracy: AccuracyName): (number | 'blackHole')[] {
  const hole = proveImpossible(level, { accuracy });
  const minerals = proveMineralsUnreachable(level, { accuracy });
  for (const proof of [...(hole === null ? [] : [hole]), ...minerals]) {
    expect(proof.covers).toContain(accuracy);
    expect(verifyProof(level, proof)).toEqual({ ok: true });
  }
  return [...(hole === null ? [] : ['blackHole' as const]), ...minerals.map(({ about }) => (about as { index: number }).index)];
}

/** What a run touches. */
function touched(level: Level, holds: readonly Hold[], accuracy: AccuracyName): (number | 'blackHole')[] {
  const run = simulate(compile(level, accuracy), holds);
  return [...(run.outcome === 'completed' ? ['blackHole' as const] : []), ...run.minerals.map(({ index }) => index)];
}

describe('nothing that a run touches is proved to be out of reach', () => {
  it.each(accuracyNames)('random play in random levels: %s', (accuracy) => {
    let runsThatTouch = 0;
    let proofs = 0;
    fc.assert(
      fc.property(anyLevel, fc.array(someHolds, { minLength: 6, maxLength: 6 }), (level, plays) => {
        const out = unreachable(level, accuracy);
        proofs += out.length;
        for (const holds of plays) {
          const reached = touched(level, holds, accuracy);
          runsThatTouch += reached.length;
          expect(out.filter((thing) => reached.includes(thing))).toEqual([]);
        }
      }),
      { numRuns: 300 },
    );
    // The property is meaningful only if both occur.
    expect(runsThatTouch).toBeGreaterThan(100);
    expect(proofs).toBeGreaterThan(100);
  });

  it.each(['arcade', 'precise'] as const)('a search in random levels: %s', (accuracy) => {
    let found = 0;
    let proved = 0;
    fc.assert(
      fc.property(anyLevel, (level) => {
        const search = createSearch(compile(level, accuracy), { seed: 1 });
        search.advance(20_000);
        const proof = proveImpossible(level, { accuracy });
        if (search.solutions.length > 0) found++;
        if (proof !== null) proved++;
        expect(proof === null || search.solutions.length === 0).toBe(true);
      }),
      { numRuns: 150 },
    );
    expect(found).toBeGreaterThan(15);
    expect(proved).toBeGreaterThan(15);
  });

  it('the shipped levels', () => {
    for (const { slug, level } of pack) {
      for (const accuracy of accuracyNames) {
        expect(`${slug} ${accuracy}: ${unreachable(level, accuracy)}`).toBe(`${slug} ${accuracy}: `);
      }
    }
  });

  it.skipIf(!hasTruth)('the original levels', () => {
    for (const [number, level] of importedLevels()) {
      for (const accuracy of accuracyNames) {
        expect(`${number} ${accuracy}: ${proveImpossible(level, { accuracy })?.reason}`).toBe(`${number} ${accuracy}: undefined`);
      }
    }
  });
});

describe('a proof of another level is refused for a level that can be completed', () => {
  it('whatever is moved away', () => {
    let rejected = 0;
    fc.assert(
      fc.property(anyLevel, fc.array(someHolds, { minLength: 8, maxLength: 8 }), fc.nat(), (level, plays, which) => {
        const proof = proveImpossible(level, { accuracy: 'precise' });
        if (proof === null) return;
        const eased = ease(level, which);
        const wins = plays.some((holds) => touched(eased, holds, 'precise').includes('blackHole'));
        if (!wins) return;
        rejected++;
        expect(verifyProof(eased, proof as Proof).ok).toBe(false);
      }),
      { numRuns: 1500 },
    );
    expect(rejected).toBeGreaterThan(5);
  });
});

/** The level with an object removed or brought nearer. */
function ease(level: Level, which: number): Level {
  const others = <T>(list: readonly T[]) => list.filter((_, i) => list.length > 0 && i !== which % list.length);
  const nearer = { ...level.blackHole, x: level.blackHole.x / 3, y: level.blackHole.y / 3 };
  const kinds: (() => Level)[] = [
    () => ({ ...level, novae: others(level.novae) }),
    () => ({ ...level, novae: [] }),
    () => ({ ...level, blackHole: nearer }),
    () => ({ ...level, range: level.range * 3 }),
    () => ({ ...level, astronaut: { ...level.astronaut, vx: 20, vy: -30 } }),
    () => ({ ...level, novae: [], blackHole: nearer }),
    () => ({ ...level, winds: others(level.winds), wormholes: others(level.wormholes) }),
    () => ({ ...level, winds: [{ id: null, x: 0, y: 0, radius: 200, ax: (which % 90) - 45, ay: (which % 70) - 35 }] }),
    () => ({ ...level, wormholes: [{ id: null, x: 0, y: 60, toX: level.blackHole.x, toY: level.blackHole.y + 30, radius: 50 }] }),
    () => withRule(1.001),
    () => withRule(0.999),
    () => withRule(2),
    () => withRule(0.5),
  ];
  return kinds[which % kinds.length]();

  function withRule(factor: number): Level {
    const name = RULE_NAMES[Math.floor(which / kinds.length) % RULE_NAMES.length];
    const { least, most } = RULES[name];
    return { ...level, rules: { ...level.rules, [name]: Math.min(most, Math.max(least, rulesOf(level)[name] * factor)) } };
  }
}
