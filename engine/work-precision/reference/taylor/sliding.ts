import { add, dd, divide, minus, plus, scaled, subtract, type Vector } from '../double-double.ts';
import { placeOf } from '../world.ts';
import type { Path } from './path.ts';
import { productAt, Series } from './series.ts';

/**
 * Motion along a rim that is pushed at from both sides: by the convex combination of the forces inside and outside that keeps
 * her on the circle (Filippov). With the normal n outwards and speed v, n . force = -v^2 / radius.
 */
export class Sliding {
  /** The share of the force inside. She leaves outwards where it falls below 0, and inwards where it exceeds 1. */
  readonly share = new Series();
  readonly #radius: number;
  readonly #centre: Vector;
  readonly #her: Path;
  readonly #normal = { x: new Series(), y: new Series() };
  readonly #difference = { x: new Series(), y: new Series() };
  readonly #outside = { x: new Series(), y: new Series() };
  readonly #across = new Series();

  /** @param rim - the circle on whose rim she is @param her - her path, which is being expanded */
  constructor(rim: { readonly x: number; readonly y: number; readonly radius: number }, her: Path) {
    this.#radius = rim.radius;
    this.#centre = placeOf(rim);
    this.#her = her;
  }

  /** Coefficient `k` of the force that acts, from those of the forces inside and outside and of her path. */
  force(inside: Vector, outside: Vector, k: number): Vector {
    const { x, y, vx, vy } = this.#her;
    const at = { x: x.get(k), y: y.get(k) };
    const normal = scaled(k === 0 ? minus(at, this.#centre) : at, divide(dd(1), dd(this.#radius)));
    setVector(this.#normal, k, normal);
    setVector(this.#difference, k, minus(inside, outside));
    setVector(this.#outside, k, outside);
    this.#across.set(k, dotAt(this.#normal, this.#difference, k));
    const bend = divide(add(productAt(vx, vx, k), productAt(vy, vy, k)), dd(-this.#radius));
    // coefficient k of the share is still 0
    const rest = subtract(subtract(bend, dotAt(this.#normal, this.#outside, k)), productAt(this.#across, this.share, k));
    this.share.set(k, divide(rest, this.#across.get(0)));
    const { x: dx, y: dy } = this.#difference;
    return plus(outside, { x: productAt(this.share, dx, k), y: productAt(this.share, dy, k) });
  }
}

interface VectorSeries {
  readonly x: Series;
  readonly y: Series;
}

function setVector(series: VectorSeries, k: number, { x, y }: Vector): void {
  series.x.set(k, x);
  series.y.set(k, y);
}

const dotAt = (a: VectorSeries, b: VectorSeries, k: number) => add(productAt(a.x, b.x, k), productAt(a.y, b.y, k));
