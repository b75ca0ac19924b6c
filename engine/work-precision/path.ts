import type { Hold } from '../../schema/basics/index.ts';
import { TICK_RATE } from '../constants.ts';
import { joinHolds } from '../script.ts';
import { type Ending, type Simulation, STATE_SIZE } from '../simulation.ts';

/** Her place at every tick of a run, and how the run ended. */
export interface Path {
  /** Number of ticks, 0, 1, ... `count - 1`, all before the end. */
  readonly count: number;
  /** Her places, px. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** How the run ended; null if nothing ended it. */
  readonly ending: Ending | null;
}

/**
 * Plays holds from the start and reads her place at every tick. Nothing is recorded, so even an hour at 960 Hz fits into
 * memory.
 * @param maxTicks - ticks of 1/60 s after which the run is a timeout
 */
export function pathOf(simulation: Simulation, holds: readonly Hold[], maxTicks: number): Path {
  const script = joinHolds(holds);
  const state = new Float64Array(STATE_SIZE);
  const x: number[] = [];
  const y: number[] = [];
  const see = () => {
    simulation.readState(state);
    x.push(state[0]);
    y.push(state[1]);
  };
  simulation.reset();
  see();
  let next = 0;
  for (let tick = 0; tick < maxTicks; tick++) {
    while (next < script.length && script[next][1] <= tick) next++;
    simulation.advance(1, next < script.length && script[next][0] <= tick);
    if (simulation.ending !== null) break;
    see();
  }
  const { ending } = simulation;
  // an end within the last tick that a frame detects late does not count as earlier than that tick
  const count = ending === null ? x.length : Math.min(x.length, Math.max(1, Math.ceil(ending.time * TICK_RATE - 1e-9)));
  return { count, x: Float64Array.from(x), y: Float64Array.from(y), ending };
}

/** The largest distance between two runs at ticks before the earlier of their ends, px. */
export function largestDistance(a: Path, b: Path): number {
  let largest = 0;
  for (let i = 0; i < Math.min(a.count, b.count); i++) {
    const dx = a.x[i] - b.x[i];
    const dy = a.y[i] - b.y[i];
    largest = Math.max(largest, dx * dx + dy * dy);
  }
  return Math.sqrt(largest);
}
