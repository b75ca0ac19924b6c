/** Where an alien may be and how fast: discs of places and of velocities, px and px/s. */
export interface ChaserDisc {
  readonly x: number;
  readonly y: number;
  readonly r: number;
  readonly vx: number;
  readonly vy: number;
  readonly vr: number;
  /** Radius of the alien, px. */
  readonly touch: number;
  /** Whether it may have exploded already. As it may also still be there, it may still explode others. */
  readonly doubtful: boolean;
}

/** A disc of accelerations or of velocities. */
interface Span {
  readonly x: number;
  readonly y: number;
  readonly r: number;
}

const SLACK = 1e-6;

/**
 * Where aliens may be after `seconds`, while she is anywhere in a rectangle (least and greatest x and y). An alien that is
 * closer than `sight` is accelerated towards her by `pull`; otherwise it stops dead. Two that may touch may explode (lemma
 * `chasers`).
 */
export function chase(
  aliens: readonly ChaserDisc[],
  [xa, xb, ya, yb]: readonly [number, number, number, number],
  seconds: number,
  pull: number,
  sight: number,
): readonly ChaserDisc[] {
  if (aliens.length === 0) return aliens;
  const middle = { x: (xa + xb) / 2, y: (ya + yb) / 2 };
  const around = length(xb - xa, yb - ya) / 2;
  const reach = (a: ChaserDisc) => a.r + (length(a.vx, a.vy) + a.vr) * seconds + 0.5 * pull * seconds * seconds + SLACK;
  return aliens.map((alien, i) => {
    const dx = middle.x - alien.x;
    const dy = middle.y - alien.y;
    const d = length(dx, dy);
    const blur = around + reach(alien);
    const rests = length(alien.vx, alien.vy) + alien.vr === 0;
    const mayExplode = (other: ChaserDisc, k: number): boolean => {
      const gap = length(other.x - alien.x, other.y - alien.y) - reach(alien) - reach(other);
      return k !== i && gap <= alien.touch + other.touch;
    };
    const doubtful = alien.doubtful || aliens.some(mayExplode);
    if (rests && d - around - alien.r > sight + SLACK) return { ...alien, doubtful };
    let a: Span = blur > d / 2 ? { x: 0, y: 0, r: pull } : { x: (pull * dx) / d, y: (pull * dy) / d, r: (1.1 * pull * blur) / d };
    let v: Span = { x: alien.vx, y: alien.vy, r: alien.vr };
    // It may stop dead at any time, so its velocity lies between zero and what it would be otherwise.
    if (d + blur > sight - SLACK) {
      a = withZero(a);
      v = withZero(v);
    }
    if (a.r > pull) a = { x: 0, y: 0, r: pull };
    const half = 0.5 * seconds * seconds;
    return {
      x: alien.x + v.x * seconds + a.x * half,
      y: alien.y + v.y * seconds + a.y * half,
      r: alien.r + v.r * seconds + a.r * half + SLACK,
      vx: v.x + a.x * seconds,
      vy: v.y + a.y * seconds,
      vr: v.r + a.r * seconds + SLACK,
      touch: alien.touch,
      doubtful,
    };
  });
}

/** Discs that contain both of two sets of discs. */
export function joinedChasers(a: readonly ChaserDisc[], b: readonly ChaserDisc[]): readonly ChaserDisc[] {
  return a.map((one, i) => {
    const other = b[i];
    if (one === other) return one;
    const place = joinedSpan(one, other);
    const velocity = joinedSpan({ x: one.vx, y: one.vy, r: one.vr }, { x: other.vx, y: other.vy, r: other.vr });
    return {
      ...place,
      vx: velocity.x,
      vy: velocity.y,
      vr: velocity.r,
      touch: one.touch,
      doubtful: one.doubtful || other.doubtful,
    };
  });
}

const withZero = ({ x, y, r }: Span): Span => ({ x: x / 2, y: y / 2, r: r + length(x, y) / 2 });

function joinedSpan(a: Span, b: Span): Span {
  const d = length(a.x - b.x, a.y - b.y);
  if (d + b.r <= a.r) return { x: a.x, y: a.y, r: a.r };
  if (d + a.r <= b.r) return { x: b.x, y: b.y, r: b.r };
  const r = (d + a.r + b.r) / 2;
  const share = (r - a.r) / d;
  return { x: a.x + (b.x - a.x) * share, y: a.y + (b.y - a.y) * share, r: r + SLACK * SLACK };
}

const length = (x: number, y: number): number => Math.sqrt(x * x + y * y);
