import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createAttempts } from '../../editor/core/attempts/attempts.ts';
import { createEditedLevel, setLevelProperty } from '../../editor/core/document/index.ts';
import { createProofStore } from '../../editor/core/proof/index.ts';
import { createSession } from '../../editor/core/session/index.ts';
import {
  briefLossInWords,
  lossInWords,
  lossKey,
  lostFromInWords,
  lostInWords,
  lostOf,
  sinceInWords,
} from '../../editor/features/lost/index.ts';
import { LOST_SQUARE, lostPictureOf, squaresOf } from '../../editor/features/lost/lost-picture.ts';
import { watchLost } from '../../editor/features/lost/watch-lost.ts';
import type { JobKind, Losing, Loss, Losses, LostMoment, Requests } from '../../editor/workers/index.ts';
import { JOBS } from '../../editor/workers/runner.ts';
import { compile, DEFAULT_TERMS, simulate, TICK } from '../../engine/index.ts';
import { levelHash } from '../../game/index.ts';
import { type Hold, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { describeQuick } from '../depth.ts';
import { type FakeJob, FakeWorkers } from './fake-desk.ts';

/** She drifts into the black hole unless the weak gun bends her way; past it she is too fast to come back. */
const PAST: LevelFile = {
  version: 1,
  name: 'Past it',
  astronaut: { x: 0, y: 0, vx: 60 },
  blackHole: { x: 150, y: 30 },
  range: 450,
  rules: { pull: 10 },
  asteroids: [{ id: 'rock', x: 60, y: -100, radius: 16 }],
  runs: [
    { name: 'hold', holds: [[0, 600]] },
    { name: 'drift', holds: [] },
  ],
};

const moment = (tick: number, known: LostMoment['known']): LostMoment => ({
  x: tick,
  y: 0,
  tick,
  known,
  reason: known === 'proved' ? 'every run ends soon' : null,
  searched: known === 'proved' ? null : 10_000,
});
const loss = (changes: Partial<Loss>): Loss => ({ last: 240, completes: false, open: 100, lost: null, proved: null, ...changes });

describe('squares of the shade', () => {
  it('each lost state lies in one square, which is proved exactly if one of its states is', () => {
    const state = fc.record({
      x: fc.integer({ min: -40_000, max: 40_000 }).map((n) => n / 8),
      y: fc.integer({ min: -40_000, max: 40_000 }).map((n) => n / 8),
      known: fc.constantFrom('proved' as const, 'not found' as const),
    });
    fc.assert(
      fc.property(fc.array(state, { maxLength: 60 }), (states) => {
        const squares = squaresOf(states);
        const inside = ({ x, y }: { x: number; y: number }) =>
          states.filter((one) => one.x >= x && one.x < x + LOST_SQUARE && one.y >= y && one.y < y + LOST_SQUARE);
        for (const square of squares) {
          const own = inside(square);
          expect(own.length).toBe(square.states);
          expect(own.some(({ known }) => known === 'proved')).toBe(square.known === 'proved');
        }
        expect(squares.reduce((sum, square) => sum + square.states, 0)).toBe(states.length);
        expect(squaresOf([...states].reverse())).toEqual(squares);
      }),
    );
  });
});

describe('since when a run is lost, in words', () => {
  it('tells apart what is proved and what was only not found', () => {
    const both = loss({ lost: moment(141, 'not found'), proved: moment(186, 'proved') });
    expect(sinceInWords(both)).toBe('lost from 3.10 s on (proved), no run found from 2.35 s on');
    expect(lossInWords(both, 4.1)).toBe('lost from 3.10 s on (proved), no run found from 2.35 s on; ends at 4.10 s');
    expect(briefLossInWords(both, 4.1)).toBe('lost from 3.10 s, ends at 4.10 s');
    const searched = loss({ lost: moment(141, 'not found') });
    expect(sinceInWords(searched)).toBe('no run found from 2.35 s on, which proves nothing');
    expect(lostFromInWords(searched)).toBe('no run found from 2.35 s');
    const proved = loss({ lost: moment(141, 'proved'), proved: moment(141, 'proved') });
    expect(sinceInWords(proved)).toBe('lost from 2.35 s on (proved)');
  });

  it('says nothing of what is not known, and nothing of a run that completes the level', () => {
    expect(lostFromInWords(loss({}))).toBeNull();
    expect(lossInWords(loss({}), 4)).toBeNull();
    expect(sinceInWords(loss({ completes: true, open: 240 }))).toBeNull();
    expect(sinceInWords(loss({ open: 240 }))).toBe('not lost until it ends');
  });
});

describe('the picture of a loss', () => {
  const document = createEditedLevel(PAST);
  const now = createProofStore(document, DEFAULT_TERMS, { run: 'hold' }).proof();
  const key = lossKey(now.run.holds, 'precise');

  it('follows the run from where it is lost to its end, first as not found and then as proved', () => {
    const last = now.run.way.count - 1;
    const losses = new Map([[key, loss({ last, lost: moment(60, 'not found'), proved: moment(300, 'proved') })]]);
    const { stretches, squares } = lostPictureOf({ losing: null, losses }, now, []);
    expect(squares).toEqual([]);
    expect(stretches.map(({ known, isShownRun, at }) => [known, isShownRun, at.tick])).toEqual([
      ['not found', true, 60],
      ['proved', true, 300],
    ]);
    const { trajectory } = simulate(compile(resolveLevel(PAST)), [[0, 600]]);
    const state = new Float64Array(6);
    trajectory.at(300 * TICK, state);
    expect(stretches[1].points[0]).toBeCloseTo(state[0], 6);
    expect(stretches[1].points[1]).toBeCloseTo(state[1], 6);
    expect(stretches[1].points.length / 2).toBeCloseTo((last - 300) / 2, -1);
  });

  it('has nothing where the whole loss is unknown, and the ways of attempts', () => {
    const points = Float32Array.from({ length: 200 }, (_, i) => i);
    const losses = new Map([['attempt', loss({ last: 99, lost: moment(40, 'proved'), proved: moment(40, 'proved') })]]);
    const attempts = [
      { key: 'attempt', points },
      { key: 'unknown', points },
    ];
    const { stretches } = lostPictureOf({ losing: null, losses }, now, attempts);
    expect(stretches.map(({ known, isShownRun, points: [x, y] }) => [known, isShownRun, x, y])).toEqual([
      ['proved', false, 80, 81],
    ]);
  });
});

function stage(file: LevelFile = PAST) {
  const document = createEditedLevel(file);
  const proof = createProofStore(document, DEFAULT_TERMS);
  const session = createSession([{ id: 'lost', title: 'lost', isShown: false }]);
  session.subscribe(({ run }) => proof.showRun(run));
  const attempts = createAttempts();
  const workers = new FakeWorkers();
  const { jobs } = workers;
  let waiting: (() => void)[] = [];
  const afterRest = (_: number, call: () => void) => {
    waiting.push(call);
    return () => {
      waiting = waiting.filter((one) => one !== call);
    };
  };
  const level = { document, proof, attempts };
  const watch = watchLost({ level, session, desk: { workers, afterRest, after: afterRest } });
  /** Lets the page rest. */
  const rest = () => {
    const due = waiting;
    waiting = [];
    for (const call of due) call();
  };
  const show = (lost: boolean) => session.setState(({ layers }) => ({ layers: { ...layers, lost } }));
  /** What the latest job of a kind was asked for. */
  const asked = <K extends JobKind>(kind: K): Requests[K] => workers.last(kind).request;
  const running = () => jobs.filter(({ isCancelled }) => !isCancelled).map(({ kind }) => kind);
  return { document, proof, session, attempts, jobs, watch, rest, show, running, asked, found: () => lostOf(level).getState() };
}

const settle = async () => {
  await Promise.resolve();
  await Promise.resolve();
};

const LOSING: Losing = {
  counts: { examined: 10, open: 4, proved: 3, notFound: 3, unknown: 0 },
  states: [{ ...moment(200, 'proved'), alive: 90 }],
  places: [],
  ticks: 1000,
  finished: false,
};

describe('the examination of where a level is lost', () => {
  it('costs nothing while it is hidden, and begins once the page rests', () => {
    const { jobs, rest, show, running, found } = stage();
    rest();
    expect([jobs.length, found().phase]).toEqual([0, 'off']);
    show(true);
    expect([jobs.length, found().phase]).toEqual([0, 'waiting']);
    rest();
    expect([running().sort(), found().phase]).toEqual([['losses', 'lost'], 'examining']);
    show(false);
    expect([running(), found().phase]).toEqual([[], 'off']);
  });

  it('throws away what it found when the level changes, also what a worker tells too late', async () => {
    const { document, jobs, rest, show, running, asked, found } = stage();
    show(true);
    rest();
    const [losses, lost] = ['losses', 'lost'].map((kind) => jobs.find((job) => job.kind === kind) as FakeJob);
    lost.tell(LOSING);
    losses.tell({
      losses: [loss({ lost: moment(9, 'proved'), proved: moment(9, 'proved') })],
      ticks: 1,
      finished: false,
    } satisfies Losses);
    expect([found().losing, found().losses.size]).toEqual([LOSING, 1]);
    document.change('Wider', setLevelProperty('range', 460));
    expect([found().phase, found().losing, found().losses.size, running()]).toEqual(['waiting', null, 0, []]);
    lost.tell(LOSING);
    lost.end({ kind: 'done', result: LOSING });
    await settle();
    expect([found().phase, found().losing]).toEqual(['waiting', null]);
    rest();
    expect(running().sort()).toEqual(['losses', 'lost']);
    expect(asked('lost').level.range).toBe(460);
  });

  it('keeps the states when only runs change, and asks anew for the loss of the shown run', () => {
    const { session, rest, show, running, asked } = stage();
    show(true);
    rest();
    expect(asked('losses').traced).toEqual([[[0, 600]]]);
    session.setState({ run: 'drift' });
    rest();
    expect(running()).toEqual(['lost']);
    session.setState({ run: 'hold' });
    rest();
    expect(running()).toEqual(['lost', 'losses']);
    expect(asked('losses').traced).toEqual([[[0, 600]]]);
  });

  it('examines failed attempts at the level as it is; those that complete it show what is open', () => {
    const { attempts, jobs, rest, show, asked, found } = stage({ ...PAST, runs: undefined });
    show(true);
    rest();
    expect([jobs.length, found().phase]).toEqual([0, 'needs a run']);
    const level = resolveLevel({ ...PAST, runs: undefined });
    const add = (holds: readonly Hold[], hash: string) => {
      const { outcome, time } = simulate(compile(level), holds);
      const tick = Math.floor(time / TICK);
      attempts.add({
        holds,
        end: { outcome, with: null, time, tick },
        tick,
        minerals: 0,
        accuracy: 'precise',
        points: new Float32Array(0),
        played: { bytes: new Uint8Array(0), hash, file: PAST, rules: {} },
      });
    };
    add([], levelHash(level));
    add([[10, 300]], levelHash(level));
    add([[20, 300]], 'another level');
    rest();
    const losses = asked('losses');
    expect(losses.traced).toEqual([[[10, 300]]]);
    expect(losses.level.runs.map(({ holds }) => holds)).toEqual([[]]);
    expect(found().phase).toBe('examining');
  });

  it('stops and keeps what it found, and goes on with more effort', async () => {
    const { watch, jobs, rest, show, asked, found } = stage();
    show(true);
    rest();
    const lost = jobs.find(({ kind }) => kind === 'lost') as FakeJob;
    lost.tell(LOSING);
    watch.stop();
    await settle();
    expect([found().phase, found().losing, lost.isCancelled]).toEqual(['stopped', LOSING, true]);
    expect(lostInWords(found())).toBe(
      'Stopped. Of 10 states 4 can still reach the black hole, 1 are proved lost although she lives on; from 0 no run was found, which proves nothing.',
    );
    watch.goOn();
    const first = asked('lost').effort;
    expect(asked('lost').effort).toBe(first);
    jobs.at(-1)?.end({ kind: 'done', result: LOSING });
    await settle();
    expect(found().phase).toBe('done');
    watch.goOn();
    expect(asked('lost').effort).toBe(4 * first);
    jobs.at(-1)?.end({ kind: 'failed', message: 'the worker could not be loaded' });
    await settle();
    expect(lostInWords(found())).toContain('Failed: the worker could not be loaded');
  });

  it('forgets everything when the level is closed', () => {
    const { watch, rest, show, running, found } = stage();
    show(true);
    rest();
    watch.close();
    show(false);
    show(true);
    rest();
    expect([running(), found().phase]).toEqual([[], 'off']);
  });
});

describeQuick('the jobs of a worker', () => {
  const played = { level: resolveLevel(PAST), terms: DEFAULT_TERMS };
  const finish = <R>(steps: Generator<unknown, R>): { result: R; told: number } => {
    for (let told = 0; ; ) {
      const step = steps.next();
      if (step.done === true) return { result: step.value, told };
      if (step.value !== null) told++;
    }
  };

  it('find the same at any pace, tell it on the way, and keep within the effort', () => {
    const paced = (ms: number) => {
      let clock = 0;
      return finish(JOBS.lost({ ...played, effort: 400_000 }, () => (clock += ms)));
    };
    const [slow, fast] = [paced(200), paced(0.5)];
    expect(slow.result).toEqual(fast.result);
    expect(slow.told).toBeGreaterThan(fast.told);
    expect(slow.result.ticks).toBeLessThan(600_000);
    const bytes = JSON.stringify(slow.result).length;
    // proofs, which can be large, stay in the worker
    expect(bytes).toBeLessThan(100_000);
  });

  it('date the loss of a run within what is known: it is open before, and the proof holds until the end', () => {
    const traced: Hold[][] = [[[0, 600]], []];
    const { losses } = finish(JOBS.losses({ ...played, traced, effort: 3_000_000 }, () => 0)).result;
    const [held, drifted] = losses;
    expect(drifted).toMatchObject({ completes: true, lost: null, proved: null });
    expect(held.completes).toBe(false);
    expect(held.last * TICK).toBeCloseTo(simulate(compile(played.level), traced[0]).time, 1);
    expect(held.lost?.tick).toBeLessThanOrEqual(held.proved?.tick ?? -1);
    expect(held.open).toBeLessThan(held.lost?.tick ?? -1);
    expect(held.proved?.reason).toMatch(/every run/);
    expect(held.proved?.tick).toBeLessThan(held.last - 60);
  });
});
