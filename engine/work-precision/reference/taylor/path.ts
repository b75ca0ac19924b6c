import {
  add,
  type Dd,
  dd,
  divide,
  dot,
  multiply,
  NOWHERE,
  ONE,
  squareRoot,
  subtract,
  times,
  type Vector,
  ZERO,
} from '../double-double.ts';
import type { Along } from '../forces.ts';
import type { Mover } from '../world.ts';
import { DEGREE, productAt, Series } from './series.ts';

/** Places and velocities as series of the stretch's variable. */
export interface Path {
  readonly x: Series;
  readonly y: Series;
  readonly vx: Series;
  readonly vy: Series;
  /** Whether it stays where it is. */
  readonly stands: boolean;
}

export const isMoving = ({ velocity }: Mover): boolean => velocity.x.hi !== 0 || velocity.y.hi !== 0;

/** Uniform motion, to which forces are added. */
export const lineOf = ({ at, velocity }: Mover, unit: number): Path => ({
  x: Series.line(at.x, times(velocity.x, unit)),
  y: Series.line(at.y, times(velocity.y, unit)),
  vx: Series.line(velocity.x),
  vy: Series.line(velocity.y),
  stands: false,
});

const REST = Series.line(ZERO);
const STANDING = new WeakMap<Vector, Path>();

/** The path of what stands at a place. */
export function standing(at: Vector): Path {
  const known = STANDING.get(at);
  if (known !== undefined) return known;
  const path = { x: Series.line(at.x), y: Series.line(at.y), vx: REST, vy: REST, stands: true };
  STANDING.set(at, path);
  return path;
}

/** One body that is drawn towards a centre, or pushed away. `ux`, `uy` is the unit vector towards the centre. */
export interface Central {
  readonly dx: Series;
  readonly dy: Series;
  readonly d2: Series;
  readonly weighted: Series;
  readonly inverse: Series;
  readonly ux: Series;
  readonly uy: Series;
  readonly along: Along;
}

export const central = (along: Along): Central => {
  const none = along ?? NOWHERE;
  const [ux, uy] = along === null ? [new Series(), new Series()] : [Series.line(none.x), Series.line(none.y)];
  return { dx: new Series(), dy: new Series(), d2: new Series(), weighted: new Series(), inverse: new Series(), ux, uy, along };
};

/** Computes coefficient `k` of a central's series from those of the two paths. */
export function follow(c: Central, body: Path, centre: Path, k: number): void {
  c.dx.set(k, subtract(centre.x.get(k), body.x.get(k)));
  c.dy.set(k, subtract(centre.y.get(k), body.y.get(k)));
  if (c.along !== null) return;
  c.d2.set(k, add(productAt(c.dx, c.dx, k), productAt(c.dy, c.dy, k)));
  c.weighted.set(k, times(c.d2.get(k), k / 2));
  c.inverse.set(k, inverseRootAt(c.d2, c.weighted, c.inverse, k));
  c.ux.set(k, productAt(c.dx, c.inverse, k));
  c.uy.set(k, productAt(c.dy, c.inverse, k));
}

/**
 * Coefficient `k` of f = 1 / sqrt(of), from `of` f' = -f of' / 2: the sum of (k - j / 2) of[j] f[k - j] over all j above 0 is
 * -k of[0] f[k]. `weighted` has j of[j] / 2.
 */
function inverseRootAt(of: Series, weighted: Series, f: Series, k: number): Dd {
  if (k === 0) return divide(ONE, squareRoot(of.get(0)));
  // f[k] is still 0, so that j = 0 adds nothing
  const sum = subtract(productAt(weighted, f, k), times(productAt(of, f, k), k));
  return multiply(divide(sum, of.get(0)), INVERSES[k]);
}

/** 1 / k. */
const INVERSES: readonly Dd[] = Array.from({ length: DEGREE + 2 }, (_, k) => (k === 0 ? ZERO : divide(ONE, dd(k))));

/** Adds an acceleration to a path: from its coefficient `k` follow the next ones of velocity and place. */
export function advance(path: Path, ax: Dd, ay: Dd, k: number, unit: number): void {
  const by = times(INVERSES[k + 1], unit);
  path.vx.set(k + 1, multiply(ax, by));
  path.vy.set(k + 1, multiply(ay, by));
  if (k + 2 > DEGREE) return;
  const next = times(INVERSES[k + 2], unit);
  path.x.set(k + 2, multiply(path.vx.get(k + 1), next));
  path.y.set(k + 2, multiply(path.vy.get(k + 1), next));
}

/** How far along its line a centre is, px. */
export function distanceAlong({ dx, dy, along }: Central): Series {
  const made = new Series();
  for (let k = 0; k <= DEGREE; k++) made.set(k, dot({ x: dx.get(k), y: dy.get(k) }, along!));
  return made;
}
