import type { RunEvent } from '../../engine/index.ts';
import type { Attempt } from './attempt.ts';

/** A way through the level: the asteroids that the gun pulls her towards, in order. */
export interface RouteStatistics {
  /** The asteroids, indices from 0; none twice in a row. */
  readonly asteroids: readonly number[];
  /** How many attempts succeed this way. */
  readonly count: number;
  /** Their share of all attempts that succeed, 0 to 1. */
  readonly share: number;
  /** The quickest of them, s. */
  readonly quickest: number;
  /** The play that is quickest: index within the plays that were given. */
  readonly play: number;
  /** The level's own run that takes this way, or null: the players found it. */
  readonly run: string | null;
}

/** The targets among the events of a run, in order, without repetitions in a row. */
export function routeOf(events: readonly RunEvent[]): number[] {
  const route: number[] = [];
  for (const event of events) if (event.type === 'target' && event.index !== route[route.length - 1]) route.push(event.index);
  return route;
}

/** The name of a route, to compare by. */
export const routeKey = (route: readonly number[]): string => route.join(' ');

/**
 * Finds the ways by which attempts succeed.
 * @param attempts the attempts
 * @param known the level's own runs that complete it, by their routes
 * @returns the ways, the most frequent first
 */
export function routesOf(attempts: readonly Attempt[], known: ReadonlyMap<string, string>): RouteStatistics[] {
  const ways = new Map<string, { count: number; best: Attempt }>();
  let total = 0;
  for (const attempt of attempts) {
    if (attempt.cause !== null) continue;
    total++;
    const key = routeKey(attempt.route);
    const way = ways.get(key);
    if (way === undefined) ways.set(key, { count: 1, best: attempt });
    else {
      way.count++;
      if (attempt.time < way.best.time || (attempt.time === way.best.time && attempt.play < way.best.play)) way.best = attempt;
    }
  }
  const routes = [...ways].map(([key, { count, best }]) => ({
    asteroids: best.route,
    count,
    share: count / total,
    quickest: best.time,
    play: best.play,
    run: known.get(key) ?? null,
  }));
  return routes.sort((a, b) => b.count - a.count || a.quickest - b.quickest || compareKeys(a.asteroids, b.asteroids));
}

const compareKeys = (a: readonly number[], b: readonly number[]): number => (routeKey(a) < routeKey(b) ? -1 : 1);
