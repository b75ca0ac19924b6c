import { type Scene, TICK_RATE } from '../../engine/index.ts';
import type { LineOfFlight } from './line-of-flight.ts';
import { NO_WAY, WayMap } from './way-map.ts';

/** Height of a band, px of way. */
const BAND = 40;

/** Bands of one set of minerals, at most. */
export const BANDS = 1000;

/** The bands of this many sets of missing minerals are kept. */
const MOST_KNOWN = 64;

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
  private readonly known = new Map<number, Uint16Array>();
  private lastMissing = -1;
  private last: Uint16Array = new Uint16Array(0);

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
    const square = this.map.squareAt(x, y);
    return square < 0 ? BANDS - 1 : this.bandsFor(missing)[square];
  }

  /**
   * The lowest band that she would pass if the button were released now, on a straight line up to the next hazard.
   * @returns the band, or one that is higher than all when none is lower than `below`
   */
  bandAhead(state: Float64Array, missing: number, below: number, line: LineOfFlight): number {
    const { map } = this;
    const bands = this.bandsFor(missing);
    const speed = Math.sqrt(state[2] * state[2] + state[3] * state[3]);
    if (!(speed > 1)) return BANDS;
    const step = map.size;
    const ux = (state[2] / speed) * step;
    const uy = (state[3] / speed) * step;
    const most = Math.floor((speed * DRIFT) / TICK_RATE / step);
    let x = state[0];
    let y = state[1];
    let best = below;
    let at = 0;
    for (let i = 1; i <= most; i++) {
      x += ux;
      y += uy;
      const square = map.squareAt(x, y);
      if (!map.isFree(square)) break;
      const band = bands[square];
      if (band >= best) continue;
      best = band;
      at = i;
    }
    if (at === 0) return BANDS;
    line.from(state);
    return line.isClear(at * step) ? best : BANDS;
  }

  /** The band of each square of the map. */
  private bandsFor(missing: number): Uint16Array {
    if (missing === this.lastMissing) return this.last;
    let bands = this.known.get(missing);
    if (bands === undefined) {
      bands = this.measure(missing);
      if (this.known.size >= MOST_KNOWN) this.known.clear();
      this.known.set(missing, bands);
    }
    this.lastMissing = missing;
    this.last = bands;
    return bands;
  }

  private measure(missing: number): Uint16Array {
    const fields = missing === 0 ? [this.toHole] : this.toMineral.filter((_, i) => (missing >> i) & 1);
    const bands = new Uint16Array(this.toHole.length);
    for (let square = 0; square < bands.length; square++) {
      let length = NO_WAY;
      for (const field of fields) if (field[square] < length) length = field[square];
      bands[square] = Math.min(BANDS - 1, Math.floor(length / this.band));
    }
    return bands;
  }
}
