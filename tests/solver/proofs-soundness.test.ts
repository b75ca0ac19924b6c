import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, type Scene, simulate, WorkBudget } from '../../engine/index.ts';
import { type Hold, type Level, RULE_NAMES, RULES, rulesOf } from '../../schema/index.ts';
import { createSearch, type Proof, proveImpossible, proveMineralsUnreachable, verifyProof } from '../../solver/index.ts';
import { expectDeep } from '../depth.ts';
import { accuracyNames, pack } from '../levels/shipped-pack.ts';
import { importedLevels } from '../truth/imported-levels.ts';
import { hasTruth } from '../truth/recordings.ts';
import { anyLevel, someHolds } from './proofs-crowded.ts';

/** The accuracies for which a prover is asked; what it proves for `precise` mostly covers `fast` and `standard`, too. */
const ASKED = ['arcade', 'precise'] as const;

/** The proofs for an accuracy that something is out of reach, as far as they are found with that many pieces of work each. */
function proofsFor(level: Level, accuracy: AccuracyName, work = Number.POSITIVE_INFINITY): Proof[] {
  const hole = proveImpossible(level, { accuracy, budget: new WorkBudget(work) });
  const minerals = proveMineralsUnreachable(level, { accuracy, budget: new WorkBudget(work) });
  const proofs = [...(hole === null ? [] : [hole]), ...minerals];
  // Proofs of these kinds follow all runs, whichever object they are about: the dear check need not be repeated for each.
  const followed = new Set<string>();
  for (const proof of proofs) {
    expect(proof.covers).toContain(accuracy);
    if (followed.has(proof.code)) continue;
    if (proof.code === 'doomed' || proof.code === 'flowpipe') followed.add(proof.code);
    expect(verifyProof(level, proof)).toEqual({ ok: true });
  }
  return proofs;
}

/**
 * Pieces of work for a random level. Most doomed levels are proved with less; where nothing can be proved, the search for a proof
 * would take ten times as long. Flowpipes need more: see attack.test.ts and `npm run bench -- soak --attack proofs`.
 */
const LITTLE = 3000;

const thingOf = ({ about }: Proof): number | 'blackHole' => (about.kind === 'blackHole' ? 'blackHole' : about.index);

/** What a run touches. */
function touched(scene: Scene, holds: readonly Hold[]): (number | 'blackHole')[] {
  const run = simulate(scene, holds);
  return [...(run.outcome === 'completed' ? ['blackHole' as const] : []), ...run.minerals.map(({ index }) => index)];
}

/** Levels that a search has to complete, and levels over at the start in which it is tried. */
const ENOUGH = 8;

describe('nothing that a run touches is proved to be out of reach', () => {
  // Every proof is attacked at all accuracies that it claims to cover, not only at the one it was asked for.
  it.each(ASKED)('random play in random levels: %s', (asked) => {
    const proofs = Object.fromEntries(accuracyNames.map((name) => [name, 0]));
    const runsThatTouch = { ...proofs };
    fc.assert(
      fc.property(anyLevel, fc.array(someHolds, { minLength: 6, maxLength: 6 }), (level, plays) => {
        const found = proofsFor(level, asked, LITTLE);
        for (const accuracy of accuracyNames) {
          const out = found.filter(({ covers }) => covers.includes(accuracy)).map(thingOf);
          proofs[accuracy] += out.length;
          if (out.length === 0) continue;
          const scene = compile(level, accuracy);
          for (const holds of plays) {
            const reached = touched(scene, holds);
            runsThatTouch[accuracy] += reached.length;
            expect(out.filter((thing) => reached.includes(thing))).toEqual([]);
          }
        }
      }),
      { numRuns: 55 },
    );
    // The property is meaningful only if both occur.
    for (const accuracy of accuracyNames) {
      expectDeep(runsThatTouch[accuracy]).toBeGreaterThan(5);
      expectDeep(proofs[accuracy]).toBeGreaterThan(50);
    }
  });

  it.each(ASKED)('a search in random levels: %s', (accuracy) => {
    let found = 0;
    let proved = 0;
    let overAtStart = 0;
    fc.assert(
      fc.property(anyLevel, (level) => {
        const proof = proveImpossible(level, { accuracy, budget: new WorkBudget(LITTLE) });
        if (proof !== null) proved++;
        // Without a proof, whatever the search finds is right. It still has to be one that finds runs.
        if (proof === null && found >= ENOUGH) return;
        // Where all is over at the start, a search costs as much and says less.
        if ((proof?.code === 'starts-in-hazard' || proof?.code === 'nothing-in-range') && ++overAtStart > ENOUGH) return;
        const search = createSearch(compile(level, accuracy), { seed: 1 });
        search.advance(12_000);
        if (search.solutions.length > 0) found++;
        expect(proof === null || search.solutions.length === 0).toBe(true);
      }),
      { numRuns: 40 },
    );
    expectDeep(found).toBeGreaterThanOrEqual(ENOUGH);
    expectDeep(proved).toBeGreaterThan(8);
  });

  it('the shipped levels', () => {
    for (const { slug, level } of pack) {
      for (const accuracy of ASKED) {
        expect(`${slug} ${accuracy}: ${proofsFor(level, accuracy, LITTLE).map(thingOf)}`).toBe(`${slug} ${accuracy}: `);
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
        const eased = ease(level, which);
        // A win is rarer than a proof, and playing costs less than proving.
        const scene = compile(eased, 'precise');
        const wins = plays.some((holds) => simulate(scene, holds).outcome === 'completed');
        const proof = wins ? proveImpossible(level, { accuracy: 'precise' }) : null;
        if (proof === null) return;
        rejected++;
        expect(verifyProof(eased, proof).ok).toBe(false);
      }),
      { numRuns: 110 },
    );
    expectDeep(rejected).toBeGreaterThan(2);
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
