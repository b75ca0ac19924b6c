import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { softlocksOf } from '../../check/index.ts';
import {
  type AccuracyName,
  compile,
  createSimulation,
  joinHolds,
  playScript,
  type Scene,
  STATE_SIZE,
  simulate,
  TICK_RATE,
} from '../../engine/index.ts';
import { type Hold, type Level, resolveLevel } from '../../schema/index.ts';
import { createSearch, createSoftlockSurvey, cutHolds, LIVES_ON, type SoftlockSurvey, verifyProof } from '../../solver/index.ts';
import { createLongProof, levelFrom, proveLost } from '../../solver/measure/softlock/prove-lost.ts';
import { describeDeep, itDeep, itQuick } from '../depth.ts';
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

/** The part of holds before a tick. */
const upTo = (holds: readonly Hold[], tick: number): Hold[] => cutHolds(joinHolds(holds), tick - 1);

describe('where the dead end is known', () => {
  it('states past the black hole are proved lost, and states before it are open', () => {
    expect(proved.length).toBeGreaterThan(20);
    expect(open.length).toBeGreaterThan(3);
    for (const { x } of proved) expect(x).toBeGreaterThan(60);
    expect(open.some(({ x }) => x < 60)).toBe(true);
  });

  itQuick('brute force completes the level from none of the proved states, and an open state has a run', () => {
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

  itQuick('a place that is proved says since when and how long she lives on, and its proof is confirmed', () => {
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

describeDeep('a state that is called proved', () => {
  it.each(['running-start'])('in %s withstands a search with ten times the effort', (slug) => {
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
  });
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

describe('since when a run was lost', () => {
  const slugs = ['first-swing', 'let-go', 'hot-rock', 'soft-landing', 'firewalk', 'tailwind'];
  /** Every run that is known to complete a level, its own and those that a search finds. */
  const completing = new Map<string, (readonly Hold[])[]>();
  const completingRuns = (slug: string): (readonly Hold[])[] => {
    const known = completing.get(slug);
    if (known !== undefined) return known;
    const { level } = shipped(slug);
    const of = compile(level);
    const search = createSearch(of, { seed: 7 });
    search.advance(60_000);
    const runs = [...level.runs, ...search.solutions].map(({ holds }) => joinHolds(holds));
    completing.set(slug, runs);
    return runs;
  };
  /** How a run begins, and then something else: most of these fail. */
  const spoiled = fc.record({
    slug: fc.constantFrom(...slugs),
    run: fc.nat(),
    cut: fc.double({ min: 0.1, max: 0.95, noNaN: true }),
    onward: fc.array(fc.tuple(fc.integer({ min: 1, max: 90 }), fc.integer({ min: 1, max: 90 })), { maxLength: 3 }),
  });

  it('is never before the last moment that it has in common with a run that completes the level', () => {
    fc.assert(
      fc.property(spoiled, ({ slug, run, cut, onward }) => {
        const { level } = shipped(slug);
        const of = compile(level);
        const runs = completingRuns(slug);
        const way = runs[run % runs.length];
        const tick = Math.floor(cut * simulate(of, way, { record: false }).time * TICK_RATE);
        let at = tick;
        const more = onward.map(([pause, held]): Hold => {
          const press = at + pause;
          at = press + held;
          return [press, at];
        });
        const holds = joinHolds([...cutHolds(way, tick - 1), ...more]);
        // it knows none of the runs
        const tracing = createSoftlockSurvey(of, { runs: [], traced: [holds], explores: false });
        tracing.advance(700_000);
        const [{ completes, open, lost, proved, last }] = tracing.losses;
        const end = simulate(of, holds, { record: false });
        expect(completes).toBe(end.outcome === 'completed');
        if (completes) {
          expect([open, lost, proved]).toEqual([last, null, null]);
          return;
        }
        // what is known to be open is never called proved, nor what comes before
        expect(proved === null || proved.tick > tick).toBe(true);
        expect(lost === null || open === null || open < lost.tick).toBe(true);
        expect(lost === null || proved === null || lost.tick <= proved.tick).toBe(true);
        if (end.outcome !== 'timeout') expect(Math.abs(last - end.time * TICK_RATE)).toBeLessThanOrEqual(1);
        for (const moment of [lost, proved]) {
          if (moment === null) continue;
          const simulation = createSimulation(of);
          playScript(simulation, holds, moment.tick);
          const state = new Float64Array(STATE_SIZE);
          simulation.readState(state);
          expect([simulation.ending, state[0], state[1]]).toEqual([null, moment.x, moment.y]);
        }
      }),
      { numRuns: 12 },
    );
  });

  itQuick('is the moment at which brute force stops completing the level', () => {
    const [held] = past.runs.slice(1).map(({ holds }) => holds);
    const tracing = createSoftlockSurvey(scene, { traced: [held], explores: false });
    tracing.advance(3_000_000);
    const [{ open, lost, proved }] = tracing.losses;
    expect(open).not.toBeNull();
    expect(lost).not.toBeNull();
    expect(proved).not.toBeNull();
    for (const tick of [proved?.tick ?? 0, (proved?.tick ?? 0) + 60]) {
      expect(bruteForce(scene, upTo(held, tick), tick), `${tick}`).toBe(false);
    }
    // letting go at the last open moment, something completes it
    const search = createSearch(scene, { after: { holds: upTo(held, open ?? 0), tick: open ?? 0 }, maxTicks: 4000 });
    search.advance(50_000);
    expect(search.solutions.length).toBeGreaterThan(0);
  });

  itDeep('comes no earlier with more effort, and is proved no later', () => {
    const tracing = createSoftlockSurvey(scene, { traced: [[[0, 600]]], explores: false });
    let [open, proved] = [-1, Number.POSITIVE_INFINITY];
    for (let i = 0; i < 30; i++) {
      tracing.advance(100_000);
      const [now] = tracing.losses;
      expect(now.open ?? -1).toBeGreaterThanOrEqual(open);
      expect(now.proved?.tick ?? Number.POSITIVE_INFINITY).toBeLessThanOrEqual(proved);
      open = now.open ?? -1;
      proved = now.proved?.tick ?? Number.POSITIVE_INFINITY;
    }
    expect(proved).toBeLessThan(600);
  });
});

describeDeep('no state on a run that completes the level is called lost', () => {
  it.each(['hot-rock', 'firewalk', 'blind-date', 'run-up'])('in %s, although the survey does not know the run', (slug) => {
    const { level } = shipped(slug);
    const of = compile(level);
    const whole = joinHolds(level.runs[0].holds);
    const end = Math.floor(simulate(of, whole, { record: false }).time * TICK_RATE);
    for (let i = 1; i < 8; i++) {
      const tick = Math.floor((i * end) / 8);
      const simulation = createSimulation(of);
      playScript(simulation, whole, tick);
      if (simulation.ending !== null) break;
      expect(proveLost(simulation, 3600, 60).proof, `tick ${tick}`).toBeNull();
      const longer = createLongProof(simulation, 3600, 60);
      while (longer !== null && longer.nextLimit > 0 && longer.nextLimit <= 2_000_000) longer.attempt();
      expect(longer?.proof ?? null, `tick ${tick}`).toBeNull();
    }
  });
});

describeDeep('finer proofs', () => {
  it('prove states that others leave open, and withstand searches with other seeds', () => {
    const found = createSoftlockSurvey(scene, { explores: false });
    found.advance(6_000_000);
    const states = found.states.filter(({ standing }) => standing.is === 'proved' && standing.proof.code === 'orbits');
    expect(states.length).toBeGreaterThan(0);
    for (const state of states.filter((_, i) => i % Math.ceil(states.length / 4) === 0)) {
      for (const seed of [11, 12]) {
        const search = createSearch(scene, { after: state, seed, maxTicks: state.tick + 3600 });
        search.advance(50_000);
        expect(search.solutions, JSON.stringify(state)).toEqual([]);
      }
    }
  });

  it('are refused where no level starts in the state, and where she lives on for too long', () => {
    const at = (level: Level, accuracy: AccuracyName, alive: number) => {
      const simulation = createSimulation(compile(level, accuracy));
      playScript(simulation, [[0, 30]], 30);
      return createLongProof(simulation, 3600, alive);
    };
    expect(at(past, 'precise', 60)).not.toBeNull();
    expect(at(past, 'precise', 60 * 21)).toBeNull();
    expect(at(past, 'arcade', 60)).toBeNull();
    expect(at({ ...past, recoil: true }, 'precise', 60)).toBeNull();
    expect(at(shipped('short-cut').level, 'precise', 60)).toBeNull();
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
