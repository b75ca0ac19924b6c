import type { Attempt, FailureCause } from './attempt.ts';
import { byCause } from './causes.ts';
import { dbscan, type Point } from './dbscan.ts';

/** A place where many attempts fail for one cause. */
export interface FailureCluster {
  /** Why they fail. */
  readonly cause: FailureCause;
  /** How many attempts fail here. */
  readonly count: number;
  /** Their share of all failures, 0 to 1. */
  readonly share: number;
  /** The mean of their places, px. */
  readonly x: number;
  /** See {@link FailureCluster.x}, px. */
  readonly y: number;
  /** The root of the mean squared distance from the mean place, px. */
  readonly spread: number;
  /** The plays that failed here: indices within the plays that were given, ascending. */
  readonly plays: readonly number[];
}

/** How close failures of a cluster are to each other, px: a little more than the width of the astronaut. */
const CLUSTER_REACH = 32;

/** A cluster has a place with at least this many failures around it ... */
const LEAST = 4;

/** ... and with this share of the failures of its cause: many plays would otherwise make one cluster of everything. */
const LEAST_SHARE = 0.02;

/**
 * Finds where attempts fail: clusters of the places of each cause, by {@link dbscan}.
 * @param attempts the attempts, in any order
 * @returns the clusters, the largest first
 */
export function clustersOf(attempts: readonly Attempt[]): FailureCluster[] {
  const failures = attempts.filter(({ cause }) => cause !== null).length;
  const clusters: FailureCluster[] = [];
  for (const { cause, attempts: group } of byCause(attempts).values()) {
    // sums depend on the order of their terms
    const sorted = [...group].sort((a, b) => a.x - b.x || a.y - b.y || a.play - b.play);
    const labels = dbscan(sorted, CLUSTER_REACH, Math.max(LEAST, Math.ceil(LEAST_SHARE * group.length)));
    const members = Array.from({ length: 1 + labels.reduce((a, b) => Math.max(a, b), -1) }, (): Attempt[] => []);
    for (const [i, attempt] of sorted.entries()) members[labels[i]]?.push(attempt);
    for (const own of members) clusters.push({ cause, ...placeOf(own), ...countOf(own, failures) });
  }
  return clusters.sort((a, b) => b.count - a.count || a.x - b.x || a.y - b.y);
}

const countOf = (own: readonly Attempt[], failures: number): Pick<FailureCluster, 'count' | 'share' | 'plays'> => ({
  count: own.length,
  share: own.length / failures,
  plays: own.map(({ play }) => play).sort((a, b) => a - b),
});

function placeOf(points: readonly Point[]): Pick<FailureCluster, 'x' | 'y' | 'spread'> {
  let [x, y, squares] = [0, 0, 0];
  for (const point of points) {
    x += point.x / points.length;
    y += point.y / points.length;
  }
  for (const point of points) squares += ((point.x - x) * (point.x - x) + (point.y - y) * (point.y - y)) / points.length;
  return { x, y, spread: Math.sqrt(squares) };
}
