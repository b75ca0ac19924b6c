import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { createStore } from 'zustand/vanilla';
import type { Ghost } from '../../editor/core/context/index.ts';
import { addRun, createEditedLevel, setLevelProperty } from '../../editor/core/document/index.ts';
import { extraInWords } from '../../editor/core/figures/index.ts';
import { createProofStore } from '../../editor/core/proof/index.ts';
import { createSession } from '../../editor/core/session/index.ts';
import { watchProofs } from '../../editor/core/verdict/evidence.ts';
import { createDifficultySession } from '../../editor/features/solver/difficulty-session.ts';
import { pathOfHolds } from '../../editor/features/solver/ghosts.ts';
import { everyTick, watchRobustness } from '../../editor/features/solver/robustness-watch.ts';
import { createOverlay, createSearchSession } from '../../editor/features/solver/search-session.ts';
import { aimOf, createSearchSettings, goalOf } from '../../editor/features/solver/search-task.ts';
import type { JobEnd, Solving } from '../../editor/workers/index.ts';
import { proofsWork } from '../../editor/workers/jobs/check.ts';
import { compile, DEFAULT_TERMS, STATE_SIZE, simulate, TICK } from '../../engine/index.ts';
import { type Hold, readLevel, resolveLevel } from '../../schema/index.ts';
import {
  measureRobustness,
  type Proof,
  proofPicture,
  proveImpossible,
  proveMineralsUnreachable,
  type Solution,
  verifyRun,
} from '../../solver/index.ts';
import { fakeDesk } from './fake-desk.ts';
import { breathe } from './stage.ts';

const levels = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'levels');
const ANY = { minerals: 'any' } as const;

function readShipped(name: string) {
  const reading = readLevel(readFileSync(join(levels, `${name}.level.json`), 'utf8'));
  if (!reading.ok) throw new Error(`${name} can not be read`);
  return reading.document.file;
}

const OTHER: Ghost = { id: 'attempt-1', label: 'attempt 1', points: new Float32Array(4), look: 'attempt' };

function stage(name = '04-slingshot', withRuns = true) {
  const { runs, ...file } = readShipped(name);
  const document = createEditedLevel(withRuns ? { ...file, runs } : file);
  const proof = createProofStore(document, DEFAULT_TERMS);
  const session = createSession([]);
  session.subscribe(({ run }) => proof.showRun(run));
  const level = {
    document,
    proof,
    ghosts: createStore<readonly Ghost[]>(() => [OTHER]),
    analysis: createStore<Parameters<typeof watchRobustness>[0]['level']['analysis'] extends { getState(): infer T } ? T : never>(
      () => null,
    ),
  };
  const { desk, workers, clock } = fakeDesk();
  const settings = createSearchSettings();
  const overlay = createOverlay();
  const search = createSearchSession({ level, session, desk, settings, overlay, now: clock.now });
  const holds = (runs ?? [])[0].holds;
  const scene = compile(proof.proof().level);
  const solutionOf = (held: readonly Hold[]): Solution => {
    const candidate = verifyRun(scene, held, ANY);
    if (candidate === null) throw new Error('expected a run that completes the level');
    return { ...candidate, score: 1, p40: null, certified: false };
  };
  const solving = (...found: readonly (readonly Hold[])[]): Solving => ({
    effort: { runs: 10, ticks: 1000 },
    closest: { distance: 12, tick: 100, holds: [[5, 50]] },
    solutions: found.map(solutionOf),
    explored: { cellSize: 32, cells: [{ x: 0, y: 0, visits: 3 }] },
    finished: false,
  });
  const looks = () => level.ghosts.getState().map(({ id }) => id);
  return { level, document, proof, session, desk, workers, settings, overlay, clock, search, holds, scene, solving, looks };
}

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
});
afterEach(() => {
  vi.useRealTimers();
});

const NOTHING_PROVED = { impossible: null, minerals: [] };

describe('a search', () => {
  it('requests what was set', () => {
    const { search, workers, settings, document } = stage();
    const known = (document.file().runs ?? []).map(({ holds }) => holds);
    expect(known.length).toBeGreaterThan(0);
    settings.setState({ minerals: 'some', some: 2, objective: 'time', budget: 3, seed: 7 });
    search.start();
    expect(workers.last('solve').request).toMatchObject({
      goal: { minerals: 2 },
      objective: 'time',
      budget: 3000,
      seed: 7,
      known,
    });
    settings.setState({ objective: 'first' });
    search.start();
    expect(workers.last('solve').request).toMatchObject({ objective: 'first', known: [] });
    expect(goalOf({ ...settings.getState(), minerals: 'all' }, 0)).toEqual(ANY);
    expect(goalOf({ ...settings.getState(), minerals: 'all' }, 2)).toEqual({ minerals: 'all' });
    expect(goalOf({ ...settings.getState(), some: 9 }, 2)).toEqual({ minerals: 2 });
  });

  it('shows the closest approach until it finds runs, then those; other ghosts stay', () => {
    const { search, workers, holds, solving, looks, overlay } = stage();
    search.start();
    workers.last('solve').tell(solving());
    expect(looks()).toEqual(['attempt-1', 'closest']);
    expect(overlay.getState().heat?.cells).toHaveLength(1);
    workers.last('solve').tell(solving(holds));
    expect(looks()).toEqual(['attempt-1', `found-${holds.join()}`]);
    search.clear();
    expect(looks()).toEqual(['attempt-1']);
    expect(overlay.getState()).toEqual({ heat: null, proof: null });
    expect(search.store.getState().phase).toBe('idle');
  });

  it('shows only one run while the pointer is on it', () => {
    const { search, workers, holds, solving, looks, scene } = stage();
    const [[press, release], ...rest] = holds;
    const other: Hold[] = [[press, release - 1], ...rest];
    expect(verifyRun(scene, other, ANY)).not.toBeNull();
    search.start();
    workers.last('solve').tell(solving(holds, other));
    expect(looks()).toHaveLength(3);
    search.hover(other.join());
    expect(looks()).toEqual(['attempt-1', `found-${other.join()}`]);
    search.hover(null);
    expect(looks()).toHaveLength(3);
  });

  it('does not change the list while the pointer is on it, and shows new runs afterwards', () => {
    const { search, workers, holds, solving } = stage();
    const [[press, release], ...rest] = holds;
    const other: Hold[] = [[press, release - 1], ...rest];
    const listed = () => search.store.getState().found.map(({ id }) => id);
    search.start();
    workers.last('solve').tell(solving(holds));
    search.hover(holds.join());
    workers.last('solve').tell(solving(other, holds));
    expect(listed()).toEqual([holds.join()]);
    search.hover(null);
    expect(listed()).toEqual([other.join(), holds.join()]);
    search.hover(other.join());
    workers.last('solve').tell(solving(holds));
    search.start();
    search.hover(null);
    expect(listed()).toEqual([]);
  });

  it('keeps its results when it is cancelled, and ignores later messages', () => {
    const { search, workers, holds, solving, looks } = stage();
    search.start();
    workers.last('solve').tell(solving(holds));
    search.cancel();
    expect(workers.jobs.every(({ isCancelled }) => isCancelled)).toBe(true);
    workers.last('solve').tell(solving());
    expect(search.store.getState()).toMatchObject({ phase: 'cancelled', found: [{ works: true }] });
    expect(looks()).toHaveLength(2);
  });

  it('forgets the last search when it is restarted, and ignores its messages', async () => {
    const { search, workers, holds, solving } = stage();
    search.start();
    const first = workers.last('solve');
    search.start();
    expect(first.isCancelled()).toBe(true);
    first.tell(solving(holds));
    first.end({ kind: 'done', result: solving(holds) });
    await breathe();
    expect(search.store.getState()).toMatchObject({ phase: 'running', found: [] });
  });

  it('reports that it has failed', async () => {
    const { search, workers } = stage();
    search.start();
    workers.last('solve').end({ kind: 'failed', message: 'out of memory' });
    await breathe();
    expect(search.store.getState()).toMatchObject({ phase: 'failed', message: 'out of memory' });
  });

  it('ends when a proof shows that there is nothing to find', async () => {
    const { search, workers, document, overlay, proof } = stage();
    document.change('far away', (draft) => {
      draft.blackHole.x = 90_000;
    });
    search.start();
    const impossible = proveImpossible(proof.proof().level);
    expect(impossible).not.toBeNull();
    expect(workers.last('proofs').request).toMatchObject({ isDrawn: true });
    const picture = proofPicture(proof.proof().level, impossible as Proof);
    workers.last('proofs').tell({ impossible, minerals: [], picture });
    await breathe();
    expect(workers.last('solve').isCancelled()).toBe(true);
    expect(search.store.getState()).toMatchObject({ phase: 'done', impossible });
    expect(overlay.getState().proof).toBe(picture);
  });

  it('gets the picture of the first proof from the worker, drawn once, and only if it asks', () => {
    const file = { ...readShipped('04-slingshot'), runs: [] };
    const level = resolveLevel({ ...file, blackHole: { ...file.blackHole, x: 90_000 } });
    const answers = (isDrawn: boolean) => [...proofsWork.steps({ level, terms: DEFAULT_TERMS, collected: [], isDrawn }, () => 0)];
    const drawn = answers(true).map((one) => one?.picture);
    expect(drawn[0]).toEqual(proofPicture(level, proveImpossible(level) as Proof));
    expect(drawn.every((picture) => picture === drawn[0])).toBe(true);
    expect(answers(false).map((one) => one?.picture)).toEqual(drawn.map(() => undefined));
  });

  it('ends when a mineral is proved to be out of reach, but only if it is required', async () => {
    for (const minerals of ['any', 'all'] as const) {
      const { search, workers, settings, document, proof } = stage();
      settings.setState({ minerals });
      document.change('far away', (draft) => {
        if (draft.minerals !== undefined) draft.minerals[0].x = 90_000;
      });
      search.start();
      const [unreachable] = proveMineralsUnreachable(proof.proof().level);
      workers.last('proofs').tell({ impossible: null, minerals: [{ index: 0, proof: unreachable }] });
      await breathe();
      expect(search.store.getState()).toMatchObject({
        phase: minerals === 'all' ? 'done' : 'running',
        isHopeless: minerals === 'all',
      });
    }
  });

  it('stops when the level changes, and tries its runs in the changed level', async () => {
    const { search, workers, clock, document, holds, solving, overlay } = stage();
    search.start();
    workers.last('proofs').tell(NOTHING_PROVED);
    workers.last('solve').tell(solving(holds));
    // a new name does not affect the motion
    document.change('rename', setLevelProperty('name', 'Another'));
    await clock.pass(1000);
    expect(search.store.getState()).toMatchObject({ phase: 'running', found: [{ works: true }] });
    document.change('away', (draft) => {
      draft.blackHole.x += 400;
    });
    await clock.pass(1000);
    expect(workers.last('solve').isCancelled()).toBe(true);
    expect(search.store.getState()).toMatchObject({ phase: 'stale', found: [{ works: false }] });
    expect(overlay.getState().heat).toBeNull();
    document.undo();
    await clock.pass(1000);
    expect(search.store.getState().found).toMatchObject([{ works: true }]);
  });

  it('adds a run to the level, as the main run if none completes it, in one step that can be undone', () => {
    const { search, document, session, proof, holds } = stage('04-slingshot', false);
    search.use(holds);
    expect(document.file().runs).toEqual([{ name: 'solution', holds }]);
    expect(session.getState().run).toBe('solution');
    expect(proof.proof().verdict).toBe('completable');
    search.use([[1, 2]]);
    expect(document.file().runs?.map(({ name }) => name)).toEqual(['solution', 'solution 2']);
    search.use([[3, 4]], 'solution 2');
    expect(document.file().runs?.[1].holds).toEqual([[3, 4]]);
    expect(document.undo() && document.undo() && document.undo()).toBe(true);
    expect(document.file().runs).toBeUndefined();
  });
});

describe('the name and place of an added run', () => {
  it('contains the goal of the search, if the level is already completable', () => {
    const { search, document, workers, settings, holds, solving } = stage();
    const [, other] = document.file().runs ?? [];
    settings.setState({ objective: 'time' });
    search.start();
    workers.last('solve').tell(solving(holds, other.holds));
    search.use(holds);
    search.use(other.holds);
    search.use(holds);
    const names = () => document.file().runs?.map(({ name }) => name);
    expect(names()).toEqual(['solution', 'all-minerals', 'quickest', 'quickest 2', 'quickest 3']);
    search.use(other.holds, undefined, 'one press');
    expect(names()?.at(-1)).toBe('one press');
  });

  it('is the first if no other run completes the level, but not if it does not either', () => {
    const { search, document, workers, proof, holds, solving } = stage('04-slingshot', false);
    document.change('try', addRun('solution', [[1, 2]]));
    search.start();
    workers.last('solve').tell(solving(holds));
    search.use([[3, 4]]);
    expect(document.file().runs?.map(({ name }) => name)).toEqual(['solution', 'solution 2']);
    search.use(holds);
    expect(document.file().runs?.map(({ name }) => name)).toEqual(['safest', 'solution', 'solution 2']);
    expect(proof.proof().verdict).toBe('completable');
  });

  it.each([
    [{ minerals: 'all', objective: 'robust' }, 1, 'all minerals'],
    [{ minerals: 'all', objective: 'presses' }, 2, 'all minerals, simplest 2'],
    [{ minerals: 'some', some: 1, objective: 'first' }, 1, '1 mineral'],
    [{ minerals: 'any', objective: 'first' }, 3, 'found 3'],
  ] as const)('%j, place %i: %s', (asked, place, name) => {
    expect(aimOf({ ...createSearchSettings().getState(), ...asked }, place)).toBe(name);
  });
});

it.each([
  [-1.75, 0, '1.75 s quicker, as many presses'],
  [3.1, 1, '3.10 s slower, 1 press more'],
  [0.001, -2, 'as quick, 2 presses fewer'],
])('all minerals take %d s and %i presses: %s', (time, presses, words) => {
  expect(extraInWords(time, presses)).toBe(words);
});

describe('paths of ghosts', () => {
  it('are her positions at every tick', () => {
    const { scene, holds } = stage();
    const run = simulate(scene, holds);
    const points = pathOfHolds(scene, holds);
    const state = new Float64Array(STATE_SIZE);
    for (let tick = 0; tick <= run.tick; tick += 7) {
      run.trajectory.at(tick * TICK, state);
      expect(Math.hypot(points[2 * tick] - state[0], points[2 * tick + 1] - state[1])).toBeLessThan(1e-3);
    }
    expect(points.at(-2)).toBeCloseTo(run.final.x, 2);
    expect(pathOfHolds(scene, holds, 10)).toEqual(points.slice(0, 22));
  });

  it('are interpolated along straight lines between sparse points', () => {
    expect([...everyTick(Float32Array.of(0, 0, 3, 6, 3, 0), 3)]).toEqual([0, 0, 1, 2, 2, 4, 3, 6, 3, 4, 3, 2, 3, 0]);
    expect([...everyTick(Float32Array.of(5, 6), 3)]).toEqual([5, 6]);
  });
});

describe('the watch over the robustness of the shown run', () => {
  const watched = () => {
    const on = stage();
    const watch = watchRobustness({ level: on.level, desk: on.desk });
    return { ...on, watch };
  };
  const NO_FAN = { kind: 'done', result: { slack: [], ways: [] } } as const;
  /** Waits until the level rests, and answers with the fan. */
  const settle = async (
    { clock, workers }: Pick<ReturnType<typeof stage>, 'clock' | 'workers'>,
    fan: JobEnd<unknown> = NO_FAN,
  ) => {
    await clock.pass(1000);
    for (const job of workers.jobs) if (job.kind === 'fan' && !job.isCancelled) job.end(fan);
    await clock.pass(0);
  };

  it('measures after a pause in the changes, and informs timeline and canvas', async () => {
    const { workers, clock, watch, level, holds, scene, looks } = watched();
    expect(workers.jobs).toHaveLength(0);
    const result = measureRobustness(scene, holds, ANY, { samples: 50 });
    await settle(
      { clock, workers },
      { kind: 'done', result: { slack: result.slack, ways: [{ edge: 1, shift: -2, points: Float32Array.of(0, 0, 3, 3) }] } },
    );
    workers.last('robustness').tell({ slack: result.slack, p40: result.p40 });
    expect(level.analysis.getState()).toMatchObject({ holds: holds.join(), slack: result.slack, certifiedTicks: null });
    workers.last('robustness').end({ kind: 'done', result });
    await breathe();
    expect(watch.store.getState()).toMatchObject({ phase: 'measured', full: result });
    expect(level.analysis.getState()).toMatchObject({ certifiedTicks: result.certifiedTicks, decided: true, p40: result.p40.p });
    expect(looks()).toEqual(['attempt-1', 'slack-1--2']);
  });

  it('measures a run that was cut off at first, as soon as all of it is simulated', async () => {
    const { desk, workers, clock, level } = stage();
    const whole = level.proof.proof();
    const store = createStore<typeof whole>(() => ({ ...whole, limit: 'run', run: { ...whole.run, outcome: 'timeout' } }));
    const proof = { ...level.proof, store, proof: () => store.getState() };
    const watch = watchRobustness({ level: { ...level, proof }, desk });
    await settle({ clock, workers });
    expect(watch.store.getState().phase).toBe('failed');
    expect(workers.jobs).toHaveLength(0);
    store.setState(whole, true);
    await settle({ clock, workers });
    expect(watch.store.getState().phase).toBe('measuring');
    expect(workers.last('robustness').isCancelled()).toBe(false);
  });

  it('forgets its results when the run or the level changes, and ignores old answers', async () => {
    for (const isRun of [true, false]) {
      const { workers, clock, watch, level, holds, scene, document, looks } = watched();
      await settle({ clock, workers });
      const result = measureRobustness(scene, holds, ANY, { samples: 50 });
      const old = workers.last('robustness');
      old.tell({ slack: result.slack, p40: result.p40 });
      document.change('edit', (draft) => {
        if (isRun) draft.runs?.[0].holds.push([3000, 3001]);
        else draft.blackHole.x += 1;
      });
      expect(level.analysis.getState()).toBeNull();
      expect(old.isCancelled()).toBe(true);
      old.tell({ slack: result.slack, p40: result.p40 });
      old.end({ kind: 'done', result });
      await breathe();
      expect(level.analysis.getState()).toBeNull();
      expect(watch.store.getState()).toMatchObject({ phase: 'waiting', full: null });
      expect(looks()).toEqual(['attempt-1']);
      await settle({ clock, workers });
      expect(workers.jobs).toHaveLength(4);
      watch.close();
      expect(workers.last('robustness').isCancelled()).toBe(true);
    }
  });

  it('requests the fan at the end of a gesture, the rest after a pause, and nothing during a drag', async () => {
    const { workers, clock, document } = watched();
    await settle({ clock, workers });
    const asked = () => workers.jobs.slice(2).map(({ kind, isCancelled }) => `${kind}${isCancelled ? ', cancelled' : ''}`);
    const drag = document.begin('drag');
    for (let i = 1; i <= 5; i++) {
      drag.set((draft) => {
        draft.blackHole.x += i;
      });
      await clock.pass(16);
    }
    expect(workers.jobs[1]).toMatchObject({ kind: 'robustness', isCancelled: true });
    expect(asked()).toEqual([]);
    drag.commit();
    await clock.pass(0);
    expect(asked()).toEqual(['fan']);
    await settle({ clock, workers });
    expect(asked()).toEqual(['fan', 'robustness']);
  });

  it('requests nothing for a run that fails', async () => {
    const { workers, clock, watch, document } = watched();
    document.change('fails', (draft) => {
      draft.runs = [{ name: 'solution', holds: [] }];
    });
    await settle({ clock, workers });
    expect(workers.jobs).toHaveLength(0);
    expect(watch.store.getState().phase).toBe('fails');
  });

  it('requires the minerals of the run on request', async () => {
    const { workers, clock, watch, proof } = watched();
    await settle({ clock, workers });
    expect(workers.last('robustness').request.goal).toEqual(ANY);
    watch.setWithMinerals(true);
    await settle({ clock, workers });
    const taken = proof.proof().run.minerals.length;
    expect(taken).toBeGreaterThan(0);
    expect(workers.last('robustness').request.goal).toEqual({ minerals: taken });
  });
});

describe('the watch over proofs', () => {
  it('requests proofs for a level that no run completes, and forgets the answer when the level changes', async () => {
    const { desk, workers, clock, document, proof } = stage();
    const watch = watchProofs({ proof, desk });
    await clock.pass(2000);
    // a run collects all minerals: nothing is left to prove
    expect(proof.proof().run.minerals).toHaveLength(proof.proof().level.minerals.length);
    expect(workers.jobs).toHaveLength(0);
    document.change('far away', (draft) => {
      draft.blackHole.x = 90_000;
    });
    await clock.pass(2000);
    const impossible = proveImpossible(proof.proof().level);
    workers.last('proofs').end({ kind: 'done', result: { impossible, minerals: [] } });
    await breathe();
    expect(watch.store.getState().impossible).toBe(impossible);
    document.change('other run', (draft) => {
      draft.runs = [];
    });
    expect(watch.store.getState().impossible).toBe(impossible);
    document.undo();
    document.undo();
    expect(watch.store.getState().impossible).toBeNull();
    await clock.pass(2000);
    expect(workers.jobs).toHaveLength(1);
    watch.close();
  });
});

describe('difficulty', () => {
  it('is measured with the shown run if it completes the level, else with one from a search, and becomes outdated with changes', async () => {
    const { level, desk, workers, settings, holds, document } = stage();
    const difficulty = createDifficultySession({ level, desk, settings });
    difficulty.start();
    expect(workers.last('difficulty').request.holds).toEqual(holds);
    workers.last('difficulty').end({ kind: 'done', result: null });
    await breathe();
    expect(difficulty.store.getState()).toMatchObject({ phase: 'none', isOld: false });
    document.change('fails', (draft) => {
      draft.runs = [{ name: 'solution', holds: [] }];
    });
    expect(difficulty.store.getState().isOld).toBe(true);
    difficulty.start();
    expect(workers.last('difficulty').request.holds).toBeNull();
    difficulty.cancel();
    expect(workers.last('difficulty').isCancelled()).toBe(true);
    expect(difficulty.store.getState().phase).toBe('idle');
  });
});
