import { describe, expect, it } from 'vitest';
import type { AccuracyName } from '../../engine/index.ts';
import {
  ALL_ACCURACIES,
  ALL_PROVERS,
  attackCompletable,
  attackLevel,
  attackMixed,
  attackOrbits,
  attackSolvable,
  emptyMixed,
  emptyOrbits,
  emptySolvable,
  emptyTally,
  type Prover,
  SMALL,
} from '../attackers/index.ts';
import { isHunt } from '../depth.ts';
import { pack } from '../levels/shipped-pack.ts';

const CONTINUOUS = ALL_ACCURACIES.filter((name) => name !== 'arcade');

/** Levels per kind and accuracy. `npm run bench -- soak` tries thousands of claims more. */
const SEEDS: Readonly<Partial<Record<Prover, number>>> = {
  flowpipe: 2,
  doomed: 2,
  enclosed: 2,
  covered: 4,
  'line-trap': 10,
  'dead-end': 8,
  orbits: 2,
};

/** The first seed, where the levels of earlier ones take seconds each. `npm run bench -- soak` attacks those as well. */
const FIRST: Readonly<Partial<Record<Prover, number>>> = { flowpipe: 12, orbits: 2 };

const ENOUGH = 6;

/** The accuracies at which a kind is attacked: all for which it has proofs when hunting, otherwise at most two. */
const ACCURACIES: Readonly<Record<Prover, readonly AccuracyName[]>> = {
  'nothing-in-range': isHunt ? ALL_ACCURACIES : ['arcade', 'standard'],
  'starts-in-hazard': isHunt ? ALL_ACCURACIES : ['fast', 'precise'],
  'out-of-range': isHunt ? ALL_ACCURACIES : ['arcade', 'precise'],
  enclosed: isHunt ? ALL_ACCURACIES : ['arcade', 'fast'],
  covered: isHunt ? CONTINUOUS : ['fast', 'standard'],
  'line-trap': isHunt ? ALL_ACCURACIES : ['arcade', 'precise'],
  'dead-end': ['precise'],
  doomed: isHunt ? ALL_ACCURACIES : ['arcade', 'fast'],
  flowpipe: isHunt ? CONTINUOUS : ['standard'],
  orbits: ['precise'],
};

describe.each(ALL_PROVERS)('false claims: %s', (prover) => {
  const accuracies = ACCURACIES[prover];

  it.each(accuracies)('none is proved, and no certificate of another level is accepted: %s', (accuracy) => {
    const tally = emptyTally();
    // For some seeds the levels have nothing to prove.
    const levels = SEEDS[prover] ?? 6;
    const first = FIRST[prover] ?? 0;
    for (let seed = first; seed < first + 10 * levels && (tally.levels < levels || tally.claims < ENOUGH); seed++)
      attackLevel(prover, accuracy, seed, SMALL, tally);
    expect(tally.accepted.map(({ by, seed, about }) => ({ by, seed, about }))).toEqual([]);
    // Otherwise the test would be vacuous.
    expect(tally.levels).toBeGreaterThanOrEqual(levels);
    expect(tally.claims).toBeGreaterThanOrEqual(ENOUGH);
    expect(tally.foreign).toBeGreaterThanOrEqual(ENOUGH);
  });
});

describe('orbits, without a prover', () => {
  it('no grid proves that an object is out of reach which a run touches', () => {
    const tally = emptyOrbits();
    for (const seed of [1, 3, 4, 5, 10, 11, 76]) attackOrbits(seed, { grids: 1, plays: 3, ticks: 300, searchTicks: 300 }, tally);
    expect(tally.wrong.map(({ seed, about }) => ({ seed, about }))).toEqual([]);
    // Otherwise the test would be vacuous.
    expect(tally.ending).toBeGreaterThan(2);
    expect(tally.claims).toBeGreaterThan(60);
  });
});

describe('many false claims for every prover, whatever the checker would say', () => {
  const wrong = ({ proved }: ReturnType<typeof emptyMixed>) =>
    proved.map(({ prover, level, about }) => ({ prover, level, about }));

  it.each(isHunt ? ALL_ACCURACIES : (['arcade', 'precise'] as const))('levels of any style: %s', (accuracy) => {
    const tally = emptyMixed();
    for (let seed = 0; seed < (isHunt ? 200 : 20); seed++) attackMixed(seed, accuracy, tally);
    expect(wrong(tally)).toEqual([]);
    // Otherwise the test would be vacuous.
    expect(tally.claims).toBeGreaterThan(200);
    for (const prover of ['out-of-range', 'enclosed', 'doomed'] as const) expect(tally.twins[prover], prover).toBeGreaterThan(0);
  });

  it.each(isHunt ? ALL_ACCURACIES : (['arcade', 'precise'] as const))(
    'shipped levels from states of their runs: %s',
    (accuracy) => {
      const tally = emptyMixed();
      for (const { level } of pack)
        for (const run of level.runs) attackCompletable(level, run.holds, accuracy, isHunt ? 5 : 90, tally);
      expect(wrong(tally)).toEqual([]);
      expect(tally.claims).toBeGreaterThan(40);
    },
  );
});

const SOLVED_AT = isHunt ? ALL_ACCURACIES : (['arcade', 'standard'] as const);

describe('levels that a known run completes, under any rules, with winds and wormholes', () => {
  it.each(SOLVED_AT)('none is proved impossible, and no certificate of its twin is accepted: %s', (accuracy) => {
    const tally = emptySolvable();
    for (let seed = 0; seed < 120; seed++) attackSolvable(seed, accuracy, 0, tally);
    expect(tally.accepted).toEqual([]);
    // Otherwise the test would be vacuous.
    expect(tally.completed).toBeGreaterThan(3);
    expect(tally.collected).toBeGreaterThan(10);
    // what the twins' certificates were made from
    expect(tally.twins).toBeGreaterThan(3);
  });
});
