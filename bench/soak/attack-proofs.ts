import { writeFileSync } from 'node:fs';
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
  LARGE,
  type Prover,
} from '../../tests/attackers/index.ts';
import { type Asked, number, oneOf, packLevels, text } from '../harness/index.ts';
import type { Attacked } from './span.ts';

/** What this attack can be told. */
export const PROOF_OPTIONS = {
  claims: number(10_000, 'proofs: claims for each kind and accuracy'),
  claimSeconds: number(null, 'proofs: time for each; an equal part of the time of all when left out'),
  prover: oneOf(ALL_PROVERS, null, 'proofs: only one kind'),
  accuracy: oneOf(ALL_ACCURACIES, null, 'proofs: only one accuracy'),
  out: text('proofs: a file for what was accepted, as JSON'),
};

/**
 * Attacks every kind of proof at every accuracy with claims that are known to be false; every other level has rules of its own,
 * and half of each have winds and wormholes. Then it gives all provers many false claims in levels of any style, without the
 * checker, among them the shipped levels from states of their runs, and lets them try levels that runs complete. A false claim that
 * is accepted is a bug.
 * @param most - time for all of them together, s
 */
export function attackProofs(
  { claims, claimSeconds, prover: only, accuracy: at, out }: Asked<typeof PROOF_OPTIONS>,
  from: number,
  most: number,
): Attacked {
  const provers = ALL_PROVERS.filter((name) => only === null || name === only);
  const accuracies = ALL_ACCURACIES.filter((name) => at === null || name === at);
  const pairs =
    provers.flatMap((prover) => accuracies.filter((accuracy) => covers(prover, accuracy))).length + 2 * accuracies.length + 1;
  const seconds = claimSeconds ?? most / pairs;
  let tried = 0;
  const accepted: unknown[] = [];
  console.log('proof             accuracy  levels  claims  foreign  mutated    ruled  searched  accepted');
  for (const prover of provers) {
    for (const accuracy of accuracies) {
      if (!covers(prover, accuracy)) continue;
      const tally = emptyTally();
      const until = Date.now() + 1000 * seconds;
      let seed = from;
      for (; tally.claims < claims && Date.now() < until; seed++) attackLevel(prover, accuracy, seed, LARGE, tally);
      const numbers = [
        tally.levels,
        tally.claims,
        tally.foreign,
        tally.mutated,
        tally.ruled,
        tally.searched,
        tally.accepted.length,
      ];
      console.log(
        `${prover.padEnd(17)} ${accuracy.padEnd(8)} ${numbers.map((n) => String(n).padStart(7)).join(' ')}  (${seed - from} seeds)`,
      );
      for (const { by, seed: at, verified, about } of tally.accepted.slice(0, 5)) {
        console.log(
          `  ACCEPTED: seed ${at}, by ${by}, about ${JSON.stringify(about)}${verified ? '' : ', but the checker refuses it'}`,
        );
      }
      accepted.push(...tally.accepted);
      tried += tally.claims;
    }
  }
  const orbits = emptyOrbits();
  const end = Date.now() + 1000 * seconds;
  for (let seed = from; provers.includes('orbits') && Date.now() < end; seed++)
    attackOrbits(seed, { grids: 2, plays: 4, ticks: 600, searchTicks: 3000 }, orbits);
  console.log('\norbits, without a prover    levels  ending  claims  searched  accepted');
  const { levels, ending, claims: asked, searched, wrong } = orbits;
  console.log(`${' '.repeat(25)} ${[levels, ending, asked, searched, wrong.length].map((n) => String(n).padStart(8)).join('')}`);
  accepted.push(...wrong);
  tried += asked;
  console.log('\nevery prover, without the checker    claims  proved');
  for (const accuracy of accuracies) {
    const tally = emptyMixed();
    const until = Date.now() + 1000 * seconds;
    for (const { level } of packLevels())
      for (const { holds } of level.runs) if (Date.now() < until) attackCompletable(level, holds, accuracy, 20, tally);
    for (let seed = from; tally.claims < claims && Date.now() < until; seed++) attackMixed(seed, accuracy, tally);
    console.log(`${accuracy.padEnd(34)} ${String(tally.claims).padStart(8)} ${String(tally.proved.length).padStart(7)}`);
    for (const { prover, about } of tally.proved.slice(0, 5))
      console.log(`  PROVED: by ${prover}, about ${JSON.stringify(about)}`);
    accepted.push(...tally.proved);
    tried += tally.claims;
  }
  console.log('\nany level         accuracy  levels  completed  collected  proved  twins  accepted');
  for (const accuracy of accuracies) {
    const tally = emptySolvable();
    const until = Date.now() + 1000 * seconds;
    for (let seed = from; Date.now() < until; seed++) attackSolvable(seed, accuracy, 2000, tally);
    const numbers = [tally.levels, tally.completed, tally.collected, tally.proved, tally.twins, tally.accepted.length];
    console.log(`${' '.repeat(17)} ${accuracy.padEnd(8)} ${numbers.map((n) => String(n).padStart(7)).join('  ')}`);
    if (tally.accepted.length > 0) console.log(`  ACCEPTED: seeds ${tally.accepted.join(', ')}`);
    accepted.push(...tally.accepted.map((seed) => ({ by: 'solvable', accuracy, seed })));
  }
  if (out !== null) writeFileSync(out, JSON.stringify(accepted, null, 1));
  return { tried, bugs: accepted.length, told: `${tried} false claims` };
}

/** Whether this kind of proof exists for the accuracy. */
function covers(prover: Prover, accuracy: string): boolean {
  if (prover === 'dead-end' || prover === 'orbits') return accuracy === 'precise';
  return accuracy !== 'arcade' || (prover !== 'flowpipe' && prover !== 'covered');
}
