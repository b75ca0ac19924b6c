import { boxOf, boxOverlapsCircle, EXPLOSION_FRAMES, TICK } from '../../engine/index.ts';
import { type Level, rulesOf } from '../../schema/index.ts';

/**
 * The frames of the original with every object checked in every frame, written for clarity. `arcade` must have the same bits.
 * @param button whether the gun is held, by frame
 */
export function plainFrames(level: Level, button: readonly boolean[]) {
  const { astronaut, blackHole, range, recoil, novae, repulsors, minerals } = level;
  const rules = rulesOf(level);
  const box = boxOf(rules);
  const limited = (v: number) => Math.min(rules.speedLimit, Math.max(-rules.speedLimit, v));
  const still = { vx: 0, vy: 0, ax: 0, ay: 0 };
  const cold = level.asteroids.filter(({ hot }) => !hot);
  const rocks = [...cold, ...level.asteroids.filter(({ hot }) => hot)].map((a) => ({ ...a, ...still }));
  const aliens = level.aliens.map((a) => ({ ...a, ...still, exploded: false, chasesUntil: 0 }));
  const collected = minerals.map(() => false);
  /** The mouth of a wormhole in which she is. */
  const mouthAround = (w: number, atX: number, atY: number): 'first' | 'second' | null => {
    const { x: firstX, y: firstY, toX, toY, radius } = level.wormholes[w];
    const inside = (cx: number, cy: number) => (atX - cx) * (atX - cx) + (atY - cy) * (atY - cy) < radius * radius;
    return inside(firstX, firstY) ? 'first' : inside(toX, toY) ? 'second' : null;
  };
  const mouths = level.wormholes.map((_, w) => mouthAround(w, astronaut.x, astronaut.y));
  let { x, y, vx, vy } = astronaut;
  let ax = 0;
  let ay = 0;
  let cos = 1;
  let sin = 0;
  let counted = 0;
  let outcome: 'lost' | 'completed' | 'collided' | null = null;
  let frame = 0;
  for (; frame < button.length && outcome === null; frame++) {
    vx = limited(vx + ax * TICK);
    vy = limited(vy + ay * TICK);
    const moveX = vx * TICK;
    const moveY = vy * TICK;
    for (const body of [...(recoil ? rocks : []), ...aliens]) {
      body.vx = limited(body.vx + body.ax * TICK);
      body.vy = limited(body.vy + body.ay * TICK);
    }
    const alienMoves = aliens.map((a) => [a.vx * TICK, a.vy * TICK] as const);

    const distances = rocks.map((rock) => (rock.x - x) * (rock.x - x) + (rock.y - y) * (rock.y - y));
    const best = Math.min(...distances);
    const nearest = rocks[distances.indexOf(best)];
    if (best > range * range) outcome = 'lost';
    ax = 0;
    ay = 0;
    if (nearest !== undefined && button[frame]) {
      const d = Math.sqrt(best);
      cos = d > 0 ? (nearest.x - x) / d : 1;
      sin = d > 0 ? (nearest.y - y) / d : 0;
      const pull = rules.pull * (1 - d / range);
      ax = pull * cos;
      ay = pull * sin;
      nearest.ax = (-rules.recoil / (2 * nearest.radius)) * cos;
      nearest.ay = (-rules.recoil / (2 * nearest.radius)) * sin;
    } else if (nearest !== undefined) {
      nearest.ax = 0;
      nearest.ay = 0;
    }

    if (outcome === null) {
      const touches = (c: { x: number; y: number; radius: number }) =>
        boxOverlapsCircle(box, c.x - x, c.y - y, cos, sin, c.radius);
      if (touches(blackHole)) outcome = 'completed';
      else if ([...novae, ...rocks.slice(cold.length)].some(touches)) outcome = 'collided';
      const touched = minerals.flatMap((mineral, i) => (!collected[i] && touches(mineral) ? [i] : []));
      counted += touched.length;
      if (touched.length > 0) collected[touched[touched.length - 1]] = true;
      if (outcome === null && aliens.some(touches)) outcome = 'collided';
      for (const [i, a] of aliens.entries()) {
        for (const b of aliens.slice(i + 1)) {
          const reach = a.radius + b.radius;
          if (a.exploded || b.exploded || (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) >= reach * reach) continue;
          for (const alien of [a, b]) {
            alien.exploded = true;
            alien.chasesUntil = frame + EXPLOSION_FRAMES;
          }
        }
      }
    }

    for (const alien of aliens) {
      const dx = x - alien.x;
      const dy = y - alien.y;
      const d = Math.sqrt(dx * dx + dy * dy);
      if (d < rules.alienSight && !(alien.exploded && frame >= alien.chasesUntil)) {
        alien.ax = d > 0 ? (rules.alienPull * dx) / d : rules.alienPull;
        alien.ay = d > 0 ? (rules.alienPull * dy) / d : 0;
      } else {
        Object.assign(alien, still);
      }
    }
    const field = repulsors.find((c) => (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y) < c.radius * c.radius);
    if (field !== undefined) {
      const dx = x - field.x;
      const dy = y - field.y;
      const d = Math.sqrt(dx * dx + dy * dy);
      ax = d > 0 ? (rules.push * dx) / d : rules.push;
      ay = d > 0 ? (rules.push * dy) / d : 0;
    }
    for (const wind of level.winds) {
      if ((x - wind.x) * (x - wind.x) + (y - wind.y) * (y - wind.y) >= wind.radius * wind.radius) continue;
      ax += wind.ax;
      ay += wind.ay;
    }
    for (const [w, around] of mouths.entries()) if (around !== null) mouths[w] = mouthAround(w, x, y);
    const entered = level.wormholes.findIndex((_, w) => mouths[w] === null && mouthAround(w, x, y) !== null);
    if (entered >= 0) {
      const { x: fromX, y: fromY, toX, toY } = level.wormholes[entered];
      const isFirst = mouthAround(entered, x, y) === 'first';
      x += isFirst ? toX - fromX : fromX - toX;
      y += isFirst ? toY - fromY : fromY - toY;
      for (const w of mouths.keys()) mouths[w] = mouthAround(w, x, y);
      mouths[entered] = isFirst ? 'second' : 'first';
    }
    if (outcome === 'collided') {
      vx = 0;
      vy = 0;
    }
    x += moveX;
    y += moveY;
    for (const rock of recoil ? rocks : []) {
      rock.x += rock.vx * TICK;
      rock.y += rock.vy * TICK;
    }
    for (const [i, alien] of aliens.entries()) {
      alien.x += alienMoves[i][0];
      alien.y += alienMoves[i][1];
    }
  }
  return {
    frames: frame,
    outcome,
    minerals: counted,
    collected,
    state: [x, y, vx, vy, cos, sin],
    aliens: aliens.flatMap((a) => [a.x, a.y, a.exploded ? 0 : 1]),
    // restores the order of the level
    asteroids: level.asteroids.flatMap(({ hot }, i) => {
      const same = level.asteroids.slice(0, i).filter((a) => a.hot === hot).length;
      const rock = rocks[hot ? cold.length + same : same];
      return [rock.x, rock.y];
    }),
  };
}
