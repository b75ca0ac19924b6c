import type { Scene, Simulation } from '../../engine/index.ts';

/** So many minerals at most are aimed at; where there are more, she meets enough of them by the way. */
const AIMED_AT = 24;

/** Which minerals a simulation has collected, as far as the goal cares: different ones, where `arcade` may count one twice. */
export class MineralSet {
  /** how many */
  size = 0;
  /** a number that says which */
  hash = 0;
  private readonly scene: Scene;
  private readonly cares: boolean;
  private counted = -1;

  /** @param cares whether the goal asks for minerals at all */
  constructor(scene: Scene, cares: boolean) {
    this.scene = scene;
    this.cares = cares;
  }

  /** The number of minerals worth aiming at, collected or not: the first so many of the level. */
  get aims(): number {
    return this.cares ? Math.min(this.scene.minerals.count, AIMED_AT) : 0;
  }

  /** Reads them anew where the count has changed since the last reading. */
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
