import { compile, createSimulation, joinHolds, type Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';

/** What the dearest second of a run took. */
export interface DearestSecond {
  /** Pieces in it, more than `most` where counting ended there. */
  readonly pieces: number;
  /** s from the start */
  readonly time: number;
}

/**
 * Plays a run tick by tick, unrecorded, and counts the pieces of each second of play.
 * @param most from so many pieces in a second on it is not played on
 */
export function dearestSecond(scene: Scene, holds: readonly Hold[], maxTime: number, most: number): DearestSecond {
  const simulation = createSimulation(scene);
  const script = joinHolds(holds);
  const counts: number[] = [0];
  let dearest: DearestSecond = { pieces: 0, time: 0 };
  for (let tick = 0; tick < 60 * maxTime && simulation.ending === null; tick++) {
    simulation.advance(
      1,
      script.some(([press, release]) => press <= tick && tick < release),
    );
    counts.push(simulation.work.pieces);
    const pieces = simulation.work.pieces - counts[Math.max(0, counts.length - 61)];
    if (pieces > dearest.pieces) dearest = { pieces, time: tick / 60 };
    if (pieces > most) break;
  }
  return dearest;
}

export { compile };
