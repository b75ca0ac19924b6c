import { joinHolds, type Terms } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import {
  type Attempt,
  type AttemptNumber,
  byAttemptNumber,
  isAttempt,
  type PlayedBy,
  type RefusedPlay,
  type Share,
  shareOf,
} from './attempt.ts';
import { type EdgeStatistics, edgeStatistics } from './edges.ts';
import { type CauseStatistics, causesOf, clustersOf, type FailureCluster } from './failures.ts';
import { chooseReference, knownRuns, type Reference, type RouteStatistics, routesOf } from './routes.ts';

/** What players teach about a level. */
export interface PlayStatistics extends Share {
  /** How many players are known. */
  readonly players: number;
  /** How many of them succeed at least once. */
  readonly playersWhoSucceed: number;
  /** Index n: how many attempts reach the black hole with n different minerals. */
  readonly minerals: readonly number[];
  /** Plays that do not count, in the order of the plays. */
  readonly refused: readonly RefusedPlay[];
  /** The attempts that count, in the order of the plays. */
  readonly all: readonly Attempt[];
  /** Why attempts fail, the most frequent cause first. */
  readonly causes: readonly CauseStatistics[];
  /** Where attempts fail, the largest cluster first. */
  readonly clusters: readonly FailureCluster[];
  /** Index n: how many attempts fail from second n to n + 1. */
  readonly failureTimes: readonly number[];
  /** Success by attempt number. */
  readonly byAttempt: readonly AttemptNumber[];
  /** The ways by which attempts succeed, the most frequent first. */
  readonly routes: readonly RouteStatistics[];
  /** The run that presses and releases are compared with; null if the level has none and no attempt succeeds. */
  readonly reference: Reference | null;
  /** After which press or release of the reference attempts fail; empty without a reference. */
  readonly edges: readonly EdgeStatistics[];
}

/** Options of {@link collectStatistics}. */
export interface StatisticsOptions {
  /**
   * Who made each play, by its index; null if nobody knows. Such plays count, but not by attempt number. By default one player
   * made all of them, in the order given.
   */
  readonly by?: readonly (PlayedBy | null)[];
  /** The run to compare presses and releases with; by default it is chosen from the level's own runs and the players'. */
  readonly reference?: Reference;
}

/**
 * Says how players fare: how often they succeed, and where, when and why they fail. The order of the plays does not matter but for
 * the indices of plays, and for attempt numbers unless `by` has them.
 * @param level the level
 * @param terms under which the level's own runs are simulated
 * @param replayed what plays turned out to be when they were simulated again, in any order
 * @param options who played, and what presses and releases are compared with
 */
export function collectStatistics(
  level: Level,
  terms: Terms,
  replayed: readonly (Attempt | RefusedPlay)[],
  options: StatisticsOptions = {},
): PlayStatistics {
  const sorted = [...replayed].sort((a, b) => a.play - b.play);
  const all = sorted.filter(isAttempt);
  const refused = sorted.filter((play): play is RefusedPlay => !isAttempt(play));
  const by = (play: number): PlayedBy | null => (options.by === undefined ? { player: '', order: play } : options.by[play]);
  const playersOf = (attempts: readonly Attempt[]): number =>
    new Set(attempts.flatMap(({ play }) => by(play)?.player ?? [])).size;
  const successes = all.filter(({ cause }) => cause === null);
  const minerals = new Array<number>(level.minerals.length + 1).fill(0);
  for (const attempt of all) if (attempt.outcome === 'completed') minerals[attempt.minerals]++;
  const known = knownRuns(level, terms);
  const reference = options.reference ?? chooseReference(known, all);
  const names = new Map(known.toReversed().map(({ route, name }) => [route, name]));
  return {
    ...shareOf(successes.length, all.length),
    players: playersOf(all),
    playersWhoSucceed: playersOf(successes),
    minerals,
    refused,
    all,
    causes: causesOf(all),
    clusters: clustersOf(all),
    failureTimes: failureTimesOf(all),
    byAttempt: byAttemptNumber(all, by),
    routes: routesOf(all, names),
    reference,
    edges: reference === null ? [] : edgeStatistics(joinHolds(reference.holds).flat(), all),
  };
}

function failureTimesOf(attempts: readonly Attempt[]): number[] {
  const seconds: number[] = [];
  for (const { cause, time } of attempts) {
    if (cause === null) continue;
    const second = Math.floor(time);
    while (seconds.length <= second) seconds.push(0);
    seconds[second]++;
  }
  return seconds;
}
