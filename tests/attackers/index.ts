import { ACCURACIES, type AccuracyName, compile } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { type About, createSearch, PROVERS, type Proof, proveBy, verifyProof } from '../../solver/index.ts';
import { seeded } from '../scenes/seeded.ts';
import { type FalseClaim, hugged, isFalse, somePoses, thingAt, thingBeside, trueTouches, withoutThing } from './claims.ts';
import { mutated } from './mutated.ts';
import { otherRules, ownRules } from './own-rules.ts';
import { type Play, playLevel, STYLES } from './plays.ts';
import { levelFor, type Prover } from './styles.ts';
import { withWindsAndWormholes } from './winds-and-wormholes.ts';

export { attackCompletable, attackMixed, emptyMixed } from './mixed.ts';
export { mixedLevel } from './mixed-level.ts';
export { attackOrbits, emptyOrbits } from './orbits.ts';
export { playLevel, STYLES } from './plays.ts';
export { attackSolvable, emptySolvable } from './solvable.ts';
export type { Prover };
export const ALL_PROVERS = Object.keys(PROVERS) as Prover[];
export const ALL_ACCURACIES = Object.keys(ACCURACIES) as AccuracyName[];

/** What was tried against one kind of proof at one accuracy, and the results. */
export interface Tally {
  /**
   * Levels for which the prover has a proof once the object is far away, or hazards are larger; without any, the attack would
   * be vacuous.
   */
  levels: number;
  /** False claims in such levels that the prover was asked to prove. */
  claims: number;
  /** Certificates of similar true claims that were given to the checker for a false one. */
  foreign: number;
  /** The same with some number or name changed. */
  mutated: number;
  /** Certificates made under other rules that were given to the checker for a false claim. */
  ruled: number;
  /** Proved claims that were attacked by a search. */
  searched: number;
  accepted: Refutation[];
}

/** A false claim that was accepted, with all that is needed to reproduce it. */
export interface Refutation {
  readonly by: 'prover' | 'foreign' | 'mutated' | 'ruled' | 'search';
  readonly prover: Prover;
  readonly accuracy: AccuracyName;
  readonly seed: number;
  readonly level: Level;
  readonly about: About;
  readonly holds: Play['holds'];
  readonly proof: Proof;
  /** What the checker says about it. */
  readonly verified: boolean;
}

export const emptyTally = (): Tally => ({ levels: 0, claims: 0, foreign: 0, mutated: 0, ruled: 0, searched: 0, accepted: [] });

/** How much is tried in one level. */
export interface Effort {
  readonly plays: number;
  readonly posesPerPlay: number;
  readonly ticks: number;
  readonly mutations: number;
  /** Ticks of search against what is proved; 0 for none. */
  readonly searchTicks: number;
}

export const SMALL: Effort = { plays: 2, posesPerPlay: 6, ticks: 400, mutations: 1, searchTicks: 0 };
export const LARGE: Effort = { plays: 4, posesPerPlay: 15, ticks: 900, mutations: 2, searchTicks: 2000 };

const MAX_TIME = 60;

/**
 * Attacks one level of the seed. Every other level has rules of its own, and half of each have winds and wormholes. Adds the
 * counts to the tally.
 */
export function attackLevel(prover: Prover, accuracy: AccuracyName, seed: number, effort: Effort, tally: Tally): void {
  const random = seeded(seed * 977 + prover.length * 31 + accuracy.length);
  const plain = levelFor(prover, random);
  const chance = seeded(seed * 613 + 7);
  const ruled = seed % 2 === 1 ? { ...plain, rules: ownRules(chance) } : plain;
  const level = seed % 4 >= 2 ? withWindsAndWormholes(ruled, chance) : ruled;
  const options = { accuracy, maxTime: MAX_TIME };
  const prove = (of: Level, about: About) => proveBy(prover, of, about, options);
  // the styles place the black hole far away
  const away: About = { kind: 'blackHole' };
  const twin = prove(level, away) ?? (prover === 'nothing-in-range' ? prove({ ...level, range: level.range / 2 }, away) : null);
  const ruledTwin = prove(otherRules(level, chance), away);
  const ask = (claim: FalseClaim, like: Proof | null) => {
    tally.claims++;
    const found = (by: Refutation['by'], proof: Proof, verified: boolean) =>
      tally.accepted.push({
        by,
        prover,
        accuracy,
        seed,
        level: claim.level,
        about: claim.about,
        holds: claim.play.holds,
        proof,
        verified,
      });
    const proof = prove(claim.level, claim.about);
    if (proof !== null) found('prover', proof, verifyProof(claim.level, proof).ok);
    // what is true under other rules proves nothing here, even if they differ by a thousandth only
    for (const otherwise of [ruledTwin, prove(otherRules(claim.level, chance), claim.about)]) {
      if (otherwise === null) continue;
      tally.ruled++;
      const other: Proof = { ...otherwise, about: claim.about, covers: [accuracy] };
      if (verifyProof(claim.level, other).ok) found('ruled', other, true);
    }
    if (like === null) return;
    const other: Proof = { ...like, about: claim.about, covers: [accuracy] };
    tally.foreign++;
    if (verifyProof(claim.level, other).ok) found('foreign', other, true);
    for (let n = 0; n < effort.mutations; n++) {
      const changed = mutated(other, random);
      tally.mutated++;
      if (verifyProof(claim.level, changed).ok) found('mutated', changed, true);
    }
  };

  let counts = twin !== null;
  if (counts) tally.levels++;
  for (let n = 0; n < effort.plays; n++) {
    const style = STYLES[Math.floor(random() * STYLES.length)];
    const play = playLevel(level, accuracy, style, random, effort.ticks);
    const things = somePoses(play, random, effort.posesPerPlay).map((pose) => thingAt(level, pose, random));
    if (prover === 'line-trap') {
      for (let k = 0; k < 4; k++) things.push(thingBeside(level, random));
    }
    const claims = trueTouches(level, accuracy, play, things);
    if (twin !== null) for (const claim of claims) ask(claim, twin);
    // hazards that almost shut her out
    const closely = prover === 'covered';
    for (const claim of closely ? claims : claims.slice(0, 3)) {
      const { near, shut } = hugged(claim, closely, random);
      if (!isFalse(near, accuracy)) continue;
      const like = prove(shut, claim.about) ?? prove(withoutThing(near), claim.about);
      if (like === null) continue;
      if (!counts) tally.levels++;
      counts = true;
      ask(near, like);
    }
  }
  if (effort.searchTicks > 0) attackWhatHolds(prover, accuracy, seed, level, random, effort, tally);
}

/** Places a black hole just beyond where she came, and searches for a run against what is proved about it. */
function attackWhatHolds(
  prover: Prover,
  accuracy: AccuracyName,
  seed: number,
  level: Level,
  random: () => number,
  { ticks, searchTicks }: Effort,
  tally: Tally,
): void {
  const play = playLevel(level, accuracy, STYLES[Math.floor(random() * STYLES.length)], random, ticks);
  const [pose] = somePoses(play, random, 1);
  if (pose === undefined) return;
  const { radius } = thingAt(level, pose, random);
  const turn = 6.2832 * random();
  const far = radius + 10 + 30 * random();
  const blackHole = { id: null, x: pose.x + far * Math.cos(turn), y: pose.y + far * Math.sin(turn), radius };
  const of = { ...level, blackHole };
  const about: About = { kind: 'blackHole' };
  const proof = proveBy(prover, of, about, { accuracy, maxTime: MAX_TIME });
  if (proof === null) return;
  tally.searched++;
  const search = createSearch(compile(of, accuracy), { seed });
  search.advance(searchTicks);
  const [solution] = search.solutions;
  if (solution === undefined) return;
  tally.accepted.push({
    by: 'search',
    prover,
    accuracy,
    seed,
    level: of,
    about,
    holds: solution.holds,
    proof,
    verified: verifyProof(of, proof).ok,
  });
}
