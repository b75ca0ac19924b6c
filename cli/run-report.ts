import { type Run, STATE_SIZE } from '../engine/index.ts';
import type { Hold, Level, RunReport } from '../schema/index.ts';

/**
 * A run as in the output of `gq simulate --format json`.
 * @param sampleRate samples per second, at k / sampleRate s from the start to the end of the run; null for none
 */
export function reportRun(
  level: Level,
  accuracy: string,
  holds: readonly Hold[],
  run: Run,
  sampleRate: number | null,
): RunReport {
  const { x, y, vx, vy, cos, sin } = run.final;
  return {
    level: level.name,
    accuracy,
    holds: holds.map(([press, release]) => [press, release]),
    outcome: run.outcome,
    with: run.with,
    time: run.time,
    tick: run.tick,
    minerals: [...run.minerals],
    events: [...run.events],
    clearance: run.clearance,
    // the engine uses directions, not angles: an angle is for people, and its last bit may differ between processors
    final: { x, y, vx, vy, angle: Math.atan2(sin, cos) },
    samples: sampleRate === null ? [] : sample(run, sampleRate),
    hash: run.hash,
  };
}

function sample(run: Run, rate: number): RunReport['samples'] {
  const state = new Float64Array(STATE_SIZE);
  const samples: RunReport['samples'] = [];
  for (let k = 0; k / rate <= run.trajectory.duration; k++) {
    run.trajectory.at(k / rate, state);
    samples.push([k / rate, state[0], state[1], state[2], state[3], Math.atan2(state[5], state[4])]);
  }
  return samples;
}
