import type { Scene, Simulation } from '../../engine/index.ts';

/** The places of this many chasers at most distinguish cells. */
const CHASERS = 32;

const mix = (h: number, k: number): number => Math.imul(h ^ k ^ (h >>> 15), 0x2c1b3c6d);
const stir = (h: number, k: number): number => Math.imul(h ^ k ^ (h >>> 13), 0x297a2d39);

/**
 * Computes the cell of a state as two 32-bit hashes of her place and velocity in units of the cell size, the places of the
 * chasers, and the minerals she has.
 */
export class CellKey {
  low = 0;
  high = 0;
  private readonly originX: number;
  private readonly originY: number;
  private readonly chasers: Float64Array;

  constructor(scene: Scene) {
    this.originX = scene.level.astronaut.x;
    this.originY = scene.level.astronaut.y;
    this.chasers = new Float64Array(3 * scene.aliens.count);
  }

  /**
   * @param state as `readState` gives it
   * @param place side of a cell, px
   * @param speed side of a cell, px/s
   * @param minerals a hash of the minerals she has
   */
  find(simulation: Simulation, state: Float64Array, place: number, speed: number, minerals: number): void {
    const x = Math.floor((state[0] - this.originX) / place);
    const y = Math.floor((state[1] - this.originY) / place);
    // Shift by a half, so that rest lies in the middle of a cell and not at the corner of four.
    const vx = Math.floor(state[2] / speed + 0.5);
    const vy = Math.floor(state[3] / speed + 0.5);
    let low = mix(mix(mix(mix(minerals ^ 0x3c6ef372, x), y), vx), vy);
    let high = stir(stir(stir(stir(minerals ^ 0x1b873593, vy), vx), y), x);
    const { chasers } = this;
    if (chasers.length > 0) {
      simulation.readAliens(chasers);
      for (let i = 0; i < chasers.length && i < 3 * CHASERS; i += 3) {
        const ax = Math.floor((chasers[i] - this.originX) / place);
        const ay = Math.floor((chasers[i + 1] - this.originY) / place);
        low = mix(mix(low, ax), ay ^ (chasers[i + 2] << 30));
        high = stir(stir(high, ay), ax ^ (chasers[i + 2] << 30));
      }
    }
    this.low = low ^ (low >>> 16);
    this.high = high ^ (high >>> 16);
  }
}
