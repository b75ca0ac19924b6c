import { type AccuracyName, compile, createSimulation, STATE_SIZE, simulate, WorkBudget } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { type About, PROVERS, proveBy } from '../../solver/index.ts';
import { seeded } from '../scenes/seeded.ts';
import { type FalseClaim, hugged, isFalse, somePoses, thingAt, trueTouches } from './claims.ts';
import { mixedLevel } from './mixed-level.ts';
import { playLevel, STYLES } from './plays.ts';
import type { Prover } from './styles.ts';

// Many cheap claims that a known run refutes, each for every prover. The checker is not asked: a prover that proves a false claim
// has an error even if the checker would refuse the certificate.

const ALL = Object.keys(PROVERS) as Prover[];
const MAX_TIME = 60;

/** What each prover may spend on a claim, pieces of motion; on every so many claims it may spend more. */
const LITTLE = 400;
const MORE = 4000;
const SOMETIMES = 6;

/** Results of many false claims. */
export interface MixedTally {
  /** False claims; each was given to all provers. */
  claims: number;
  /** Claims for each prover that it did not have to leave alone because of their effects. */
  readonly asked: Record<string, number>;
  /** Levels like those of the claims, with the object far away, that each prover proves, so that it is not idle. */
  readonly twins: Record<string, number>;
  /** What was proved although a run refutes it. */
  readonly proved: {
    readonly prover: Prover;
    readonly accuracy: AccuracyName;
    readonly level: Level;
    readonly about: About;
    readonly holds: readonly Hold[];
  }[];
}

export const emptyMixed = (): MixedTally => ({ claims: 0, asked: {}, twins: {}, proved: [] });

const countOf = (counts: Record<string, number>, name: string): void => {
  counts[name] = (counts[name] ?? 0) + 1;
};

/** Asks every prover about a false claim. */
function ask({ level, about, play }: FalseClaim, accuracy: AccuracyName, tally: MixedTally): void {
  tally.claims++;
  const most = tally.claims % SOMETIMES === 0 ? MORE : LITTLE;
  for (const prover of ALL) {
    countOf(tally.asked, prover);
    const proof = proveBy(prover, level, about, { accuracy, maxTime: MAX_TIME, budget: new WorkBudget(most) });
    if (proof !== null) tally.proved.push({ prover, accuracy, level, about, holds: play.holds });
  }
}

/**
 * Attacks a level of any style, from a seed: objects are placed where plays came, and some are hugged by novae that the play just
 * misses.
 */
export function attackMixed(seed: number, accuracy: AccuracyName, tally: MixedTally): void {
  const level = mixedLevel(seed);
  const random = seeded(seed * 2003 + accuracy.length);
  const budget = () => new WorkBudget(LITTLE);
  for (const prover of ALL) {
    const options = { accuracy, maxTime: MAX_TIME, budget: budget() };
    if (proveBy(prover, level, { kind: 'blackHole' }, options) !== null) countOf(tally.twins, prover);
  }
  for (let n = 0; n < 3; n++) {
    const style = STYLES[Math.floor(random() * STYLES.length)];
    // short plays as well: what a prover forgets at the start is found at the start
    const play = playLevel(level, accuracy, style, random, [20, 120, 400][n]);
    const things = somePoses(play, random, 6).map((pose) => thingAt(level, pose, random));
    const claims = trueTouches(level, accuracy, play, things);
    for (const claim of claims) ask(claim, accuracy, tally);
    for (const claim of claims.slice(0, 1)) {
      const { near } = hugged(claim, false, random);
      if (isFalse(near, accuracy)) ask(near, accuracy, tally);
    }
  }
}

/**
 * Attacks a level with a run that completes it: as it is, and started later, in states of the run from which the rest of the run
 * completes it, too.
 * @param every ticks between those states
 */
export function attackCompletable(
  level: Level,
  holds: readonly Hold[],
  accuracy: AccuracyName,
  every: number,
  tally: MixedTally,
): void {
  const simulation = createSimulation(compile(level, accuracy));
  const state = new Float64Array(STATE_SIZE);
  const isHeld = (tick: number) => holds.some(([press, release]) => press <= tick && tick < release);
  while (simulation.ending === null && simulation.tick < 60 * MAX_TIME) {
    const { tick } = simulation;
    if (tick % every === 0) {
      simulation.readState(state);
      const [x, y, vx, vy] = state;
      const later = { ...level, astronaut: { ...level.astronaut, x, y, vx, vy }, runs: [] };
      const rest = holds.flatMap(([press, release]): Hold[] =>
        release > tick ? [[Math.max(0, press - tick), release - tick]] : [],
      );
      const isCompleted = simulate(compile(later, accuracy), rest, { maxTime: MAX_TIME }).outcome === 'completed';
      const play = { holds: rest, poses: [] };
      if (isCompleted) ask({ level: later, about: { kind: 'blackHole' }, play }, accuracy, tally);
    }
    simulation.advance(1, isHeld(tick));
  }
}
