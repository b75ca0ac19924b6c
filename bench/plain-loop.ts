import type { Hold, Level } from '../schema/index.ts';

/**
 * The result of the loop: the frame in which it stopped, the outcome (0 still going, 1 lost, 2 completed, 3 burned) and her
 * state.
 */
export interface PlainState {
  frame: number;
  outcome: number;
  x: number;
  y: number;
  vx: number;
  vy: number;
  cos: number;
  sin: number;
}

/** A level and a script laid out for {@link plainLoop}: parallel arrays, nothing shared with the engine. */
export interface PlainScene {
  readonly start: readonly [x: number, y: number, vx: number, vy: number];
  readonly range: number;
  /** Centres of the cold asteroids, then of the hot ones, px. */
  readonly tx: Float64Array;
  readonly ty: Float64Array;
  /** Everything that can be touched: the black hole, then novae, then hot asteroids; centre and radius, px. */
  readonly cx: Float64Array;
  readonly cy: Float64Array;
  readonly cr: Float64Array;
  /** Frames at which the button changes, ascending; it is up at first. */
  readonly edges: Int32Array;
}

/**
 * Lays a level out for the plain loop. Only the gun, hazards, the black hole and the range: no recoil, fields, aliens or
 * minerals.
 */
export function plainScene(level: Level, holds: readonly Hold[]): PlainScene {
  const hot = level.asteroids.filter((a) => a.hot);
  const targets = [...level.asteroids.filter((a) => !a.hot), ...hot];
  const circles = [level.blackHole, ...level.novae, ...hot];
  const { x, y, vx, vy } = level.astronaut;
  return {
    start: [x, y, vx, vy],
    range: level.range,
    tx: Float64Array.from(targets, (c) => c.x),
    ty: Float64Array.from(targets, (c) => c.y),
    cx: Float64Array.from(circles, (c) => c.x),
    cy: Float64Array.from(circles, (c) => c.y),
    cr: Float64Array.from(circles, (c) => c.radius),
    edges: Int32Array.from(holds.flat()),
  };
}

/**
 * The original's frame rules for one scene, as one would write them by hand if nothing else were wanted: no events, no
 * snapshots, no choice of effects, a single function. It is the yardstick for what the engine's generality costs.
 */
export function plainLoop(scene: PlainScene, frames: number, out: PlainState): void {
  const { tx, ty, cx, cy, cr, edges, range } = scene;
  const targets = tx.length;
  const circles = cx.length;
  const dt = 1 / 60;
  let [x, y, vx, vy] = scene.start;
  let ax = 0;
  let ay = 0;
  let cos = 1;
  let sin = 0;
  let held = false;
  let edge = 0;
  let outcome = 0;
  let frame = 0;
  while (frame < frames && outcome === 0) {
    while (edge < edges.length && edges[edge] === frame) {
      held = !held;
      edge++;
    }
    vx += ax * dt;
    vy += ay * dt;
    if (vx > 1000) vx = 1000;
    else if (vx < -1000) vx = -1000;
    if (vy > 1000) vy = 1000;
    else if (vy < -1000) vy = -1000;

    const moveX = vx * dt;
    const moveY = vy * dt;

    let best = Number.POSITIVE_INFINITY;
    let nearest = 0;
    for (let i = 0; i < targets; i++) {
      const dx = tx[i] - x;
      const dy = ty[i] - y;
      const d = dx * dx + dy * dy;
      if (d < best) {
        best = d;
        nearest = i;
      }
    }
    if (best > range * range) outcome = 1;
    ax = 0;
    ay = 0;
    if (held) {
      const d = Math.sqrt(best);
      cos = d > 0 ? (tx[nearest] - x) / d : 1;
      sin = d > 0 ? (ty[nearest] - y) / d : 0;
      const pull = 39 * (1 - d / range);
      ax = pull * cos;
      ay = pull * sin;
    }
    for (let i = 0; i < circles && outcome === 0; i++) {
      const dx = cx[i] - x;
      const dy = cy[i] - y;
      const r = cr[i];
      const reach = r + 18.868;
      if (dx > reach || dx < -reach || dy > reach || dy < -reach) continue;
      const gx = Math.max(0, Math.abs(dx * cos + dy * sin) - 10);
      const gy = Math.max(0, Math.abs(dy * cos - dx * sin) - 16);
      if (gx * gx + gy * gy < r * r) outcome = i === 0 ? 2 : 3;
    }
    // this frame's displacement stays
    if (outcome === 3) {
      vx = 0;
      vy = 0;
    }
    x += moveX;
    y += moveY;
    frame++;
  }
  out.frame = frame;
  out.outcome = outcome;
  out.x = x;
  out.y = y;
  out.vx = vx;
  out.vy = vy;
  out.cos = cos;
  out.sin = sin;
}
