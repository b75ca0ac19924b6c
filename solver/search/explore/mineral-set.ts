import type { Scene, Simulation } from '../../../engine/index.ts';

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
  /** Which of those aimed at she has, one bit per index. */
  collected = 0;
  private readonly scene: Scene;
  private readonly needed: number;
  private counted = -1;

  /** @param needed how many minerals the goal requires */
  constructor(scene: Scene, needed: number) {
    this.scene = scene;
    this.needed = needed;
  }

  /** How many minerals the search aims at, collected or not: the first ones in the level's list. */
  get aims(): number {
    return this.needed > 0 ? Math.min(this.scene.minerals.count, AIMED_AT) : 0;
  }

  /** Which of those aimed at she still has to collect, one bit per index; 0 when she has enough. */
  get missing(): number {
    return this.size >= this.needed ? 0 : ~this.collected & ((1 << this.aims) - 1);
  }

  /** Reads the minerals again if the count has changed since the last reading. */
  update(simulation: Simulation): void {
    if (simulation.mineralCount !== this.counted) this.read(simulation);
  }

  read(simulation: Simulation): void {
    this.counted = simulation.mineralCount;
    this.size = 0;
    this.hash = 0;
    this.collected = 0;
    if (this.needed === 0 || this.counted === 0) return;
    for (let i = 0; i < this.scene.minerals.count; i++) {
      if (!simulation.isCollected(i)) continue;
      this.size++;
      if (i < AIMED_AT) this.collected |= 1 << i;
      this.hash = Math.imul(this.hash ^ (i + 1), 0x9e3779b1);
    }
  }
}
