import { compile, type RunEvent, type Terms, WorkBudget } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { playRuns } from '../examine-runs.ts';
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
const routeKey = (route: readonly number[]): string => route.join(' ');

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

/** The run that presses and releases of players are compared with. */
export interface Reference {
  /** Its holds, [press, release) in ticks. */
  readonly holds: readonly Hold[];
  /** The name of the level's run; null: a typical success of the players, or a run that was given without a name. */
  readonly name: string | null;
}

/** A run of the level that completes it, and its way. */
interface KnownRun extends Reference {
  readonly name: string;
  /** As {@link routeKey} gives it. */
  readonly route: string;
}

/** The level's own runs that complete it under some terms. */
export function knownRuns(level: Level, terms: Terms): KnownRun[] {
  if (level.runs.length === 0) return [];
  const runs = playRuns(compile(level, terms), new WorkBudget(terms.maxWork));
  return level.runs.flatMap(({ name, holds }, i): KnownRun[] => {
    const { outcome, events } = runs[i];
    return outcome === 'completed' ? [{ name, holds, route: routeKey(routeOf(events)) }] : [];
  });
}

/**
 * Chooses the run to compare with: the level's own run whose way most players take who succeed. If none of them takes the way
 * of any of its runs, a typical success; if none succeeds, the level's first run that completes it; else none.
 */
export function chooseReference(known: readonly KnownRun[], attempts: readonly Attempt[]): Reference | null {
  const successes = attempts.filter(({ cause }) => cause === null);
  const counts = new Map<string, number>();
  for (const { route } of successes) counts.set(routeKey(route), (counts.get(routeKey(route)) ?? 0) + 1);
  let best: KnownRun | undefined;
  let most = 0;
  for (const run of known) {
    const count = counts.get(run.route) ?? 0;
    if (count > most) [best, most] = [run, count];
  }
  const chosen = best ?? (successes.length > 0 ? null : known[0]);
  if (chosen === undefined) return null;
  return chosen === null ? typicalSuccess(successes) : { name: chosen.name, holds: chosen.holds };
}

/**
 * A typical success: of those that take the most frequent way with the most frequent number of presses and releases, the one
 * whose edges are nearest to the medians of all of these.
 */
function typicalSuccess(successes: readonly Attempt[]): Reference {
  const groups = new Map<string, Attempt[]>();
  for (const attempt of successes) {
    const key = `${attempt.edges.length} ${routeKey(attempt.route)}`;
    const group = groups.get(key);
    if (group === undefined) groups.set(key, [attempt]);
    else group.push(attempt);
  }
  const [[, group]] = [...groups].sort(([a, x], [b, y]) => y.length - x.length || (a < b ? -1 : 1));
  const medians = group[0].edges.map((_, i) => {
    const sorted = group.map(({ edges }) => edges[i]).sort((a, b) => a - b);
    return sorted[sorted.length >> 1];
  });
  const distance = ({ edges }: Attempt): number => edges.reduce((sum, edge, i) => sum + Math.abs(edge - medians[i]), 0);
  const inOrder = (a: Attempt, b: Attempt): number => {
    const i = a.edges.findIndex((edge, at) => edge !== b.edges[at]);
    return i < 0 ? a.tick - b.tick : a.edges[i] - b.edges[i];
  };
  const nearest = group.reduce((a, b) => ((distance(b) - distance(a) || inOrder(b, a)) < 0 ? b : a));
  return { name: null, holds: holdsOf(nearest) };
}

/** The holds of an attempt; one that lasts to the end is released there. */
const holdsOf = ({ edges, tick }: Attempt): Hold[] => {
  const holds: Hold[] = [];
  for (let i = 0; i < edges.length; i += 2) holds.push([edges[i], edges[i + 1] ?? tick]);
  return holds;
};
