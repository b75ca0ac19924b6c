import { termsReport } from '../check/words/index.ts';
import { type Run, type Scene, STATE_SIZE, simulate, WorkBudget, WorkLimitReached } from '../engine/index.ts';
import type { Hold, RunReport } from '../schema/index.ts';
import { Failure } from './io/index.ts';

/**
 * A run as in the output of `gq simulate --format json`.
 * @param sampleRate samples per second, at k / sampleRate s from the start to the end of the run; null for none
 */
export function reportRun(scene: Scene, holds: readonly Hold[], run: Run, sampleRate: number | null): RunReport {
  const { x, y, vx, vy, cos, sin } = run.final;
  return {
    level: scene.level.name,
    accuracy: scene.accuracy.name,
    terms: termsReport(scene),
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

/**
 * Plays a run, and reads of it what is needed, within the work that the level may cost.
 * @param scene the compiled level
 * @param read reads of the played run
 * @throws Failure if that costs more
 */
export function withinWorkOf<T>(scene: Scene, holds: readonly Hold[], read: (run: Run) => T): T {
  const { maxWork } = scene.terms;
  const budget = new WorkBudget(maxWork);
  const run = simulate(scene, holds, { budget });
  try {
    if (run.stopped === null) return read(run);
  } catch (error) {
    if (!(error instanceof WorkLimitReached)) throw error;
  }
  throw new Failure(
    `the run costs more work than allowed, ${maxWork} pieces of motion: allow more with --max-work, or end it earlier with --max-time`,
  );
}
