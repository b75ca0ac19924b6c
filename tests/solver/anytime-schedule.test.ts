import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { TICK, unlimited, WorkLimitReached } from '../../engine/index.ts';
import { type About, type AnytimeOptions, type Proof, proofShare, type Solution } from '../../solver/index.ts';
import { anytimeProofBy, type ProofParts } from '../../solver/search/anytime/anytime-proof.ts';
import { sideBySide } from '../../solver/search/anytime/decider.ts';
import { at, level } from './impossible-levels.ts';

const minerals = (count: number) => Array.from({ length: count }, (_, i) => ({ x: 10 * i, y: 90 }));
const withMinerals = (count: number) =>
  level({ astronaut: { x: 0, y: 0, vx: 60 }, asteroids: [at(150, 100)], minerals: minerals(count) });

interface Made {
  readonly prover: string;
  readonly about: About;
  readonly fineness: number;
  readonly limit: number;
  readonly maxTime: number;
}

const PROOF = { code: 'doomed' } as Proof;

/**
 * Provers that only do work.
 * @param work looks that each attempt wants
 * @param proves whether an attempt that has done all its work finds a proof
 */
function fakeParts(
  work: (made: Made) => number,
  proves: (made: Made) => boolean = () => false,
  isTrue = true,
  barred = 'flowpipe',
) {
  const made: Made[] = [];
  const parts: ProofParts = {
    mayProve: (prover) => prover !== barred,
    verifyProof: () => (isTrue ? { ok: true } : { ok: false, why: 'it is false' }),
    proveBy(prover, _level, about, { budget = unlimited(), fineness = 0, maxTime = 0 } = {}) {
      const one = { prover, about, fineness, limit: budget.most, maxTime };
      made.push(one);
      try {
        // in small steps, as provers do
        for (let left = work(one); left > 0; left -= 1000) budget.look(Math.min(1000, left));
      } catch (error) {
        if (error instanceof WorkLimitReached) return null;
        throw error;
      }
      return proves(one) ? PROOF : null;
    },
  };
  return { parts, made };
}

const OPTIONS: AnytimeOptions = { accuracy: 'precise' };
const NEVER_ENOUGH = () => Number.POSITIVE_INFINITY;
const PLENTY = 1e9;

describe('the schedule of proofs with ever finer sets', () => {
  it('takes no proof that the checker refuses, and goes on', () => {
    const { parts, made } = fakeParts(
      () => 10,
      () => true,
      false,
    );
    const refused = anytimeProofBy(parts, withMinerals(0), OPTIONS);
    refused.advance(PLENTY);
    expect([refused.proof, refused.finished]).toEqual([null, true]);
    expect(made.length).toBeGreaterThan(3);
    const { parts: honest, made: once } = fakeParts(
      () => 10,
      () => true,
    );
    const proving = anytimeProofBy(honest, withMinerals(0), OPTIONS);
    proving.advance(PLENTY);
    expect([proving.proof, proving.finished, proving.nextLimit, once.length]).toEqual([PROOF, true, 0, 1]);
  });

  it('gives each attempt its limit and counts what it took, and at least a tick', () => {
    for (const [work, each] of [
      [0, 1],
      [7.3, 8],
      [12_345, 12_345],
    ]) {
      const { parts, made } = fakeParts(() => work);
      const proving = anytimeProofBy(parts, withMinerals(0), OPTIONS);
      proving.advance(PLENTY);
      expect(proving.ticks).toBe(made.length * each);
    }
    const { parts, made } = fakeParts(NEVER_ENOUGH);
    const proving = anytimeProofBy(parts, withMinerals(0), OPTIONS);
    proving.advance(PLENTY);
    expect(proving.ticks).toBe(made.reduce((sum, { limit }) => sum + limit, 0));
  });

  it('goes on with finer sets and more work as long as there is some to give', () => {
    const { parts, made } = fakeParts(NEVER_ENOUGH, () => false, true, 'none');
    const proving = anytimeProofBy(parts, withMinerals(0), OPTIONS);
    const limits: number[] = [];
    while (!proving.finished) {
      limits.push(proving.nextLimit);
      proving.attempt();
    }
    expect(limits).toEqual(made.map(({ limit }) => limit));
    const orbits = made.filter(({ prover }) => prover === 'orbits');
    expect(orbits.map(({ fineness, limit }) => [fineness, limit])).toEqual([
      [0, 500_000],
      [3, 500_000],
      [0, 3_000_000],
      [2, 8_000_000],
      [1, 8_000_000],
      [3, 24_000_000],
    ]);
    for (const once of ['flowpipe', 'doomed']) {
      expect(made.filter(({ prover }) => prover === once)).toMatchObject([{ fineness: 1, limit: 2_000_000 }]);
    }
  });

  it('does not repeat an attempt that ended by itself with less work than it had', () => {
    const ended = fakeParts(
      () => 400_000,
      () => false,
      true,
      'none',
    );
    anytimeProofBy(ended.parts, withMinerals(0), OPTIONS).advance(PLENTY);
    const tried = ended.made.map(({ prover, fineness }) => `${prover} ${fineness}`);
    expect(tried).toEqual(['orbits 0', 'orbits 3', 'flowpipe 1', 'doomed 1', 'orbits 2', 'orbits 1']);
    // what the limit ended is tried again with a higher one
    const cut = fakeParts(() => 600_000);
    anytimeProofBy(cut.parts, withMinerals(0), OPTIONS).advance(PLENTY);
    expect(cut.made.map(({ limit }) => limit).filter((limit) => limit === 500_000)).toHaveLength(2);
    expect(cut.made.filter(({ prover, fineness }) => prover === 'orbits' && fineness === 0)).toHaveLength(2);
  });

  it('leaves out provers that cannot apply, and those that were not asked for', () => {
    const all = fakeParts(() => 1);
    anytimeProofBy(all.parts, withMinerals(0), OPTIONS).advance(PLENTY);
    expect(new Set(all.made.map(({ prover }) => prover))).toEqual(new Set(['orbits', 'doomed']));
    const some = fakeParts(() => 1);
    anytimeProofBy(some.parts, withMinerals(0), { ...OPTIONS, provers: ['doomed', 'flowpipe'] }).advance(PLENTY);
    expect(new Set(some.made.map(({ prover }) => prover))).toEqual(new Set(['doomed']));
  });

  it.each([
    ['any', 2, 0],
    ['all', 0, 0],
    ['all', 1, 1],
    ['all', 3, 3],
    ['all', 4, 0],
    [1, 2, 0],
    [2, 2, 2],
  ] as const)('with the goal of %s minerals in a level of %i examines %i', (wanted, count, examined) => {
    const { parts, made } = fakeParts(() => 1);
    anytimeProofBy(parts, withMinerals(count), { ...OPTIONS, goal: { minerals: wanted } }).advance(PLENTY);
    const indices = new Set(made.flatMap(({ about }) => (about.kind === 'mineral' ? [about.index] : [])));
    expect([...indices]).toEqual(Array.from({ length: examined }, (_, i) => i));
    expect(made.some(({ about }) => about.kind === 'blackHole')).toBe(true);
  });

  it('claims runs of the asked length', () => {
    const { parts, made } = fakeParts(() => 1);
    anytimeProofBy(parts, withMinerals(0), { ...OPTIONS, maxTicks: 600 }).advance(PLENTY);
    anytimeProofBy(parts, withMinerals(0), OPTIONS).advance(PLENTY);
    expect(new Set(made.map(({ maxTime }) => maxTime))).toEqual(new Set([600 * TICK, 3600 * TICK]));
  });

  it('makes an attempt exactly when the total covers its limit, however it is split', () => {
    const works = fc.array(fc.nat(5_000_000), { minLength: 12, maxLength: 12 });
    const slices = fc.array(fc.nat(3_000_000), { minLength: 1, maxLength: 12 });
    fc.assert(
      fc.property(works, slices, (work, each) => {
        let count = 0;
        const { parts, made } = fakeParts(() => work[count++ % work.length]);
        const proving = anytimeProofBy(parts, withMinerals(0), OPTIONS);
        let given = 0;
        for (const slice of each) {
          proving.advance(slice);
          given += slice;
          expect(proving.ticks).toBeLessThanOrEqual(given);
          expect(proving.finished || proving.ticks + proving.nextLimit > given).toBe(true);
        }
        const before = made.length;
        count = 0;
        const whole = anytimeProofBy(parts, withMinerals(0), OPTIONS);
        whole.advance(given);
        expect([made.length - before, whole.ticks]).toEqual([before, proving.ticks]);
      }),
    );
  });

  it('an attempt that is made beforehand counts as asked for', () => {
    const { parts } = fakeParts(NEVER_ENOUGH);
    const proving = anytimeProofBy(parts, withMinerals(0), OPTIONS);
    proving.attempt();
    expect(proving.ticks).toBe(500_000);
    proving.advance(499_999);
    expect(proving.ticks).toBe(500_000);
    proving.advance(1);
    expect(proving.ticks).toBe(1_000_000);
    // what was asked for and not spent is not forgotten
    const { parts: quick, made } = fakeParts(() => 100);
    const saving = anytimeProofBy(quick, withMinerals(0), OPTIONS);
    saving.advance(400_000);
    expect(made).toHaveLength(0);
    saving.attempt();
    saving.advance(100_100);
    expect(made).toHaveLength(2);
  });

  it('is asked to stop now and then, and begins nothing after that', () => {
    let asked = 0;
    const { parts, made } = fakeParts(NEVER_ENOUGH);
    const proving = anytimeProofBy(parts, withMinerals(0), { ...OPTIONS, isStopped: () => ++asked >= 3 });
    proving.advance(PLENTY);
    // before the attempt, and then twice within it
    expect([made.length, proving.ticks]).toEqual([1, 400_000]);
    expect(proving.finished).toBe(false);
  });

  it('tries what was cut short again with more work', () => {
    let asked = 0;
    const { parts, made } = fakeParts(NEVER_ENOUGH);
    const proving = anytimeProofBy(parts, withMinerals(0), { ...OPTIONS, isStopped: () => ++asked === 2 });
    proving.advance(PLENTY);
    const coarse = made.filter(({ prover, fineness }) => prover === 'orbits' && fineness === 0);
    expect(coarse.map(({ limit }) => limit)).toEqual([500_000, 3_000_000]);
    expect(proving.ticks).toBe(made.reduce((sum, { limit }) => sum + limit, 0) - 300_000);
  });
});

/** A search that finds a run once it has done some work, if ever. */
function fakeSearch(foundAt: number, endsAt = Number.POSITIVE_INFINITY) {
  let ticks = 0;
  const slices: number[] = [];
  return {
    slices,
    closest: null,
    explored: {} as never,
    get effort() {
      return { runs: slices.length, ticks };
    },
    get best() {
      return ticks >= foundAt ? ({} as Solution) : null;
    },
    get finished() {
      return ticks >= endsAt;
    },
    advance(more: number) {
      slices.push(more);
      ticks += more;
    },
  };
}

/** A search for a proof that does all that it is given. */
function fakeProof(provedAt: number, endsAt = Number.POSITIVE_INFINITY) {
  let ticks = 0;
  return {
    get ticks() {
      return ticks;
    },
    get finished() {
      return ticks >= endsAt;
    },
    get proof() {
      return ticks >= provedAt ? PROOF : null;
    },
    advance(more: number) {
      expect(more).toBeGreaterThan(0);
      ticks += more;
    },
  };
}

const NEVER = Number.POSITIVE_INFINITY;
const someTicks = fc.integer({ min: 1, max: 2_000_000 });

describe('the effort of a search for a run and for a proof', () => {
  it('is shared: the proofs do as much as the search, and both no more than the effort', () => {
    fc.assert(
      fc.property(someTicks, fc.integer({ min: 20_000, max: 400_000 }), (effort, slice) => {
        const search = fakeSearch(NEVER);
        const proof = fakeProof(NEVER);
        const decider = sideBySide(search, proof, { effort });
        while (!decider.finished) {
          decider.advance(slice);
          expect(decider.effort.ticks).toBe(search.effort.ticks + proof.ticks);
          expect(proof.ticks).toBeLessThanOrEqual(search.effort.ticks);
          // the search works in slices, so that the proofs are never far behind
          expect(search.effort.ticks - proof.ticks).toBeLessThanOrEqual(50_000);
        }
        expect(Math.max(...search.slices)).toBeLessThanOrEqual(50_000);
        expect(decider.effort.ticks).toBe(effort);
        expect([decider.best, decider.impossible]).toEqual([null, null]);
      }),
    );
  });

  it('belongs to the search alone once it has a run, without proofs, and after the last of them', () => {
    fc.assert(
      fc.property(someTicks, someTicks, (effort, at) => {
        const found = fakeSearch(at);
        const proof = fakeProof(NEVER);
        const decider = sideBySide(found, proof, { effort });
        while (!decider.finished) decider.advance(100_000);
        // the slice in which it finds a run is the last of which the proofs know
        expect(proof.ticks).toBeLessThanOrEqual(at);
        expect(decider.effort.ticks).toBe(effort);
        const alone = fakeSearch(NEVER);
        const without = sideBySide(alone, null, { effort });
        while (!without.finished) without.advance(100_000);
        expect([without.effort.ticks, alone.effort.ticks]).toEqual([effort, effort]);
        const over = fakeProof(NEVER, at);
        const rest = sideBySide(fakeSearch(NEVER), over, { effort });
        while (!rest.finished) rest.advance(100_000);
        expect(over.ticks).toBeLessThan(at + 50_000);
        expect(rest.effort.ticks).toBe(effort);
      }),
    );
  });

  it('advances by what is asked for, and a slice at most beyond', () => {
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 0, max: 300_000 }), { minLength: 1, maxLength: 8 }), (slices) => {
        const decider = sideBySide(fakeSearch(NEVER), fakeProof(NEVER));
        for (const slice of slices) {
          const before = decider.effort.ticks;
          decider.advance(slice);
          // at least one tick, so that known runs are tried
          expect(decider.effort.ticks).toBeGreaterThanOrEqual(before + Math.max(1, slice));
          expect(decider.effort.ticks).toBeLessThanOrEqual(before + Math.max(1, slice) + 50_000);
        }
      }),
    );
  });

  it('ends with a proof, unless there is a run', () => {
    const decider = sideBySide(fakeSearch(NEVER), fakeProof(200_000), { effort: 1_000_000 });
    decider.advance(1_000_000);
    expect([decider.impossible, decider.finished, decider.effort.ticks]).toEqual([PROOF, true, 400_000]);
    // a run outdoes what a broken checker would accept
    const both = sideBySide(fakeSearch(10), fakeProof(0), { effort: 1_000_000 });
    both.advance(1_000_000);
    expect(both.best).not.toBeNull();
    expect([both.impossible, both.effort.ticks]).toEqual([null, 1_000_000]);
  });

  it('ends with the search, and when it is stopped', () => {
    const decider = sideBySide(fakeSearch(NEVER, 120_000), null);
    decider.advance(1_000_000);
    expect([decider.finished, decider.effort.ticks]).toEqual([true, 150_000]);
    let asked = 0;
    const stopped = sideBySide(fakeSearch(NEVER), null, { effort: 1_000_000, isStopped: () => ++asked === 2 });
    stopped.advance(1_000_000);
    expect([stopped.finished, stopped.effort.ticks]).toEqual([false, 100_000]);
  });

  it('is divided by one rule', () => {
    fc.assert(
      fc.property(fc.nat(1e9), fc.nat(1e9), (search, effort) => {
        const share = proofShare(search, effort);
        expect(share).toBeGreaterThanOrEqual(0);
        expect(share).toBeLessThanOrEqual(search);
        expect(search + share <= effort || share === 0).toBe(true);
        // as much as it may be
        expect(share === search || search + share === effort || search >= effort).toBe(true);
      }),
    );
    expect(proofShare(123, NEVER)).toBe(123);
  });
});
