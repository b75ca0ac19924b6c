import { isJump, STATE_SIZE, TICK } from '../../engine/index.ts';
import type { Pose } from '../core/context/index.ts';
import type { LiveProof } from '../core/proof/index.ts';

/** The asteroid that the gun pulls towards: the nearest, the first one of equals; null if there is none. */
function nearestAsteroid(proof: LiveProof, x: number, y: number, moved: Float64Array | null): { x: number; y: number } | null {
  const { asteroids } = proof.level;
  let best: { x: number; y: number } | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < asteroids.length; i++) {
    const place = moved === null ? asteroids[i] : { x: moved[2 * i], y: moved[2 * i + 1] };
    const dx = place.x - x;
    const dy = place.y - y;
    const distance = dx * dx + dy * dy;
    if (distance >= least) continue;
    least = distance;
    best = place;
  }
  return best;
}

/**
 * The positions at a tick of the shown run, interpolated between ticks.
 * @param tick may be fractional; after the end of the run, the positions are those at its end
 */
export function poseAt(proof: LiveProof, tick: number): Pose {
  const { way, minerals } = proof.run;
  const { states, count, last, held } = way;
  const ended = tick >= count - 1;
  const k = Math.max(0, Math.min(count - 1, Math.floor(tick)));
  const isStraight = !ended && !isJump(states, k * STATE_SIZE, (k + 1) * STATE_SIZE, TICK);
  // An effect may move her at once: there is no position in between, so she waits for the next tick.
  const share = isStraight ? Math.max(0, tick - k) : 0;
  const between = (i: number) =>
    states[k * STATE_SIZE + i] * (1 - share) + (share > 0 ? states[(k + 1) * STATE_SIZE + i] * share : 0);
  const state = ended ? last : null;
  const x = state === null ? between(0) : state[0];
  const y = state === null ? between(1) : state[1];
  // the box turns once per tick, not in between
  const cos = state === null ? states[k * STATE_SIZE + 4] : state[4];
  const sin = state === null ? states[k * STATE_SIZE + 5] : state[5];
  const asteroids = way.asteroids.count === 0 ? null : way.asteroids.all(k);
  const aliens = way.aliens.count === 0 ? null : way.aliens.all(k);
  const collected = new Set<number>();
  for (const mineral of minerals) if (mineral.tick <= tick) collected.add(mineral.index);
  const beamTo = held[k] === 1 && !ended ? nearestAsteroid(proof, x, y, asteroids) : null;
  return { x, y, cos, sin, beamTo, aliens, asteroids, collected };
}
