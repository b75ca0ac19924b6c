import { describe, expect, it } from 'vitest';
import {
  ALL_ACCURACIES,
  ALL_PROVERS,
  attackLevel,
  attackSolvable,
  emptySolvable,
  emptyTally,
  type Prover,
  SMALL,
} from '../../bench/soak/attack/index.ts';

/** Levels for each kind and accuracy: `npm run bench:soak` tries thousands of claims more. */
const SEEDS: Readonly<Partial<Record<Prover, number>>> = {
  flowpipe: 2,
  doomed: 2,
  enclosed: 2,
  covered: 4,
  'line-trap': 16,
  'dead-end': 12,
};

const ENOUGH = 6;

/** Kinds that make no proof for an accuracy. */
const NEVER: Readonly<Partial<Record<Prover, readonly string[]>>> = {
  flowpipe: ['arcade'],
  covered: ['arcade'],
  'dead-end': ['arcade', 'fast', 'standard'],
};

describe.each(ALL_PROVERS)('claims known to be false: %s', (prover) => {
  const accuracies = ALL_ACCURACIES.filter((accuracy) => !NEVER[prover]?.includes(accuracy));

  it.each(accuracies)('none is proved, nor a certificate of another accepted: %s', (accuracy) => {
    const tally = emptyTally();
    // the levels of some seeds have nothing to prove
    const levels = SEEDS[prover] ?? 6;
    for (let seed = 0; seed < 10 * levels && (tally.levels < levels || tally.claims < ENOUGH); seed++)
      attackLevel(prover, accuracy, seed, SMALL, tally);
    expect(tally.accepted.map(({ by, seed, about }) => ({ by, seed, about }))).toEqual([]);
    // vacuous otherwise
    expect(tally.levels).toBeGreaterThanOrEqual(levels);
    expect(tally.claims).toBeGreaterThanOrEqual(ENOUGH);
    expect(tally.foreign).toBeGreaterThanOrEqual(ENOUGH);
  });
});

describe('levels that a script completes, under any rules, with winds and wormholes', () => {
  it.each(ALL_ACCURACIES)('none is proved impossible, nor a certificate of its twin accepted: %s', (accuracy) => {
    const tally = emptySolvable();
    for (let seed = 0; seed < 250; seed++) attackSolvable(seed, accuracy, 0, tally);
    expect(tally.accepted).toEqual([]);
    // vacuous otherwise
    expect(tally.completed).toBeGreaterThan(3);
    expect(tally.collected).toBeGreaterThan(20);
    expect(tally.proved).toBeGreaterThan(20);
  });
});
