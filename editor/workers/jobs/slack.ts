import { compile, createSimulation, joinHolds, maxTicksOf, type Simulation, STATE_SIZE } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { type EdgeSlack, findSlackInSteps, type Goal } from '../../../solver/index.ts';
import { job, type Played, type Work } from '../job.ts';

/** How far each press and release of a run may slip alone. */
export const slack = job<Played & { readonly holds: readonly Hold[]; readonly goal: Goal }, readonly EdgeSlack[]>({
  name: 'slack',
  lane: 'quick',
  most: 20_000,
});

export const slackWork: Work<typeof slack> = {
  of: slack,
  steps: ({ level, terms, holds, goal }) => findSlackInSteps(compile(level, terms), holds, goal),
};

/** ticks between two points of a fan's path */
export const FAN_TICKS = 3;

/** Her path when an edge comes earlier or later by its slack. */
export interface FanWay {
  /** 2 i for the press of hold i, 2 i + 1 for its release */
  readonly edge: number;
  /** ticks, negative for earlier */
  readonly shift: number;
  /** x, y in px, every `FAN_TICKS` ticks from the first that differs */
  readonly points: Float32Array;
}

/** Her paths when one edge slips, and by how much each may. */
export interface Fan {
  readonly slack: readonly EdgeSlack[];
  readonly ways: readonly FanWay[];
}

/** Her path when one edge slips by its slack. */
export const fan = job<
  Played & { readonly holds: readonly Hold[]; readonly goal: Goal },
  Fan,
  { readonly slack: readonly EdgeSlack[] }
>({ name: 'fan', lane: 'quick', most: 20_000 });

/** The holds with one edge moved by `shift` ticks. */
function shifted(holds: readonly Hold[], edge: number, shift: number): Hold[] {
  const moved = holds.map(([press, release], i): Hold => {
    if (i !== edge >> 1) return [press, release];
    return edge % 2 === 0 ? [Math.max(0, press + shift), release] : [press, release + shift];
  });
  return joinHolds(moved);
}

/** Simulates holds and records her positions from a tick on. @param maxTicks the longest a run may last */
function wayFrom(simulation: Simulation, holds: readonly Hold[], from: number, maxTicks: number): Float32Array {
  const state = new Float64Array(STATE_SIZE);
  const points: number[] = [];
  simulation.reset();
  let next = 0;
  while (simulation.ending === null && simulation.tick < maxTicks) {
    const { tick } = simulation;
    while (next < holds.length && holds[next][1] <= tick) next++;
    const isHeld = next < holds.length && holds[next][0] <= tick;
    if (tick >= from && (tick - from) % FAN_TICKS === 0) {
      simulation.readState(state);
      points.push(state[0], state[1]);
    }
    simulation.advance(1, isHeld);
  }
  simulation.readState(state);
  points.push(state[0], state[1]);
  return Float32Array.from(points);
}

/** Her path when one edge slips by its slack, for every edge, earlier and later. */
export const fanWork: Work<typeof fan> = {
  of: fan,
  *steps({ level, terms, holds, goal }) {
    const scene = compile(level, terms);
    const joined = joinHolds(holds);
    const slack = yield* findSlackInSteps(scene, joined, goal);
    yield { slack };
    const simulation = createSimulation(scene);
    const edges = joined.flat();
    const ways: FanWay[] = [];
    for (const [edge, { earlier, later }] of slack.entries()) {
      for (const shift of [-earlier, later]) {
        if (shift === 0) continue;
        const from = Math.max(0, Math.min(edges[edge], edges[edge] + shift));
        ways.push({ edge, shift, points: wayFrom(simulation, shifted(joined, edge, shift), from, maxTicksOf(terms)) });
        yield null;
      }
    }
    return { slack, ways };
  },
};
