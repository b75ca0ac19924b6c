import type { Place } from '../../schema/basics/index.ts';
import type { Attempt, FailureCause } from './attempt.ts';

// Why attempts fail, and where: the causes first, then the places where many fail for one cause.

/** How many attempts fail for one cause. */
export interface CauseStatistics {
  /** Why they fail. */
  readonly cause: FailureCause;
  /** How many fail. */
  readonly count: number;
  /** Their share of all failures, 0 to 1. */
  readonly share: number;
}

/** The attempts that fail for one cause. */
interface CauseGroup {
  readonly cause: FailureCause;
  readonly attempts: Attempt[];
}

/** The attempts that fail, by a name of their cause. */
function byCause(attempts: readonly Attempt[]): Map<string, CauseGroup> {
  const groups = new Map<string, CauseGroup>();
  for (const attempt of attempts) {
    const { cause } = attempt;
    if (cause === null) continue;
    const key = `${cause.kind} ${cause.index ?? ''}`;
    const known = groups.get(key);
    if (known === undefined) groups.set(key, { cause, attempts: [attempt] });
    else known.attempts.push(attempt);
  }
  return groups;
}

/** Counts why attempts fail, the most frequent cause first. */
export function causesOf(attempts: readonly Attempt[]): CauseStatistics[] {
  const groups = [...byCause(attempts)].map(([key, { cause, attempts: own }]) => ({ key, cause, count: own.length }));
  const failures = groups.reduce((sum, { count }) => sum + count, 0);
  groups.sort((a, b) => b.count - a.count || (a.key < b.key ? -1 : 1));
  return groups.map(({ cause, count }) => ({ cause, count, share: count / failures }));
}

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

function placeOf(points: readonly Place[]): Pick<FailureCluster, 'x' | 'y' | 'spread'> {
  let [x, y, squares] = [0, 0, 0];
  for (const point of points) {
    x += point.x / points.length;
    y += point.y / points.length;
  }
  for (const point of points) squares += ((point.x - x) * (point.x - x) + (point.y - y) * (point.y - y)) / points.length;
  return { x, y, spread: Math.sqrt(squares) };
}

interface Cell {
  readonly column: number;
  readonly row: number;
  /** Indices of the points inside. */
  readonly points: number[];
  /** Those that have enough neighbours. */
  core: number[];
  cluster: number;
}

/** The cells whose points may be within reach: all within two columns and rows, but for the corners. */
const AROUND: readonly (readonly [number, number])[] = Array.from({ length: 25 }, (_, i): [number, number] => [
  (i % 5) - 2,
  Math.floor(i / 5) - 2,
]).filter(([dx, dy]) => Math.abs(dx) + Math.abs(dy) < 4);

/**
 * Finds clusters of points by density: DBSCAN (M. Ester, H.-P. Kriegel, J. Sander, X. Xu, A density-based algorithm for
 * discovering clusters in large spatial databases with noise, KDD 1996), on a grid of cells with a diagonal of `reach` (A.
 * Gunawan, A faster algorithm for DBSCAN, 2013), so that most pairs of points are never compared.
 *
 * A point with at least `least` points within `reach`, itself included, is a core point. Core points within reach of each other
 * belong to one cluster. Another point belongs to the cluster of the nearest core point within reach, or to none. Where DBSCAN
 * leaves a choice, the lower x and then the lower y decides, so the order of the points does not matter.
 * @param points the points
 * @param reach the distance within which points are neighbours, px
 * @param least how many points a neighbourhood needs
 * @returns the number of each point's cluster, from 0; -1 for a point that belongs to none
 */
export function dbscan(points: readonly Place[], reach: number, least: number): Int32Array {
  const near = reach * reach;
  const distance = (a: number, b: number): number => {
    const [dx, dy] = [points[a].x - points[b].x, points[a].y - points[b].y];
    return dx * dx + dy * dy;
  };
  const cells = cellsOf(points, reach / Math.sqrt(2));
  const around = (cell: Cell): Cell[] => AROUND.flatMap(([dx, dy]) => cells.get(keyOf(cell.column + dx, cell.row + dy)) ?? []);

  for (const cell of cells.values()) {
    if (cell.points.length >= least) {
      cell.core = cell.points;
      continue;
    }
    const neighbours = around(cell).filter((other) => other !== cell);
    cell.core = cell.points.filter((point) => {
      let count = cell.points.length;
      for (const other of neighbours) {
        for (const candidate of other.points) {
          if (distance(point, candidate) <= near && ++count >= least) return true;
        }
      }
      return count >= least;
    });
  }

  const touch = (a: Cell, b: Cell): boolean => a.core.some((one) => b.core.some((other) => distance(one, other) <= near));
  const labels = new Int32Array(points.length).fill(-1);
  let clusters = 0;
  for (const first of cells.values()) {
    if (first.cluster >= 0 || first.core.length === 0) continue;
    first.cluster = clusters++;
    const waiting = [first];
    for (let cell = waiting.pop(); cell !== undefined; cell = waiting.pop()) {
      for (const point of cell.core) labels[point] = cell.cluster;
      for (const other of around(cell)) {
        if (other.cluster >= 0 || other.core.length === 0 || !touch(cell, other)) continue;
        other.cluster = cell.cluster;
        waiting.push(other);
      }
    }
  }

  for (const cell of cells.values()) {
    if (cell.core.length === cell.points.length) continue;
    const neighbours = around(cell);
    for (const point of cell.points) {
      if (labels[point] >= 0) continue;
      let best = -1;
      let nearest = near;
      for (const other of neighbours) {
        for (const candidate of other.core) {
          const between = distance(point, candidate);
          const isNearer = between < nearest || (between === nearest && (best < 0 || isBefore(points[candidate], points[best])));
          if (isNearer) [best, nearest] = [candidate, between];
        }
      }
      if (best >= 0) labels[point] = labels[best];
    }
  }
  return labels;
}

/** Whether one point comes before another in the canonical order. */
const isBefore = (a: Place, b: Place): boolean => a.x < b.x || (a.x === b.x && a.y < b.y);

const keyOf = (column: number, row: number): string => `${column} ${row}`;

function cellsOf(points: readonly Place[], side: number): Map<string, Cell> {
  const cells = new Map<string, Cell>();
  for (const [i, { x, y }] of points.entries()) {
    const [column, row] = [Math.floor(x / side), Math.floor(y / side)];
    const key = keyOf(column, row);
    const cell = cells.get(key);
    if (cell === undefined) cells.set(key, { column, row, points: [i], core: [], cluster: -1 });
    else cell.points.push(i);
  }
  return cells;
}
