import { type Rock, type Scene, TIE } from './scene.ts';

/** How far recoil may have moved each asteroid by some time, and what follows from it for who is the nearest. */
export class Drifts {
  /** The time, s. */
  time = 0;
  private readonly scene: Scene;
  private readonly each: Float64Array;
  private most = 0;

  constructor(scene: Scene) {
    this.scene = scene;
    this.each = new Float64Array(scene.charts.length);
  }

  /** Sets the time, s. */
  until(time: number): void {
    this.time = time;
    this.most = 0;
    for (let i = 0; i < this.each.length; i++) {
      this.each[i] = this.scene.drift(i, time);
      this.most = Math.max(this.most, this.each[i]);
    }
  }

  /** How far asteroid i may have moved, px. */
  of(i: number): number {
    return this.each[i];
  }

  /** How far the place of asteroid j relative to asteroid i may have moved, px: only one of them moves at a time. */
  between(i: number, j: number): number {
    return Math.max(this.each[i], this.each[j]);
  }

  /** Whoever is no farther than `most` px from an asteroid is not nearer to one that is farther than this from it, px. */
  farthestRival(most: number): number {
    return 2 * (most + 2 * this.most + 1);
  }

  /**
   * How far recoil and ties can move the line behind which a rock is nearer than the chart's asteroid, for places up to `most` px
   * from the latter: by this scalar product, px².
   */
  slack(blur: number, { r }: Rock, most: number): number {
    return (blur + TIE) * (most + r) + (blur * blur) / 2 + TIE;
  }
}
