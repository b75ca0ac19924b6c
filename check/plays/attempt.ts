import type { BodyKind } from '../../engine/index.ts';
import type { PlayOutcome, PlayVerdict } from '../../game/index.ts';
import { wilsonInterval } from '../../solver/measure/robustness/index.ts';

/**
 * Why an attempt failed: she touched a hazard; she was `lost`; the time was up (`timeout`); the player
 * gave up (`left`); or she reached the black hole with too few `minerals`.
 */
export type FailureCause =
  | {
      /** The kind of the object; `asteroid` means a deadly one. */
      readonly kind: Exclude<BodyKind, 'blackHole'>;
      /** Index within the level's list of that kind, from 0. */
      readonly index: number;
    }
  | {
      /** What happened. */
      readonly kind: 'lost' | 'timeout' | 'left' | 'minerals';
      /** No object is to blame. */
      readonly index: null;
    };

/** What one play turned out to be when it was simulated again. */
export interface Attempt {
  /** Index of the play within the plays that were given, from 0. */
  readonly play: number;
  /** How it ended. */
  readonly outcome: PlayOutcome;
  /** Why it failed; null when it succeeded. */
  readonly cause: FailureCause | null;
  /** Where her centre was at its end, px. */
  readonly x: number;
  /** See {@link Attempt.x}, px. */
  readonly y: number;
  /** Ticks that it lasted. */
  readonly tick: number;
  /** When it ended, s from the start. */
  readonly time: number;
  /** Different minerals that she collected. */
  readonly minerals: number;
  /** The ticks at which the button changed before its end: press, release, press, and so on. */
  readonly edges: readonly number[];
  /** The asteroids that the gun pulled her towards, in order, without repetitions in a row; indices from 0. */
  readonly route: readonly number[];
}

/** A play that does not count, and why. */
export interface RefusedPlay {
  /** Index of the play within the plays that were given, from 0. */
  readonly play: number;
  /**
   * `unknown-engine`: made with another engine; `stale-level`: of another level, or another version of it; `other-accuracy`: at
   * another accuracy; `claim-differs`: it does not end as it claims; `too-long`: it takes too much work or lasts too long.
   */
  readonly verdict: Extract<PlayVerdict, 'unknown-engine' | 'stale-level' | 'other-accuracy' | 'claim-differs' | 'too-long'>;
  /** What was expected and what was found. */
  readonly message: string;
}

/** Whether a play counts as an attempt. */
export const isAttempt = (replayed: Attempt | RefusedPlay): replayed is Attempt => 'outcome' in replayed;

/** Who made a play, and when. */
export interface PlayedBy {
  /** The player. */
  readonly player: string;
  /** Sorts the plays of the player; the earliest that counts is the first attempt. No two are equal. */
  readonly order: number;
}

/** A share of attempts that succeed. */
export interface Share {
  /** How many attempts there are. */
  readonly attempts: number;
  /** How many of them succeed. */
  readonly successes: number;
  /** Their share, 0 to 1; 0 without attempts. */
  readonly share: number;
  /** Lower end of the 95 % confidence interval (Wilson's score interval), 0 to 1. */
  readonly low: number;
  /** Upper end of the 95 % confidence interval, 0 to 1. */
  readonly high: number;
}

/** How often players succeed at their first, second, ... attempt. */
export interface AttemptNumber extends Share {
  /** Which attempt, from 1. */
  readonly number: number;
  /** How many players succeed for the first time. */
  readonly first: number;
}

/** A share with its interval. */
export const shareOf = (successes: number, attempts: number): Share => ({
  attempts,
  successes,
  share: attempts === 0 ? 0 : successes / attempts,
  ...wilsonInterval(successes, attempts),
});

/**
 * Counts successes by attempt number.
 * @param attempts the attempts
 * @param by who made each play, by the index of the play; null if nobody knows
 * @returns a row for each attempt number, ascending
 */
export function byAttemptNumber(attempts: readonly Attempt[], by: (play: number) => PlayedBy | null): AttemptNumber[] {
  const players = new Map<string, { order: number; succeeds: boolean }[]>();
  for (const { play, cause } of attempts) {
    const played = by(play);
    if (played === null) continue;
    const own = players.get(played.player) ?? [];
    players.set(played.player, own);
    own.push({ order: played.order, succeeds: cause === null });
  }
  const rows: { attempts: number; successes: number; first: number }[] = [];
  for (const own of players.values()) {
    own.sort((a, b) => a.order - b.order);
    let hasSucceeded = false;
    for (const [i, { succeeds }] of own.entries()) {
      if (i === rows.length) rows.push({ attempts: 0, successes: 0, first: 0 });
      rows[i].attempts++;
      if (!succeeds) continue;
      rows[i].successes++;
      if (!hasSucceeded) rows[i].first++;
      hasSucceeded = true;
    }
  }
  return rows.map(({ attempts: all, successes, first }, i) => ({ number: i + 1, ...shareOf(successes, all), first }));
}
