import { wilsonInterval } from '../../solver/measure/robustness/index.ts';
import type { Attempt } from './attempt.ts';

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
