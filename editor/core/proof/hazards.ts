import type { Scene } from '../../../engine/index.ts';
import type { Way } from './march.ts';

/** An object that is deadly to touch. */
export interface Hazard {
  readonly kind: 'nova' | 'asteroid' | 'alien';
  /** index in the level's list of that kind */
  readonly index: number;
}

/** All hazards in one numbering: novae, hot asteroids, aliens; and their positions at a tick. */
export class Hazards {
  readonly count: number;
  private readonly hot: number;

  constructor(
    private readonly scene: Scene,
    private readonly way: Way,
  ) {
    this.hot = scene.targets.count - scene.coldCount;
    this.count = scene.novae.count + this.hot + scene.aliens.count;
  }

  nameOf(i: number): Hazard {
    const { novae, targets, coldCount } = this.scene;
    if (i < novae.count) return { kind: 'nova', index: novae.index[i] };
    if (i < novae.count + this.hot) return { kind: 'asteroid', index: targets.index[coldCount + i - novae.count] };
    return { kind: 'alien', index: i - novae.count - this.hot };
  }

  /** Writes x, y, radius of hazard `i` at a tick. @returns whether it still exists */
  at(i: number, tick: number, out: Float64Array): boolean {
    const { scene, way, hot } = this;
    const { novae, targets, coldCount, aliens } = scene;
    if (i < novae.count) {
      out[0] = novae.x[i];
      out[1] = novae.y[i];
      out[2] = novae.r[i];
      return true;
    }
    if (i < novae.count + hot) {
      const t = coldCount + i - novae.count;
      out[0] = targets.x[t];
      out[1] = targets.y[t];
      if (way.asteroids.count > 0) way.asteroids.read(targets.index[t], tick, out);
      out[2] = targets.r[t];
      return true;
    }
    const alien = i - novae.count - hot;
    way.aliens.read(alien, tick, out);
    const isThere = out[2] !== 0;
    out[2] = aliens.r[alien];
    return isThere;
  }

  /** Whether it never moves during the run. */
  isStill(i: number): boolean {
    const { scene, way, hot } = this;
    const { novae, targets, coldCount } = scene;
    if (i < novae.count) return true;
    if (i < novae.count + hot)
      return way.asteroids.count === 0 || !way.asteroids.stirs(targets.index[coldCount + i - novae.count]);
    return !way.aliens.stirs(i - novae.count - hot);
  }
}
