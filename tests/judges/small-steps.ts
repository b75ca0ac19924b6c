import { DEFAULT_RULES, type Hold, type Level } from '../../schema/index.ts';

export interface Moving {
  x: number;
  y: number;
  vx: number;
  vy: number;
}

/** For each wormhole, which mouth she is in; 0 for none, so that it is open. */
type Mouths = number[];

/** Ticks per second, defined again: nothing here comes from the engine. */
const TICKS = 60;

/**
 * The game by small steps alone: her state after `time` s by the classical Runge-Kutta method at `step` s, with rims found by
 * bisection. The astronaut is a point, asteroids stand still, and there are repulsors, winds and wormholes, but no range and no
 * speed limit. It shares no code with the engine.
 * @param holds - in order, not touching each other
 */
export function bySmallSteps(level: Level, holds: readonly Hold[], time: number, step: number): Moving {
  const { pull, push } = DEFAULT_RULES;
  const inside = (o: { x: number; y: number; radius: number }, x: number, y: number) => Math.hypot(x - o.x, y - o.y) < o.radius;
  // the forces are chosen once per step, so that no step contains a jump of a force
  type Acting = {
    winds: readonly Level['winds'][number][];
    field: Level['repulsors'][number] | undefined;
    rock: Level['asteroids'][number];
  };
  const actingAt = (x: number, y: number): Acting => ({
    winds: level.winds.filter((wind) => inside(wind, x, y)),
    field: level.repulsors.find((repulsor) => inside(repulsor, x, y)),
    rock: level.asteroids.reduce((a, b) => (Math.hypot(b.x - x, b.y - y) < Math.hypot(a.x - x, a.y - y) ? b : a)),
  });
  let held = false;
  const same = (a: Acting, b: Acting) =>
    a.field === b.field &&
    (!held || a.rock === b.rock) &&
    a.winds.length === b.winds.length &&
    a.winds.every((w) => b.winds.includes(w));
  const accelerate = ({ winds, field, rock }: Acting, x: number, y: number): [number, number] => {
    let ax = winds.reduce((sum, wind) => sum + wind.ax, 0);
    let ay = winds.reduce((sum, wind) => sum + wind.ay, 0);
    const centre = field ?? (held ? rock : undefined);
    if (centre === undefined) return [ax, ay];
    const dx = centre.x - x;
    const dy = centre.y - y;
    const d = Math.hypot(dx, dy);
    if (d === 0) return [ax, ay];
    const strength = field === undefined ? pull * (1 - d / level.range) : -push;
    ax += (strength * dx) / d;
    ay += (strength * dy) / d;
    return [ax, ay];
  };
  const advance = (acting: Acting, { x, y, vx, vy }: Moving, h: number): Moving => {
    const [ax, ay] = accelerate(acting, x, y);
    const [bx, by] = accelerate(acting, x + (h / 2) * vx, y + (h / 2) * vy);
    const [cx, cy] = accelerate(acting, x + (h / 2) * vx + (h * h * ax) / 4, y + (h / 2) * vy + (h * h * ay) / 4);
    const [dx, dy] = accelerate(acting, x + h * vx + (h * h * bx) / 2, y + h * vy + (h * h * by) / 2);
    return {
      x: x + h * vx + ((h * h) / 6) * (ax + bx + cx),
      y: y + h * vy + ((h * h) / 6) * (ay + by + cy),
      vx: vx + (h / 6) * (ax + 2 * bx + 2 * cx + dx),
      vy: vy + (h / 6) * (ay + 2 * by + 2 * cy + dy),
    };
  };
  const mouthAt = (w: Level['wormholes'][number], x: number, y: number) =>
    inside(w, x, y) ? 1 : inside({ x: w.toX, y: w.toY, radius: w.radius }, x, y) ? 2 : 0;

  const { x, y, vx, vy } = level.astronaut;
  let at: Moving = { x, y, vx, vy };
  const mouths: Mouths = level.wormholes.map((w) => mouthAt(w, x, y));
  const changes = holds.flat().map((tick) => tick / TICKS);
  for (let t = 0; t < time; ) {
    const coming = changes.findIndex((change) => change > t);
    // changes are press, release, press ...: the gun is held after an odd number of them
    held = (coming === -1 ? changes.length : coming) % 2 === 1;
    const until = coming === -1 ? time : Math.min(time, changes[coming]);
    const acting = actingAt(at.x, at.y);
    const isQuiet = (to: Moving) =>
      same(acting, actingAt(to.x, to.y)) && level.wormholes.every((w, i) => mouthAt(w, to.x, to.y) === mouths[i]);
    let h = Math.min(step, until - t);
    const isLast = h < step;
    let next = advance(acting, at, h);
    let isWhole = true;
    if (!isQuiet(next)) {
      isWhole = false;
      let low = 0;
      for (let n = 0; n < 60; n++) {
        const middle = (low + h) / 2;
        if (isQuiet(advance(acting, at, middle))) low = middle;
        else h = middle;
      }
      next = advance(acting, at, h);
    }
    t = isWhole && isLast ? until : t + h;
    at = next;
    for (const [i, w] of level.wormholes.entries()) {
      const mouth = mouthAt(w, at.x, at.y);
      if (mouth === mouths[i]) continue;
      if (mouths[i] !== 0) {
        mouths[i] = mouth;
        continue;
      }
      const sign = mouth === 1 ? 1 : -1;
      at = { ...at, x: at.x + sign * (w.toX - w.x), y: at.y + sign * (w.toY - w.y) };
      for (const [k, other] of level.wormholes.entries()) mouths[k] = mouthAt(other, at.x, at.y);
      mouths[i] = 3 - mouth;
    }
  }
  return at;
}
