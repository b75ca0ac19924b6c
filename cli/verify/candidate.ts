import { compile, simulate, TICK_RATE, WorkBudget } from '../../engine/index.ts';
import { createVerifier, encodePlay, type Play } from '../../game/index.ts';
import type { KnownLevel } from './catalogue.ts';

/** Ticks by which the end of a play may move when its level changes. */
const NEAR = 120;
/** Levels that are tried for a play. */
const MOST_LEVELS = 200;
/** Work for each of them, pieces of motion. */
const WORK = 20_000;

/** A level that may be what the level of a play has become. */
export interface Candidate {
  readonly known: KnownLevel;
  /** Whether the inputs of the play lead to just what it claims there. */
  readonly isExact: boolean;
}

const isAsClaimed = (play: Play, { level, hash }: KnownLevel): boolean =>
  createVerifier(level).verify(encodePlay({ ...play, level: hash }), { accuracy: play.accuracy, maxWork: WORK }).verdict === 'ok';

/** The level on which the inputs of a play end as it claims, at nearly the same tick; null if they do so on none. */
export function candidateFor(play: Play, levels: readonly KnownLevel[]): Candidate | null {
  const { tick, minerals, outcome } = play.claim;
  // whatever she does, she is somewhere in between on every level
  if (outcome === 'left' || outcome === 'timeout') return null;
  let nearest: KnownLevel | null = null;
  let distance = NEAR + 1;
  for (const known of levels.slice(0, MOST_LEVELS)) {
    const run = simulate(compile(known.level, play.accuracy), play.holds, {
      maxTime: (tick + NEAR) / TICK_RATE,
      budget: new WorkBudget(WORK),
      record: false,
    });
    const apart = Math.abs(run.tick - tick);
    if (run.outcome !== outcome || run.minerals.length !== minerals || apart >= distance) continue;
    if (isAsClaimed(play, known)) return { known, isExact: true };
    nearest = known;
    distance = apart;
  }
  return nearest === null ? null : { known: nearest, isExact: false };
}
