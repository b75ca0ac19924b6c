import { type Run, STATE_SIZE } from '../engine/index.ts';
import type { Hold, Level } from '../schema/index.ts';

/** A run as `gq simulate --format json` gives it. */
export interface RunJson {
  /** The level's name. */
  readonly level: string;
  readonly accuracy: string;
  readonly holds: readonly Hold[];
  readonly outcome: Run['outcome'];
  readonly with: Run['with'];
  /** s */
  readonly time: number;
  readonly tick: number;
  readonly minerals: Run['minerals'];
  readonly events: Run['events'];
  readonly clearance: Run['clearance'];
  /** px, px/s, and radians, clockwise on screen */
  readonly final: { readonly x: number; readonly y: number; readonly vx: number; readonly vy: number; readonly angle: number };
  /** t, x, y, vx, vy, angle */
  readonly samples: readonly (readonly number[])[];
  readonly hash: string;
}

/**
 * @param sampleRate samples a second, at k / sampleRate s from the start to the end of the run; null for none
 */
export function runToJson(level: Level, accuracy: string, holds: readonly Hold[], run: Run, sampleRate: number | null): RunJson {
  const { x, y, vx, vy, cos, sin } = run.final;
  return {
    level: level.name,
    accuracy,
    holds,
    outcome: run.outcome,
    with: run.with,
    time: run.time,
    tick: run.tick,
    minerals: run.minerals,
    events: run.events,
    clearance: run.clearance,
    // the engine knows directions only: an angle is for people, and its last bit may differ between processors
    final: { x, y, vx, vy, angle: Math.atan2(sin, cos) },
    samples: sampleRate === null ? [] : sample(run, sampleRate),
    hash: run.hash,
  };
}

function sample(run: Run, rate: number): number[][] {
  const state = new Float64Array(STATE_SIZE);
  const samples: number[][] = [];
  for (let k = 0; k / rate <= run.trajectory.duration; k++) {
    run.trajectory.at(k / rate, state);
    samples.push([k / rate, state[0], state[1], state[2], state[3], Math.atan2(state[5], state[4])]);
  }
  return samples;
}
