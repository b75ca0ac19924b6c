import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile } from '../../engine/index.ts';
import { createAnytimeProof, createDecider, verifyProof, verifyRun } from '../../solver/index.ts';
import { itDeep, itQuick } from '../depth.ts';
import { at, LEVELS, level } from './impossible-levels.ts';

const DOOMED = LEVELS.doomed;
/** Completable without a press. */
const COASTS = level({ astronaut: { x: 0, y: 0, vx: 60 }, asteroids: [at(150, 100)] });
/** At rest, where finer sets prove nothing: she can wait for any time. */
const QUIET = LEVELS['line-trap'];

/** Orbits for as long as she likes, so that sets never end, and the black hole is far away. */
const COASTS_NOWHERE = level({ astronaut: { x: 0, y: 0, vx: 60 }, asteroids: [at(60, 100)], blackHole: { x: 900, y: 0 } });

/** More than all attempts take that fail at once. */
const PLENTY = 100_000_000;

describe('a proof with ever finer sets', () => {
  it('is found, and its checker accepts it', () => {
    const proving = createAnytimeProof(DOOMED, { accuracy: 'precise' });
    proving.advance(PLENTY);
    expect(proving.finished).toBe(true);
    expect(proving.proof?.about).toEqual({ kind: 'blackHole' });
    expect(verifyProof(DOOMED, proving.proof!)).toEqual({ ok: true });
  });

  it('is not found where there is a run', () => {
    const proving = createAnytimeProof(COASTS, { accuracy: 'precise' });
    proving.advance(2_000_000);
    expect(proving.proof).toBeNull();
  });

  itQuick('is about a mineral where all minerals are wanted', () => {
    const far = level({ astronaut: { x: 0, y: 0, vx: 60 }, asteroids: [at(150, 100)], minerals: [{ x: 0, y: 90 }] });
    const options = { accuracy: 'precise' } as const;
    const all = createAnytimeProof(far, { ...options, goal: { minerals: 'all' } });
    all.advance(20_000_000);
    const any = createAnytimeProof(far, options);
    any.advance(20_000_000);
    expect(any.proof).toBeNull();
    if (all.proof !== null) expect(all.proof.about).toEqual({ kind: 'mineral', index: 0 });
  });

  it('is not sought where she starts at rest', () => {
    const proving = createAnytimeProof(QUIET, { accuracy: 'precise' });
    expect([proving.finished, proving.nextLimit]).toEqual([true, 0]);
    proving.advance(PLENTY);
    expect([proving.proof, proving.ticks]).toEqual([null, 0]);
  });

  itDeep('never spends more than it was given', () => {
    fc.assert(
      fc.property(fc.constantFrom(DOOMED, COASTS, QUIET), fc.array(fc.nat(700_000), { maxLength: 6 }), (of, slices) => {
        const proving = createAnytimeProof(of, { accuracy: 'precise' });
        let given = 0;
        for (const slice of slices) {
          proving.advance(slice);
          given += slice;
          expect(proving.ticks).toBeLessThanOrEqual(given);
        }
      }),
    );
  });

  it('depends on the total only, not on how it is split', () => {
    fc.assert(
      fc.property(fc.constantFrom(DOOMED, COASTS), fc.array(fc.nat(400_000), { minLength: 1, maxLength: 6 }), (of, slices) => {
        const split = createAnytimeProof(of, { accuracy: 'precise' });
        for (const slice of slices) split.advance(slice);
        const whole = createAnytimeProof(of, { accuracy: 'precise' });
        whole.advance(slices.reduce((sum, slice) => sum + slice, 0));
        expect([split.ticks, split.proof, split.finished]).toEqual([whole.ticks, whole.proof, whole.finished]);
      }),
    );
  });

  it('is given up on request, in the middle of an attempt', () => {
    let asked = 0;
    const proving = createAnytimeProof(COASTS, { accuracy: 'precise', isStopped: () => ++asked > 2 });
    proving.advance(PLENTY);
    expect(proving.proof).toBeNull();
    expect(proving.finished).toBe(false);
    const after = asked;
    proving.advance(PLENTY);
    expect(asked).toBe(after + 1);
  });
});

describe('a search for a run and for a proof side by side', () => {
  itQuick('ends with the proof where there is no run', () => {
    const decider = createDecider(compile(DOOMED), { objective: 'first', effort: 10_000_000 });
    while (!decider.finished) decider.advance(50_000);
    expect(decider.finished).toBe(true);
    expect(decider.best).toBeNull();
    expect(verifyProof(DOOMED, decider.impossible!)).toEqual({ ok: true });
  });

  it('ends with a run where there is one', () => {
    const scene = compile(COASTS);
    const decider = createDecider(scene, { objective: 'first', effort: 10_000_000 });
    while (!decider.finished) decider.advance(50_000);
    expect(decider.impossible).toBeNull();
    expect(verifyRun(scene, decider.best!.holds, { minerals: 'any' })).not.toBeNull();
  });

  itDeep('spends the effort and no more, all of it on the search where finer sets prove nothing', () => {
    for (const [of, effort] of [
      [QUIET, 1_500_000],
      [COASTS_NOWHERE, 1_500_000],
    ] as const) {
      const decider = createDecider(compile(of), { objective: 'first', effort });
      while (!decider.finished) decider.advance(50_000);
      expect(decider.best).toBeNull();
      expect(decider.impossible).toBeNull();
      expect(decider.effort.ticks).toBeGreaterThanOrEqual(effort);
      expect(decider.effort.ticks).toBeLessThan(effort + 10_000);
      expect(decider.closest?.distance).toBeGreaterThan(0);
    }
  });

  it('gives the same for the same slices', () => {
    const run = () => {
      const decider = createDecider(compile(COASTS), { objective: 'robust', seed: 3 });
      for (let n = 0; n < 4; n++) decider.advance(30_000);
      return [decider.effort, decider.best, decider.closest];
    };
    expect(run()).toEqual(run());
  });
});
