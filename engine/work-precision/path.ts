import type { Hold } from '../../schema/index.ts';
import { TICK_RATE } from '../constants.ts';
import { joinHolds } from '../script.ts';
import { type Ending, type Simulation, STATE_SIZE } from '../simulation.ts';

/** Where she was at every tick of a run, and how it ended. */
export interface Path {
  /** Ticks she was seen at: 0, 1, ... `count - 1`, all before the end. */
  readonly count: number;
  /** px */
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** null: nothing ended it */
  readonly ending: Ending | null;
}

/**
 * Plays a script from the start, looking at her at every tick. Nothing is recorded, so that an hour at 960 Hz fits as well.
 * @param maxTicks ticks of 1/60 s after which the run is a timeout
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
  // an end within the last tick, seen late by a frame, is no earlier than the tick itself
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
