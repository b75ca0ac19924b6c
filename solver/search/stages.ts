import type { Scene } from '../../engine/index.ts';
import type { WayMap } from './way-map.ts';

/** Stages of one set of minerals, at most. */
export const STAGES = 1000;

/** The stages of this many sets of missing minerals are kept. */
const MOST_KNOWN = 64;

const NONE = -1;

/**
 * Divides the map of ways into regions, and says through how many more of them she has to pass. A region is a connected part of
 * the map in which the same asteroid is the nearest one. The borders between regions are the landmarks of a level: behind each
 * of them the gun pulls another way.
 */
export class Stages {
  readonly map: WayMap;
  /** The region of each square, or `NONE`. */
  private readonly regions: Int32Array;
  /** The neighbours of each region. */
  private readonly beside: readonly ReadonlySet<number>[];
  private readonly toHole: Uint16Array;
  private readonly toMineral: readonly Uint16Array[];
  private readonly known = new Map<number, Uint16Array>();

  /** @param aims how many minerals are aimed at */
  constructor(scene: Scene, map: WayMap, aims: number) {
    const { minerals, box, level } = scene;
    this.map = map;
    const nearest = nearestTargets(scene, map);
    const { regions, beside } = connected(map, nearest);
    this.regions = regions;
    this.beside = beside;
    const hole = level.blackHole;
    this.toHole = this.hopsTo(hole.x, hole.y, hole.radius + box.halfDiagonal);
    this.toMineral = Array.from({ length: aims }, (_, i) =>
      this.hopsTo(minerals.x[i], minerals.y[i], minerals.r[i] + box.halfDiagonal),
    );
  }

  /**
   * The stage of a place: how many borders lie on the way, at least.
   * @param missing the minerals still to be collected, one bit per index; 0 when only the black hole is left
   */
  at(x: number, y: number, missing: number): number {
    return this.ofSquare(this.map.squareAt(x, y), missing);
  }

  /** The stage of a square of the map. */
  ofSquare(square: number, missing: number): number {
    const region = square < 0 ? NONE : this.regions[square];
    return region === NONE ? STAGES - 1 : this.stagesFor(missing)[region];
  }

  private stagesFor(missing: number): Uint16Array {
    if (missing === 0) return this.toHole;
    let stages = this.known.get(missing);
    if (stages !== undefined) return stages;
    stages = new Uint16Array(this.toHole.length).fill(STAGES - 1);
    for (const [i, hops] of this.toMineral.entries()) {
      if (((missing >> i) & 1) === 0) continue;
      for (let region = 0; region < hops.length; region++) stages[region] = Math.min(stages[region], hops[region]);
    }
    if (this.known.size >= MOST_KNOWN) this.known.clear();
    this.known.set(missing, stages);
    return stages;
  }

  /** The number of borders between each region and a circle (breadth first). */
  private hopsTo(x: number, y: number, reach: number): Uint16Array {
    const hops = new Uint16Array(this.beside.length).fill(STAGES - 1);
    const queue: number[] = [];
    const reached = (region: number, count: number) => {
      if (region === NONE || hops[region] <= count) return;
      hops[region] = count;
      queue.push(region);
    };
    this.map.each(x, y, reach, (square) => reached(this.regions[square], 0));
    for (const region of queue) {
      for (const other of this.beside[region]) reached(other, Math.min(STAGES - 1, hops[region] + 1));
    }
    return hops;
  }
}

/** The nearest asteroid of each square, or `NONE`. */
function nearestTargets({ targets, level }: Scene, map: WayMap): Int32Array {
  const nearest = new Int32Array(map.squares).fill(NONE);
  const distance = new Float64Array(map.squares).fill(Number.POSITIVE_INFINITY);
  for (let i = 0; i < targets.count; i++) {
    map.each(targets.x[i], targets.y[i], level.range, (square, dx, dy) => {
      const d = dx * dx + dy * dy;
      if (d >= distance[square]) return;
      distance[square] = d;
      nearest[square] = i;
    });
  }
  return nearest;
}

/** Connects free squares with the same nearest asteroid, and finds out which regions touch each other. */
function connected(map: WayMap, nearest: Int32Array): { regions: Int32Array; beside: Set<number>[] } {
  const { width, squares } = map;
  const steps = [1, -1, width, -width, width + 1, width - 1, 1 - width, -width - 1];
  const regions = new Int32Array(squares).fill(NONE);
  const beside: Set<number>[] = [];
  for (let first = 0; first < squares; first++) {
    if (regions[first] !== NONE || !map.isFree(first)) continue;
    const region = beside.length;
    beside.push(new Set());
    regions[first] = region;
    const stack = [first];
    for (let square = stack.pop(); square !== undefined; square = stack.pop()) {
      for (const step of steps) {
        const next = square + step;
        if (!map.isFree(next)) continue;
        if (nearest[next] === nearest[first]) {
          if (regions[next] !== NONE) continue;
          regions[next] = region;
          stack.push(next);
        } else if (regions[next] !== NONE) {
          beside[region].add(regions[next]);
          beside[regions[next]].add(region);
        }
      }
    }
  }
  return { regions, beside };
}
