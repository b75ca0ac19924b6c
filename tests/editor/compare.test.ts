import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Attempts, createAttempts } from '../../editor/core/attempts/attempts.ts';
import type { OpenLevel } from '../../editor/core/context/index.ts';
import {
  addRun,
  createEditedLevel,
  deleteRun,
  type EditedLevel,
  renameRun,
  setLevelProperty,
} from '../../editor/core/document/index.ts';
import { createProofStore, type ProofStore } from '../../editor/core/proof/index.ts';
import { CANVAS_LAYERS, createSession } from '../../editor/core/session/index.ts';
import {
  comparedOf,
  isFresh,
  MOST_COMPARED,
  type Source,
  sourceHolds,
  sourceKey,
  toggleAccuracies,
  toggleCompared,
  watchCompared,
} from '../../editor/features/compare/compared.ts';
import { poseOf, raceOf } from '../../editor/features/compare/racers.ts';
import type { JobEnd, Requests, Results, Workers } from '../../editor/workers/index.ts';
import { JOBS } from '../../editor/workers/runner.ts';
import { ACCURACIES, compile, createSimulation, DEFAULT_TERMS, playScript, STATE_SIZE, simulate } from '../../engine/index.ts';
import { pathOf } from '../../engine/work-precision/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import { TurnedClock } from './stage.ts';

const FILE: LevelFile = {
  version: 1,
  name: 'three runs',
  astronaut: { x: 200, y: 304 },
  blackHole: { x: 704, y: 304 },
  asteroids: [{ id: 'rock', x: 448, y: 304, radius: 16 }],
  minerals: [{ id: 'gem', x: 320, y: 304, radius: 7 }],
  runs: [
    { name: 'solution', holds: [[0, 600]] },
    { name: 'late', holds: [[30, 600]] },
    { name: 'short', holds: [[0, 60]] },
    { name: 'never', holds: [] },
    {
      name: 'twice',
      holds: [
        [0, 40],
        [50, 600],
      ],
    },
  ],
};

const run = (name: string): Source => ({ kind: 'run', name });

/** What a job of a worker gives, computed here. */
function played(request: Requests['trajectory']): Results['trajectory'] {
  const work = JOBS.trajectory(request, () => 0);
  for (;;) {
    const step = work.next();
    if (step.done === true) return step.value;
  }
}

interface Asked {
  readonly request: Requests['trajectory'];
  readonly answer: () => void;
  readonly giveUp: () => void;
  isCancelled: boolean;
}

interface Stage {
  readonly document: EditedLevel;
  readonly proof: ProofStore;
  readonly attempts: Attempts;
  readonly level: OpenLevel;
  readonly clock: TurnedClock;
  readonly jobs: Asked[];
  readonly stop: () => void;
  readonly store: ReturnType<typeof comparedOf>;
}

function stage(file: LevelFile = FILE): Stage {
  const document = createEditedLevel(file);
  const proof = createProofStore(document, DEFAULT_TERMS);
  const attempts = createAttempts();
  const level = { document, proof, attempts } as unknown as OpenLevel;
  const clock = new TurnedClock();
  const after = (ms: number, call: () => void) => clock.after(ms, call);
  const jobs: Asked[] = [];
  const start = (_: 'trajectory', request: Requests['trajectory']) => {
    let end: (end: JobEnd<Results['trajectory']>) => void = () => {};
    const ended = new Promise<JobEnd<Results['trajectory']>>((resolve) => {
      end = resolve;
    });
    const job: Asked = {
      request,
      answer: () => end({ kind: 'done', result: played(request) }),
      giveUp: () => end({ kind: 'gaveUp', message: 'work limit' }),
      isCancelled: false,
    };
    jobs.push(job);
    return {
      end: ended,
      cancel: () => {
        job.isCancelled = true;
        end({ kind: 'cancelled' });
      },
    };
  };
  const desk = { workers: { start: start as unknown as Workers['start'] }, afterRest: after, after };
  const stop = watchCompared(level, desk);
  return { document, proof, attempts, level, clock, jobs, stop, store: comparedOf(level) };
}

const freshIn = ({ store, proof, level }: Stage, source: Source): boolean =>
  isFresh(store.getState().trajectories.get(sourceKey(source)), proof.proof(), sourceHolds(level, source) ?? []);

/** Answers requests until there are none. */
async function answerAll({ clock, jobs }: Stage): Promise<void> {
  for (let done = 0; ; ) {
    await clock.pass(1000);
    if (done === jobs.length) return;
    for (; done < jobs.length; done++) jobs[done].answer();
  }
}

describe('compared runs', () => {
  it('are four at most, each in a slot that it keeps', () => {
    const { store } = stage();
    for (const name of ['late', 'short', 'never', 'twice']) expect(toggleCompared(store, run(name))).toBe(true);
    expect(toggleCompared(store, run('fifth'))).toBe(false);
    expect(store.getState().runs).toHaveLength(MOST_COMPARED);
    expect(toggleCompared(store, run('short'))).toBe(true);
    expect(store.getState().runs.map(({ slot }) => slot)).toEqual([0, 2, 3]);
    toggleCompared(store, { kind: 'attempt', number: 1 });
    expect(store.getState().runs.map(({ source, slot }) => [sourceKey(source), slot])).toEqual([
      ['run late', 0],
      ['attempt 1', 1],
      ['run never', 2],
      ['run twice', 3],
    ]);
  });

  it('cost nothing while there are none', async () => {
    const all = stage();
    all.document.change('range', setLevelProperty('range', 300));
    await all.clock.pass(5000);
    expect(all.jobs).toHaveLength(0);
    toggleCompared(all.store, run('late'));
    await answerAll(all);
    toggleCompared(all.store, run('late'));
    const { length } = all.jobs;
    all.document.change('range', setLevelProperty('range', 310));
    await all.clock.pass(5000);
    expect(all.jobs).toHaveLength(length);
    expect(all.store.getState().trajectories.size).toBe(0);
  });

  it('are simulated as the engine does it, in the level as it is', async () => {
    const all = stage();
    toggleCompared(all.store, run('late'));
    await answerAll(all);
    const { found } = all.store.getState().trajectories.get('run late') ?? {};
    const expected = simulate(compile(resolveLevel(FILE), 'precise'), [[30, 600]]);
    expect(found?.end).toEqual({ outcome: expected.outcome, with: expected.with, time: expected.time, tick: expected.tick });
    expect(found?.minerals).toBe(1);
    expect(found?.clearance).toBe(expected.clearance?.distance ?? null);
  });

  it('bend while the level changes: one request at a time, the latest level next, stale until it is answered', async () => {
    const all = stage();
    toggleCompared(all.store, run('late'));
    await answerAll(all);
    expect(freshIn(all, run('late'))).toBe(true);
    const before = all.jobs.length;
    const drag = all.document.begin('drag');
    for (let i = 1; i <= 20; i++) {
      drag.set((draft) => {
        draft.asteroids![0].y = 304 + i;
      });
      await all.clock.pass(16);
    }
    // the first request is not answered: no other is made
    expect(all.jobs).toHaveLength(before + 1);
    expect(freshIn(all, run('late'))).toBe(false);
    all.jobs[before].answer();
    await all.clock.pass(1000);
    // shown, though of a level that has gone on; then the level as it is now
    expect(all.store.getState().trajectories.get('run late')?.found).not.toBe(null);
    expect(freshIn(all, run('late'))).toBe(false);
    expect(all.jobs).toHaveLength(before + 2);
    expect(all.jobs[before + 1].request.level.asteroids[0].y).toBe(324);
    all.jobs[before + 1].answer();
    await all.clock.pass(1000);
    expect(freshIn(all, run('late'))).toBe(true);
    expect(all.jobs).toHaveLength(before + 2);
  });

  it('take turns: none starves the others', async () => {
    const all = stage();
    for (const name of ['late', 'short', 'never']) toggleCompared(all.store, run(name));
    for (let i = 0; i < 9; i++) {
      all.document.change('range', setLevelProperty('range', 300 + i));
      await all.clock.pass(100);
      all.jobs.at(-1)?.answer();
      await all.clock.pass(100);
    }
    const holds = all.jobs.slice(0, 9).map(({ request }) => request.holds.join());
    for (const own of ['30,600', '0,60', '']) expect(holds.filter((one) => one === own).length).toBeGreaterThanOrEqual(2);
  });

  it('that are given up say so, and are not tried again for the same level', async () => {
    const all = stage();
    toggleCompared(all.store, run('late'));
    await all.clock.pass(100);
    all.jobs[0].giveUp();
    await all.clock.pass(5000);
    expect(all.store.getState().trajectories.get('run late')?.found).toBe(null);
    expect(all.jobs).toHaveLength(1);
  });

  it('leave when they are deleted, stay when they are renamed, and change places with the shown one', async () => {
    const all = stage();
    const keys = () => all.store.getState().runs.map(({ source, slot }) => `${slot} ${sourceKey(source)}`);
    toggleCompared(all.store, run('late'));
    toggleCompared(all.store, run('short'));
    all.proof.showRun('late');
    expect(keys()).toEqual(['0 run solution', '1 run short']);
    all.document.change('rename', renameRun('short', 'brief'));
    expect(keys()).toEqual(['0 run solution', '1 run brief']);
    all.document.change('delete', deleteRun('brief'));
    expect(keys()).toEqual(['0 run solution']);
    all.document.undo();
    all.document.change('add', addRun('new', []));
    expect(keys()).toEqual(['0 run solution']);
    all.stop();
    expect(all.jobs.every(({ isCancelled }, i) => isCancelled || i < all.jobs.length - 1)).toBe(true);
  });

  it('of attempts stay as long as the attempt does', async () => {
    const all = stage();
    const attempt = { holds: [[5, 9]], end: null, tick: 50, minerals: 0, accuracy: 'precise', points: new Float32Array(2) };
    const { number } = all.attempts.add({ ...attempt, played: {} } as never);
    toggleCompared(all.store, { kind: 'attempt', number });
    await answerAll(all);
    expect(all.jobs[0].request.holds).toEqual([[5, 9]]);
    all.attempts.remove(number);
    expect(all.store.getState().runs).toEqual([]);
  });
});

describe('accuracies beside the shown run', () => {
  const keys = ({ store }: Stage) => store.getState().runs.map(({ source }) => sourceKey(source));

  it('are all that are not in use, in place of what was compared, and each is simulated at its own', async () => {
    const all = stage();
    toggleCompared(all.store, run('late'));
    toggleAccuracies(all.store, 'precise');
    expect(keys(all)).toEqual(['accuracy arcade', 'accuracy fast', 'accuracy standard']);
    await answerAll(all);
    const level = resolveLevel(FILE);
    for (const name of ['arcade', 'fast', 'standard'] as const) {
      const { outcome, time } = simulate(compile(level, name), [[0, 600]]);
      const { found } = all.store.getState().trajectories.get(`accuracy ${name}`)!;
      expect(found?.end).toMatchObject({ outcome, time });
      expect(freshIn(all, { kind: 'accuracy', name })).toBe(true);
    }
    toggleAccuracies(all.store, 'precise');
    expect(keys(all)).toEqual([]);
  });

  it('follow the shown run, and the one that comes into use changes places with the one that was', async () => {
    const all = stage();
    toggleAccuracies(all.store, 'precise');
    await answerAll(all);
    all.proof.showRun('late');
    expect(freshIn(all, { kind: 'accuracy', name: 'fast' })).toBe(false);
    await answerAll(all);
    expect(all.jobs.at(-1)?.request.holds).toEqual([[30, 600]]);
    expect(keys(all)).toEqual(['accuracy arcade', 'accuracy fast', 'accuracy standard']);
    all.proof.setTerms({ ...DEFAULT_TERMS, accuracy: ACCURACIES.fast });
    expect(keys(all)).toEqual(['accuracy arcade', 'accuracy precise', 'accuracy standard']);
  });

  it('glow where they part from the shown run by a pixel, and only there', async () => {
    // past the asteroid instead of through its centre
    const file: LevelFile = { ...FILE, astronaut: { x: 240, y: 270, vx: 0, vy: 20 } };
    const all = stage(file);
    toggleAccuracies(all.store, 'precise');
    toggleCompared(all.store, run('short'));
    await answerAll(all);
    const session = createSession(CANVAS_LAYERS);
    const settings = { getState: () => ({ runInPlay: false }) } as never;
    const { racers } = raceOf({ session, settings }, all.level)();
    const parts = new Map(racers.map((racer) => [racer.name, racer.parts]));
    const [exact, frames] = (['precise', 'arcade'] as const).map((name) =>
      pathOf(createSimulation(compile(resolveLevel(file), name)), [[0, 600]], 3600),
    );
    const at = parts.get('arcade') ?? -1;
    const apart = (tick: number) => Math.hypot(exact.x[tick] - frames.x[tick], exact.y[tick] - frames.y[tick]);
    expect(apart(at)).toBeGreaterThan(1 - 1e-3);
    expect(apart(at - 1)).toBeLessThan(1 + 1e-3);
    expect([parts.get('fast'), parts.get('standard'), parts.get('short')]).toEqual([null, null, null]);
  });
});

describe('racers', () => {
  it('are where the engine says at every tick, and between two ticks on the line between them', () => {
    const level = resolveLevel(FILE);
    const holds = [[30, 600]] as const;
    const { points, turns, end } = played({ level, terms: DEFAULT_TERMS, holds });
    const racer = { slot: 0, name: 'late', points, turns, end: 60 * end.time, completes: true, isStale: false, parts: null };
    const simulation = createSimulation(compile(level, 'precise'));
    const state = new Float64Array(STATE_SIZE);
    for (let tick = 0; tick < Math.floor(racer.end); tick++) {
      simulation.readState(state);
      const at = poseOf(racer, tick);
      expect(at.x).toBeCloseTo(state[0], 3);
      expect(at.y).toBeCloseTo(state[1], 3);
      playScript(simulation, holds, tick + 1);
    }
    const last = { x: points[points.length - 2], y: points[points.length - 1] };
    fc.assert(
      fc.property(fc.double({ min: -50, max: racer.end + 500, noNaN: true }), (tick) => {
        const at = poseOf(racer, tick);
        const [before, behind] = [poseOf(racer, Math.floor(tick)), poseOf(racer, Math.min(racer.end, Math.floor(tick) + 1))];
        for (const axis of ['x', 'y'] as const) {
          expect(at[axis]).toBeGreaterThanOrEqual(Math.min(before[axis], behind[axis]) - 1e-3);
          expect(at[axis]).toBeLessThanOrEqual(Math.max(before[axis], behind[axis]) + 1e-3);
        }
        if (tick >= racer.end) expect(at).toMatchObject(last);
      }),
    );
  });

  it('are the same list until something changes, and in a playtest only what gives nothing away', async () => {
    const all = stage();
    const session = createSession(CANVAS_LAYERS);
    const settings = { runInPlay: false };
    const level = {
      ...all.level,
      playtest: { getState: () => ({ pose: () => ({}), moment: () => 42.5 }) },
    } as unknown as OpenLevel;
    const race = raceOf({ session, settings: { getState: () => settings } as never }, level);
    expect(race().racers).toBe(race().racers);
    toggleCompared(all.store, run('late'));
    const attempt = { holds: [[5, 9]], end: null, tick: 50, minerals: 0, accuracy: 'precise', points: new Float32Array(2) };
    all.attempts.add({ ...attempt, played: {} } as never);
    toggleCompared(all.store, { kind: 'attempt', number: 1 });
    await answerAll(all);
    session.setState({ tick: 7 });
    const { racers, tick } = race();
    expect([racers.map(({ name }) => name), tick]).toEqual([['late', 'attempt 1'], 7]);
    session.setState({ hoverTick: 9 });
    expect(race()).toEqual({ racers, tick: 9 });
    expect(race().racers).toBe(racers);

    session.setState({ mode: 'play' });
    expect(race().tick).toBe(42.5);
    expect(race().racers.map(({ name }) => name)).toEqual(['attempt 1']);
    expect(race().racers).toBe(race().racers);
    settings.runInPlay = true;
    expect(race().racers).toBe(racers);
    session.setState(({ layers }) => ({ layers: { ...layers, ghosts: false } }));
    expect(race().racers).toEqual([]);
    session.setState({ mode: 'edit' });
    expect(race().racers).toBe(racers);
    all.document.change('range', setLevelProperty('range', 300));
    expect(race().racers.map(({ isStale }) => isStale)).toEqual([true, true]);
  });
});
