import type { Scene, Simulation } from '../../engine/index.ts';

/** The search aims at this many minerals at most. In levels with more of them, enough are collected by chance. */
const AIMED_AT = 24;

/**
 * The minerals that a simulation has collected, where the goal requires any. Each counts once, although `arcade` may count one
 * twice.
 */
export class MineralSet {
  /** How many different minerals she has. */
  size = 0;
  /** A hash of which ones she has. */
  hash = 0;
  private readonly scene: Scene;
  private readonly cares: boolean;
  private counted = -1;

  /** @param cares whether the goal requires minerals at all */
  constructor(scene: Scene, cares: boolean) {
    this.scene = scene;
    this.cares = cares;
  }

  /** How many minerals the search aims at, collected or not: the first ones in the level's list. */
  get aims(): number {
    return this.cares ? Math.min(this.scene.minerals.count, AIMED_AT) : 0;
  }

  /** Reads the minerals again if the count has changed since the last reading. */
  update(simulation: Simulation): void {
    if (simulation.mineralCount !== this.counted) this.read(simulation);
  }

  read(simulation: Simulation): void {
    this.counted = simulation.mineralCount;
    this.size = 0;
    this.hash = 0;
    if (!this.cares || this.counted === 0) return;
    for (let i = 0; i < this.scene.minerals.count; i++) {
      if (!simulation.isCollected(i)) continue;
      this.size++;
      this.hash = Math.imul(this.hash ^ (i + 1), 0x9e3779b1);
    }
  }
}
