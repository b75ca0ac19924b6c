import type { Scene } from '../../engine/index.ts';
import type { LineOfFlight } from './line-of-flight.ts';
import { NO_WAY, WayMap } from './way-map.ts';

/** Height of a band, px of way. */
const BAND = 40;

/** Bands of one set of minerals, at most. */
export const BANDS = 1000;

/** The longest drift that is looked along, ticks. */
const DRIFT = 600;

/**
 * Tells how far states still have to go, along the ways around hazards. The ways to the black hole and to each mineral are
 * measured backwards, once. What lies equally far along them forms a band; a door, a gap that every way passes, lies between two
 * bands. A search that shares its effort equally among bands spends it where she has just arrived, and not at the doors she has
 * already passed again and again.
 */
export class Guide {
  private readonly map: WayMap;
  private readonly toHole: Int32Array;
  private readonly toMineral: readonly Int32Array[];
  /** Lengths in a field that make a band. */
  private readonly band: number;

  private constructor(scene: Scene, map: WayMap, aims: number) {
    const { minerals, box, level } = scene;
    this.map = map;
    this.band = (5 * BAND) / map.size;
    const hole = level.blackHole;
    this.toHole = map.fieldTo(hole.x, hole.y, hole.radius + box.halfDiagonal);
    this.toMineral = Array.from({ length: aims }, (_, i) =>
      map.fieldTo(minerals.x[i], minerals.y[i], minerals.r[i] + box.halfDiagonal),
    );
  }

  /** @param aims how many minerals are aimed at
   * @returns null where the level is too large to be measured */
  static of(scene: Scene, aims: number): Guide | null {
    const map = WayMap.of(scene);
    return map === null ? null : new Guide(scene, map, aims);
  }

  /**
   * The band of a place, the nearest first.
   * @param missing the minerals still to be collected, one bit per index; 0 when only the black hole is left
   */
  bandAt(x: number, y: number, missing: number): number {
    return this.bandOf(this.map.squareAt(x, y), missing);
  }

  /**
   * The lowest band that she would pass if the button were released now, on a straight line up to the next hazard.
   * @returns the band, or one that is higher than all when none is lower than `below`
   */
  bandAhead(state: Float64Array, missing: number, below: number, line: LineOfFlight): number {
    const { map } = this;
    const speed = Math.sqrt(state[2] * state[2] + state[3] * state[3]);
    if (!(speed > 1)) return BANDS;
    const step = map.size;
    const ux = (state[2] / speed) * step;
    const uy = (state[3] / speed) * step;
    const most = Math.floor((speed * DRIFT) / 60 / step);
    let x = state[0];
    let y = state[1];
    let best = below;
    let at = 0;
    for (let i = 1; i <= most; i++) {
      x += ux;
      y += uy;
      const square = map.squareAt(x, y);
      if (!map.isFree(square)) break;
      const band = this.bandOf(square, missing);
      if (band >= best) continue;
      best = band;
      at = i;
    }
    if (at === 0) return BANDS;
    line.from(state);
    return line.isClear(at * step) ? best : BANDS;
  }

  private bandOf(square: number, missing: number): number {
    if (square < 0) return BANDS - 1;
    let length = NO_WAY;
    if (missing === 0) length = this.toHole[square];
    else {
      for (let i = 0; i < this.toMineral.length; i++) {
        if ((missing >> i) & 1) length = Math.min(length, this.toMineral[i][square]);
      }
    }
    return Math.min(BANDS - 1, Math.floor(length / this.band));
  }
}
