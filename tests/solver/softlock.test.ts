import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { softlocksOf } from '../../check/index.ts';
import {
  type AccuracyName,
  compile,
  createSimulation,
  playScript,
  type Scene,
  STATE_SIZE,
  simulate,
} from '../../engine/index.ts';
import { type Hold, type Level, resolveLevel } from '../../schema/index.ts';
import { createSearch, createSoftlockSurvey, LIVES_ON, type SoftlockSurvey, verifyProof } from '../../solver/index.ts';
import { levelFrom, proveLost } from '../../solver/softlock/prove-lost.ts';
import { holdsOf, shipped } from '../levels/shipped-pack.ts';

function surveyed(level: Level, ticks: number, accuracy: AccuracyName = 'precise'): { scene: Scene; survey: SoftlockSurvey } {
  const scene = compile(level, accuracy);
  const survey = createSoftlockSurvey(scene);
  survey.advance(ticks);
  return { scene, survey };
}

/** She drifts into the black hole unless the weak gun bends her way; once past it she is too fast to come back. */
const past = resolveLevel({
  version: 1,
  name: 'Past it',
  astronaut: { x: 0, y: 0, vx: 60 },
  blackHole: { x: 150, y: 30 },
  range: 450,
  rules: { pull: 10 },
  asteroids: [{ x: 60, y: -100, radius: 16 }],
  runs: [
    { name: 'drift', holds: [] },
    { name: 'hold', holds: [[0, 600]] },
  ],
});

const { scene, survey } = surveyed(past, 6_000_000);
const proved = survey.states.filter(({ standing }) => standing.is === 'proved');
const open = survey.states.filter(({ standing }) => standing.is === 'open');

/** Whether any of the continuations of a state with one or two holds on a grid of ticks completes the level. */
function bruteForce(of: Scene, holds: readonly Hold[], tick: number): boolean {
  const grid = Array.from({ length: 11 }, (_, i) => tick + 40 * i);
  const tries: Hold[][] = [[]];
  for (const a of grid) for (const b of grid) if (b > a) tries.push([[a, b]]);
  for (const a of grid)
    for (const b of grid)
      for (const c of grid)
        if (a < b && b < c)
          tries.push([
            [a, b],
            [c, c + 200],
          ]);
  return tries.some((more) => simulate(of, [...holds, ...more], { record: false }).outcome === 'completed');
}

describe('where the dead end is known', () => {
  it('states past the black hole are proved lost, and states before it are open', () => {
    expect(proved.length).toBeGreaterThan(20);
    expect(open.length).toBeGreaterThan(3);
    for (const { x } of proved) expect(x).toBeGreaterThan(60);
    expect(open.some(({ x }) => x < 60)).toBe(true);
  });

  it('brute force completes the level from none of the proved states, and an open state has a run', () => {
    for (const state of proved.filter((_, i) => i % 8 === 0)) {
      expect(bruteForce(scene, state.holds, state.tick), JSON.stringify(state)).toBe(false);
    }
    for (const state of open) {
      const search = createSearch(scene, { after: state, maxTicks: state.tick + 3600 });
      search.advance(20_000);
      const completes = simulate(scene, state.holds, { record: false }).outcome === 'completed' || search.solutions.length > 0;
      expect(completes, JSON.stringify(state)).toBe(true);
    }
  });

  it('a place that is proved says since when and how long she lives on, and its proof is confirmed', () => {
    const places = survey.places.filter(({ standing }) => standing.is === 'proved');
    expect(places.length).toBeGreaterThan(0);
    for (const { holds, tick, open: last, alive, x, y } of places) {
      expect(last === null || last < tick).toBe(true);
      expect(alive).toBeGreaterThanOrEqual(LIVES_ON);
      const simulation = createSimulation(scene);
      playScript(simulation, holds, tick);
      const state = new Float64Array(STATE_SIZE);
      simulation.readState(state);
      expect([state[0], state[1]]).toEqual([x, y]);
      const { proof, level } = proveLost(simulation, 3600, alive);
      expect(proof !== null && level !== null && verifyProof(level, proof)).toEqual({ ok: true });
    }
  });

  it('what is proved and what was merely not found are counted apart', () => {
    const { states, lasting, places } = softlocksOf(survey);
    const { examined, open: reachable, proved: lost, notFound, unknown } = states;
    expect(reachable + lost + notFound + unknown).toBe(examined);
    expect(lasting.proved).toBe(proved.filter(({ alive }) => alive >= LIVES_ON).length);
    for (const { standing } of places) expect(['proved', 'not found']).toContain(standing.is);
  });
});

describe('a state that is called proved', () => {
  it.each(['first-pull', 'running-start'])(
    'in %s withstands a search with ten times the effort',
    (slug) => {
      const { scene: of, survey: found } = surveyed(shipped(slug).level, 6_000_000);
      const states = found.states.filter(({ standing }) => standing.is === 'proved');
      expect(states.length).toBeGreaterThan(0);
      for (const state of states.filter((_, i) => i % Math.ceil(states.length / 4) === 0)) {
        for (const seed of [1, 2]) {
          const search = createSearch(of, { after: state, seed, maxTicks: state.tick + 3600 });
          search.advance(100_000);
          expect(search.solutions, JSON.stringify(state)).toEqual([]);
        }
      }
    },
    120_000,
  );
});

describe('a level that starts in the state of a run', () => {
  it('lets her fly as she flew on, whatever the angle of her box', () => {
    const levels = ['first-swing', 'slingshot', 'soft-landing', 'tailwind', 'watchdog'].map((slug) => shipped(slug).level);
    fc.assert(
      fc.property(
        fc.constantFrom(...levels),
        fc.integer({ min: 5, max: 200 }),
        fc.array(fc.tuple(fc.boolean(), fc.integer({ min: 1, max: 60 })), { maxLength: 6 }),
        (level, tick, onward) => {
          const flown = createSimulation(compile(level));
          playScript(flown, level.runs[0].holds, tick);
          const from = flown.ending === null ? levelFrom(flown) : null;
          if (from === null) return;
          const started = createSimulation(compile(from.level));
          const [a, b] = [new Float64Array(STATE_SIZE), new Float64Array(STATE_SIZE)];
          for (const [held, ticks] of onward) {
            flown.advance(ticks, held);
            started.advance(ticks, held);
            // a box that stands in another way may touch something sooner or later
            if (flown.ending !== null || started.ending !== null) return;
            flown.readState(a);
            started.readState(b);
            for (let i = 0; i < 4; i++) expect(b[i]).toBeCloseTo(a[i], 5);
          }
        },
      ),
    );
  });

  it('there is none in frames, with wormholes, or once recoil has moved an asteroid', () => {
    const at = (level: Level, accuracy: AccuracyName, tick: number) => {
      const simulation = createSimulation(compile(level, accuracy));
      playScript(simulation, [[0, tick]], tick);
      return levelFrom(simulation);
    };
    expect(at(past, 'precise', 30)).not.toBeNull();
    expect(at(past, 'arcade', 30)).toBeNull();
    expect(at({ ...past, recoil: true }, 'precise', 30)).toBeNull();
    expect(at(shipped('short-cut').level, 'precise', 0)).toBeNull();
  });
});

describe('a search from a moment of a run', () => {
  it('finds runs that pass through it', () => {
    const { level } = shipped('first-swing');
    const of = compile(level);
    const after = { holds: holdsOf(level, 'solution'), tick: 170 };
    const search = createSearch(of, { after });
    while (search.solutions.length === 0 && search.effort.ticks < 400_000) search.advance(5000);
    const [found] = search.solutions;
    expect(simulate(of, found.holds, { record: false }).outcome).toBe('completed');
    expect(found.holds[0][0]).toBe(after.holds[0][0]);
    expect(found.holds[0][1]).toBeGreaterThanOrEqual(after.tick);
    expect(search.latest).toBeGreaterThan(after.tick);
  });

  it('has nothing to try where the run is over', () => {
    const search = createSearch(scene, { after: { holds: [], tick: 1000 } });
    search.advance(1000);
    expect(search).toMatchObject({ exhausted: true, solutions: [] });
  });
});

it('gives the same however the work is split into calls', () => {
  fc.assert(
    fc.property(fc.array(fc.integer({ min: 1, max: 40_000 }), { maxLength: 8 }), (calls) => {
      const total = 180_000;
      const whole = createSoftlockSurvey(scene);
      whole.advance(total);
      const split = createSoftlockSurvey(scene);
      let left = total;
      for (const ticks of calls) {
        split.advance(Math.min(ticks, left));
        left -= Math.min(ticks, left);
      }
      split.advance(left);
      expect([split.effort, split.states, split.places]).toEqual([whole.effort, whole.states, whole.places]);
    }),
    { numRuns: 3 },
  );
});
