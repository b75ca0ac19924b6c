import { countMinerals, type RunEnd } from '../../../check/words/index.ts';
import { compile, joinHolds, maxTicksOf, type RunEvent, simulate } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { follow, job, type Played, type Work } from '../job.ts';

/** Her way in a run, and what came of it. */
export interface Trajectory {
  /** x, y in px at every tick and at the end */
  readonly points: Float32Array;
  /** The direction of the box's x axis there: cos, sin. */
  readonly turns: Float32Array;
  readonly end: RunEnd;
  readonly events: readonly RunEvent[];
  /** How many different minerals are collected. */
  readonly minerals: number;
  /** The least distance to a hazard, px; null if there is none. */
  readonly clearance: number | null;
}

/** Her trajectory with these holds, and how it ends. */
export const trajectory = job<Played & { readonly holds: readonly Hold[] }, Trajectory>({
  name: 'trajectory',
  lane: 'long',
  most: 20_000,
});

/** Follows her tick by tick, and sums the run up. */
export const trajectoryWork: Work<typeof trajectory> = {
  of: trajectory,
  *steps({ level, terms, holds }) {
    const scene = compile(level, terms);
    const { points, turns } = yield* follow(scene, holds, maxTicksOf(terms));
    const run = simulate(scene, joinHolds(holds));
    const { outcome, with: touched, time, tick } = run;
    return {
      points,
      turns,
      end: { outcome, with: touched, time, tick },
      events: run.events,
      minerals: countMinerals(run),
      clearance: run.clearance?.distance ?? null,
    };
  },
};

/** Her path with these holds, up to a tick: x, y in px at every tick and at the end. */
export const path = job<Played & { readonly holds: readonly Hold[]; readonly until: number }, { readonly points: Float32Array }>({
  name: 'path',
  lane: 'quick',
  most: 20_000,
});

/** Follows her tick by tick. */
export const pathWork: Work<typeof path> = {
  of: path,
  *steps({ level, terms, holds, until }) {
    const { points } = yield* follow(compile(level, terms), holds, until);
    return { points };
  },
};
