import {
  type Accuracy,
  type AccuracyName,
  compile,
  createSimulation,
  joinHolds,
  playScript,
  type Simulation,
  TICK_RATE,
} from '../engine/index.ts';
import type { BenchScene } from '../tests/scenes/index.ts';

/** A scene that can be played again and again. */
export interface Replayer {
  readonly simulation: Simulation;
  /** Her state at the end of the last play. */
  readonly state: Float64Array;
  /** Plays it from the start. Returns a number that depends on where she ends. */
  run(): number;
}

/** A simulation that is reset and played to the end of a scene, as a search or a playtest does. */
export function replayer(
  { level, holds, seconds }: Pick<BenchScene, 'level' | 'holds' | 'seconds'>,
  accuracy: Accuracy | AccuracyName,
): Replayer {
  const simulation = createSimulation(compile(level, accuracy));
  const script = joinHolds(holds);
  const state = new Float64Array(6);
  return {
    simulation,
    state,
    run() {
      simulation.reset();
      playScript(simulation, script, seconds * TICK_RATE);
      simulation.readState(state);
      return state[0] + state[1];
    },
  };
}

/**
 * The same of a scene that goes on to its end.
 * @throws {Error} if the run ends before
 */
export function lasting(scene: Parameters<typeof replayer>[0], accuracy: AccuracyName, what: string): Replayer {
  const made = replayer(scene, accuracy);
  made.run();
  const { ending } = made.simulation;
  if (ending !== null) throw new Error(`${what}: the run ended (${ending.outcome})`);
  return made;
}
