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
import { optionValue } from '../harness.ts';
import { packLevels } from '../levels.ts';

/**
 * Attacks every kind of proof at every accuracy with claims that are known to be false; every other level has rules of its own,
 * and half of each have winds and wormholes. Then it gives all provers many false claims in levels of any style, without the
 * checker, among them the shipped levels from states of their runs, and lets them try levels that runs complete. Options on the command
 * line: --claims N (for each; 10000), --claim-seconds S (for each; an equal part of `most` when left out), --prover NAME,
 * --accuracy NAME, --from SEED, --out FILE (what was accepted, as JSON). Sets the exit code to 1 if a false claim is accepted.
 * @param most - time for all of them together, s
 */
export function attackProofs(most: number): void {
  const claims = Number(optionValue('--claims') ?? 10_000);
  const from = Number(optionValue('--from') ?? 0);
  const out = optionValue('--out');
  const provers = ALL_PROVERS.filter((name) => name === (optionValue('--prover') ?? name));
  const accuracies = ALL_ACCURACIES.filter((name) => name === (optionValue('--accuracy') ?? name));
  const pairs =
    provers.flatMap((prover) => accuracies.filter((accuracy) => covers(prover, accuracy))).length + 2 * accuracies.length + 1;
  const seconds = Number(optionValue('--claim-seconds') ?? most / pairs);
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
  if (accepted.length > 0) process.exitCode = 1;
}

/** Whether this kind of proof exists for the accuracy. */
function covers(prover: Prover, accuracy: string): boolean {
  if (prover === 'dead-end' || prover === 'orbits') return accuracy === 'precise';
  return accuracy !== 'arcade' || (prover !== 'flowpipe' && prover !== 'covered');
}
