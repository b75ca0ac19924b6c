import {
  type AccuracyName,
  compile,
  createSimulation,
  joinHolds,
  type Scene,
  WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { RandomScene } from '../scenes/random-scene.ts';
import type { Finding } from './check-scene.ts';

/** More pieces than this per second of play mean that the run does not advance. */
const MOST_PIECES: Readonly<Record<Exclude<AccuracyName, 'arcade'>, number>> = {
  precise: 20_000,
  standard: 60_000,
  fast: 60_000,
};

/**
 * Asteroids nearer to each other or to her start than this, px, cause orbits so small that other objects interrupt every turn.
 * In a field with a smaller radius than this, every other rim and every tie is a corner in which she is thrown back and forth.
 */
const CLUSTER = 0.01;

/** The most expensive second of a run. */
export interface DearestSecond {
  /** Pieces in that second; more than `most` if the count stopped there. */
  readonly pieces: number;
  /** When it begins, s from the start. */
  readonly time: number;
}

/**
 * Plays a run tick by tick, unrecorded, and counts the pieces of each second of play.
 * @param most - the run is stopped when a second takes more pieces than this
 */
export function dearestSecond(scene: Scene, holds: readonly Hold[], maxTime: number, most: number): DearestSecond {
  const budget = new WorkBudget(5 * most);
  const simulation = createSimulation(scene, budget);
  const script = joinHolds(holds);
  const counts: number[] = [0];
  let dearest: DearestSecond = { pieces: 0, time: 0 };
  for (let tick = 0; tick < 60 * maxTime && simulation.ending === null; tick++) {
    // limits each tick, since a single one could take unreasonably long
    budget.looks = 0;
    try {
      simulation.advance(
        1,
        script.some(([press, release]) => press <= tick && tick < release),
      );
    } catch (error) {
      if (!(error instanceof WorkLimitReached)) throw error;
      return { pieces: Number.POSITIVE_INFINITY, time: tick / 60 };
    }
    counts.push(simulation.work.pieces);
    const pieces = simulation.work.pieces - counts[Math.max(0, counts.length - 61)];
    if (pieces > dearest.pieces) dearest = { pieces, time: tick / 60 };
    if (pieces > most) break;
  }
  return dearest;
}

/**
 * Looks for runs that take endless pieces. Asteroids within a hundredth of a pixel of each other or of her start, or a field as
 * small as that, may take many pieces: that is reported, but not as an error of the engine.
 */
export function checkPieces({ level, holds, maxTime }: RandomScene): Finding[] {
  const findings: Finding[] = [];
  const { astronaut, asteroids, repulsors } = level;
  const near = (a: { x: number; y: number }, b: { x: number; y: number }) => Math.hypot(a.x - b.x, a.y - b.y) < CLUSTER;
  const cluster =
    asteroids.some((a, i) => near(a, astronaut) || asteroids.some((b, j) => j < i && near(a, b))) ||
    repulsors.some(({ radius }) => radius < CLUSTER);
  for (const accuracy of ['precise', 'standard', 'fast'] as const) {
    const most = MOST_PIECES[accuracy];
    const { pieces, time } = dearestSecond(compile(level, accuracy), holds, maxTime, most);
    if (pieces > most) {
      const what = `${pieces} pieces in the second up to ${time.toFixed(3)} s`;
      findings.push({ kind: cluster ? 'hangs' : 'bug', accuracy, what });
    }
  }
  return findings;
}
