import type { Rules } from '../../../schema/basics/index.ts';
import { driftIn } from '../assumptions.ts';
import { type Claim, mouthsOf } from '../claim.ts';

/** Far more than the rounding error of one step, px and px/s. */
export const ROUNDING = 1e-7;

/** How late the engine may notice that she crosses a rim, px. */
export const ON_RIM = 1e-6;

/** The target may be farther than the nearest asteroid by this, px, where the engine counts both as equally near. */
export const TIE = 1e-3;

/** Relative margin of drifts, as in lemma `drift`. */
const DRIFT_MARGIN = 1.01;

/** An object as it lies at time 0, relative to an asteroid. */
export interface Body {
  readonly x: number;
  readonly y: number;
  /** Distance from the asteroid, px. */
  readonly r: number;
  /** Radius of the disc that matters, px. */
  readonly radius: number;
}

/** Another asteroid. */
export interface Rock extends Body {
  /** Its number; the radius is that of the disc in which it ends the run, 0 if it is cold. */
  readonly index: number;
}

/** A wind: the vector is an acceleration, px/s². */
interface Wind extends Body {
  readonly ax: number;
  readonly ay: number;
  readonly strength: number;
}

/** The level as it lies around one asteroid. */
export interface Chart {
  /** The other asteroids, the nearest first. */
  readonly rocks: readonly Rock[];
  /** Discs in which her centre cannot be. They stand still. */
  readonly blocked: readonly Body[];
  readonly fields: readonly Body[];
  readonly winds: readonly Wind[];
  readonly mouths: readonly Body[];
  readonly thing: Body;
  /** Her place at the start. */
  readonly start: Body;
  /** Closer to the asteroid than this she has burned, px; 0 if it is cold. */
  readonly burns: number;
  /** The asteroid's acceleration while it is the target, px/s². */
  readonly recoil: number;
}

/** What the steps of all sets have in common. */
export interface Scene {
  readonly rules: Rules;
  readonly range: number;
  readonly charts: readonly Chart[];
  /** The strongest recoil, px/s². */
  readonly recoil: number;
  /** The greatest acceleration relative to an asteroid, px/s². */
  readonly push: number;
  readonly touch: number;
  /** Length of a step, s. */
  readonly seconds: number;
  /** How far recoil can have moved an asteroid by the end of a step that ends at some time, px. */
  drift(asteroid: number, time: number): number;
}

/** The level around each of its asteroids. */
export function sceneOf(claim: Claim, seconds: number): Scene {
  const { level, rules, place, inner, about } = claim;
  const recoilOf = (i: number) => (level.recoil ? rules.recoil / (2 * level.asteroids[i].radius) : 0);
  const recoil = level.asteroids.reduce((most, _, i) => Math.max(most, recoilOf(i)), 0);
  // Touching the black hole ends the run, so on the way to a mineral it blocks like a hazard.
  const still = about.kind === 'mineral' ? [...level.novae, level.blackHole] : level.novae;
  const charts = level.asteroids.map((asteroid, i): Chart => {
    const centre = place(asteroid);
    const here = <T extends { readonly x: number; readonly y: number }>(thing: T, radius: number) => {
      const at = place(thing);
      const x = at.x - centre.x;
      const y = at.y - centre.y;
      return { x, y, r: Math.sqrt(x * x + y * y), radius };
    };
    const rocks = level.asteroids.flatMap((other, index): Rock[] =>
      index === i ? [] : [{ ...here(other, other.hot ? other.radius + inner : 0), index }],
    );
    return {
      rocks: rocks.sort((a, b) => a.r - b.r),
      blocked: still.map((hazard) => here(hazard, hazard.radius + inner)),
      fields: level.repulsors.map((field) => here(field, field.radius)),
      winds: level.winds.map((wind) => ({
        ...here(wind, wind.radius),
        ax: wind.ax,
        ay: wind.ay,
        strength: Math.sqrt(wind.ax * wind.ax + wind.ay * wind.ay),
      })),
      mouths: mouthsOf(claim).map((mouth) => {
        const x = mouth.x - centre.x;
        const y = mouth.y - centre.y;
        return { x, y, r: Math.sqrt(x * x + y * y), radius: mouth.radius };
      }),
      thing: here(about.kind === 'blackHole' ? level.blackHole : level.minerals[about.index], claim.touch),
      start: here(level.astronaut, 0),
      burns: asteroid.hot ? asteroid.radius + inner : 0,
      recoil: recoilOf(i),
    };
  });
  return {
    rules,
    range: level.range,
    charts,
    recoil: DRIFT_MARGIN * recoil,
    push: claim.push + DRIFT_MARGIN * recoil,
    touch: claim.touch,
    seconds,
    drift: (i, time) => driftIn(level, rules, i, time * time),
  };
}

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
