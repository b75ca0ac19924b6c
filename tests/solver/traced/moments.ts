import { type Accuracy, type AccuracyName, compile, createSimulation, STATE_SIZE, TICK } from '../../../engine/index.ts';
import type { Hold, Level } from '../../../schema/index.ts';

/** Something with a place and a velocity, px and px/s. */
export interface Body {
  readonly x: number;
  readonly y: number;
  readonly vx: number;
  readonly vy: number;
}

/** A state of a run that goes on, as the engine reads it. */
export interface Moment extends Body {
  readonly tick: number;
  readonly cos: number;
  readonly sin: number;
  /** Places of the asteroids, x and y in turn. */
  readonly rocks: Float64Array;
  /** Velocities of the asteroids; null where they cannot be told. */
  readonly speeds: Float64Array | null;
  /** Of each alien x, y, and 1 unless it has exploded. */
  readonly aliens: Float64Array;
}

/**
 * The states of a run at each tick as long as it goes on; what is over at the instant of a tick does not go on. The engine does not tell an asteroid's velocity; while the gun does not
 * pull, it is constant, so it follows from two places.
 */
export function momentsOf(level: Level, accuracy: AccuracyName | Accuracy, holds: readonly Hold[], ticks: number): Moment[] {
  const simulation = createSimulation(compile(level, accuracy));
  const state = new Float64Array(STATE_SIZE);
  const isHeld = (tick: number) => holds.some(([press, release]) => press <= tick && tick < release);
  const seen: Omit<Moment, 'speeds'>[] = [];
  const endedAt = () => simulation.ending?.time ?? Number.POSITIVE_INFINITY;
  while (endedAt() === Number.POSITIVE_INFINITY && seen.length <= ticks) {
    simulation.readState(state);
    const [x, y, vx, vy, cos, sin] = state;
    const rocks = new Float64Array(2 * level.asteroids.length);
    const aliens = new Float64Array(3 * level.aliens.length);
    simulation.readAsteroids(rocks);
    simulation.readAliens(aliens);
    const { tick } = simulation;
    simulation.advance(1, isHeld(tick));
    if (endedAt() <= tick * TICK) break;
    seen.push({ tick, x, y, vx, vy, cos, sin, rocks, aliens });
  }
  return seen.map((now, n): Moment => {
    if (!level.recoil) return { ...now, speeds: new Float64Array(now.rocks.length) };
    const next = seen[n + 1];
    if (next === undefined || isHeld(now.tick)) return { ...now, speeds: null };
    return { ...now, speeds: now.rocks.map((at, k) => (next.rocks[k] - at) / TICK) };
  });
}
