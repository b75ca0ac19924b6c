import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import {
  createWorkers,
  type Fan,
  type JobKind,
  jobs,
  type Requests,
  type Results,
  type WorkerPort,
} from '../../editor/workers/index.ts';
import { createPacer } from '../../editor/workers/job.ts';
import { createRunner } from '../../editor/workers/runner.ts';
import type { FromWorker, ToWorker } from '../../editor/workers/workers.ts';
import { ACCURACIES, type AccuracyName, compile, DEFAULT_TERMS, joinHolds, simulate } from '../../engine/index.ts';
import { assessLevel, effectsInWords, standingInWords } from '../../review/index.ts';
import { type Level, readLevel } from '../../schema/index.ts';
import { findSlack, verifyRun } from '../../solver/index.ts';
import { breathe, TurnedClock } from './stage.ts';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const textOf = (name: string) => readFileSync(join(root, 'levels', `${name}.level.json`), 'utf8');
const levelOf = (name: string): Level => {
  const reading = readLevel(textOf(name));
  if (!reading.ok) throw new Error(name);
  return reading.level;
};
const ANY = { minerals: 'any' } as const;
const level = levelOf('02-first-swing');
const holds = level.runs[0].holds;

/** A worker in this thread, which does one slice at a time. */
function bench() {
  const heard: FromWorker[] = [];
  const due: (() => void)[] = [];
  let time = 0;
  // its own clock, which advances by a millisecond at every reading
  const hear = createRunner({
    post: (message) => heard.push(structuredClone(message)),
    later: (call) => due.push(call),
    now: () => time++,
  });
  const slice = () => due.shift()?.();
  const all = () => {
    while (due.length > 0) slice();
  };
  return { heard, hear, slice, all, isIdle: () => due.length === 0 };
}

function doJob<K extends JobKind>(kind: K, request: Requests[K]): { result: Results[K]; told: unknown[] } {
  const { heard, hear, all } = bench();
  hear({ type: 'start', job: 1, kind, request } as ToWorker);
  all();
  const last = heard[heard.length - 1];
  if (last?.type !== 'done') throw new Error(JSON.stringify(last));
  return {
    result: last.result as Results[K],
    told: heard.flatMap((message) => (message.type === 'progress' ? [message.progress] : [])),
  };
}

describe('jobs', () => {
  it('find a run, report it before the end, and it completes the level', () => {
    const { runs: _, ...bare } = level;
    const request = {
      level: { ...bare, runs: [] },
      terms: DEFAULT_TERMS,
      goal: ANY,
      objective: 'first',
      count: 1,
      known: [],
      seed: 1,
      lane: 0,
      budget: 2000,
    } as const;
    const { result, told } = doJob('solve', request);
    expect(told.length).toBeGreaterThan(0);
    expect(verifyRun(compile(level), result.solutions[0].holds, ANY)).not.toBeNull();
    expect(result.explored.cells.length).toBeGreaterThan(0);
  });

  it('report slack first, then the robustness', () => {
    const { result, told } = doJob('robustness', { level, terms: DEFAULT_TERMS, holds, goal: ANY });
    expect(told).toMatchObject([{ slack: result.slack, p40: { samples: 100 } }]);
    expect(result.slack).toEqual(findSlack(compile(level), holds, ANY));
  });

  it('measure the slack alone, as it is measured with the robustness', () => {
    const asked = { level, terms: DEFAULT_TERMS, holds, goal: ANY } as const;
    expect(doJob('slack', asked).result).toEqual(doJob('robustness', asked).result.slack);
  });

  it('return the paths of a fan, which all still reach the black hole', () => {
    const { result, told } = doJob('fan', { level, terms: DEFAULT_TERMS, holds, goal: ANY });
    expect(told).toEqual([{ slack: findSlack(compile(level), holds, ANY) }]);
    const ways = (result as Fan).ways;
    expect(ways.length).toBeGreaterThan(1);
    for (const { edge, shift, points } of ways) {
      const moved = joinHolds(
        holds.map(([a, b], i) => (i !== edge >> 1 ? [a, b] : edge % 2 === 0 ? [a + shift, b] : [a, b + shift])),
      );
      const run = simulate(compile(level), moved);
      expect(run.outcome).toBe('completed');
      expect([points[points.length - 2], points[points.length - 1]]).toEqual([
        Math.fround(run.final.x),
        Math.fround(run.final.y),
      ]);
    }
  });

  it('measure difficulty with a given run, or with one from a search', () => {
    expect(doJob('difficulty', { level, terms: DEFAULT_TERMS, holds, goal: ANY, budget: 2 }).result?.presses).toBe(holds.length);
    // starts from the level's own runs, as there is no time for a search without them
    const little = { terms: DEFAULT_TERMS, holds: null, goal: ANY, budget: 2 } as const;
    expect(doJob('difficulty', { level, ...little }).result).not.toBeNull();
    expect(doJob('difficulty', { level: { ...level, runs: [] }, ...little }).result).toBeNull();
    const impossible: Level = { ...level, asteroids: [], runs: [] };
    expect(doJob('difficulty', { level: impossible, ...little }).result).toBeNull();
  });

  it('prove which minerals are out of reach', () => {
    const { x, y } = level.asteroids[0];
    const far = { id: 'far', x: x + 5000, y, radius: 7 };
    const { result } = doJob('proofs', {
      level: { ...level, minerals: [...level.minerals.slice(0, 1), far] },
      terms: DEFAULT_TERMS,
      collected: [],
    });
    expect(result).toMatchObject({ impossible: null, minerals: [{ index: 1, proof: { about: { kind: 'mineral', index: 1 } } }] });
    const gone = doJob('proofs', {
      level: { ...level, blackHole: { x: 9999, y, radius: 18 } },
      terms: DEFAULT_TERMS,
      collected: null,
    });
    expect(gone.result.impossible).not.toBeNull();
  });

  it('draw a small picture of a level, with its verdict', () => {
    const request = { terms: DEFAULT_TERMS, width: 200, theme: 'dark' } as const;
    const good = doJob('thumbnail', { ...request, text: textOf('02-first-swing') }).result;
    expect(good).toMatchObject({ verdict: 'completable', svg: expect.stringContaining('<svg') });
    const broken = JSON.stringify({ ...JSON.parse(textOf('02-first-swing')), runs: [{ name: 'solution', holds: [[1, 2]] }] });
    expect(doJob('thumbnail', { ...request, text: broken }).result.verdict).toBe('broken');
    const far = JSON.stringify({ ...JSON.parse(broken), blackHole: { x: 99_999, y: 0 } });
    expect(doJob('thumbnail', { ...request, text: far }).result.verdict).toBe('impossible');
    expect(doJob('thumbnail', { ...request, text: '{' }).result).toEqual({
      verdict: 'invalid',
      svg: '',
      minerals: 0,
      facts: null,
    });
    const conflicts = [{ what: 'the name', key: 'name', base: 'a', ours: 'b', theirs: 'c' }];
    const undecided = JSON.stringify({ ...JSON.parse(textOf('02-first-swing')), conflicts });
    expect(doJob('thumbnail', { ...request, text: undecided }).result).toMatchObject({
      verdict: 'invalid',
      svg: expect.stringContaining('<svg'),
    });
  });

  it('compare two versions of a level: the picture, and what gq diff says of both', () => {
    const text = textOf('02-first-swing');
    const file = JSON.parse(text);
    const [{ x, y }] = file.asteroids;
    const moved = JSON.stringify({ ...file, asteroids: [{ ...file.asteroids[0], x: x + 90, y }, ...file.asteroids.slice(1)] });
    const request = { terms: DEFAULT_TERMS, width: 400, theme: 'dark' } as const;
    const standing = (of: string) => {
      const reading = readLevel(of);
      if (!reading.ok) throw new Error('a level');
      const judged = assessLevel(reading.level, { terms: DEFAULT_TERMS, slack: true });
      return { judged, words: standingInWords(judged, reading.level.range) };
    };
    const { result } = doJob('compare', { ...request, before: text, after: moved });
    const [was, is] = [standing(text), standing(moved)];
    expect(result).toMatchObject({ before: was.words, after: is.words, svg: expect.stringContaining('data-kind="arrow"') });
    expect(was.words).toContain('completable in');
    expect(result.effects).toEqual(effectsInWords(was.judged, is.judged, level.range));
    expect(result.effects).not.toEqual([]);
    // a version that only names its runs anew is judged once
    const renamed = JSON.stringify({
      ...file,
      runs: file.runs.map((run: object, i: number) => ({ ...run, name: `other ${i}` })),
    });
    expect(doJob('compare', { ...request, before: text, after: renamed }).result).toMatchObject({
      after: was.words,
      effects: ['completed by run "other 0" instead of run "solution"'],
    });
    const conflicts = [{ what: 'the name', key: 'name', base: 'a', ours: 'b', theirs: 'c' }];
    const undecided = JSON.stringify({ ...file, conflicts });
    expect(doJob('compare', { ...request, before: undecided, after: text }).result).toMatchObject({
      before: 'not judged: a merge has left conflicts in it',
      after: was.words,
      effects: [],
    });
    expect(doJob('compare', { ...request, before: '{', after: text }).result).toMatchObject({
      svg: null,
      before: 'not a valid level',
    });
  });

  it('compare the named settings with a reference, and report that before their costs', () => {
    const asked = doJob('accuracy', { level, terms: DEFAULT_TERMS, runs: [holds], methods: 'named' });
    const { told, result: results } = asked;
    const [result] = results;
    expect(result.settings.map(({ name }) => name)).toEqual(Object.keys(ACCURACIES));
    expect(result).toMatchObject({ doubt: null });
    expect(result.knownTo).toBeLessThan(1e-15);
    for (const { name, outcome, time, error } of result.settings) {
      const run = simulate(compile(level, name as AccuracyName), holds);
      expect([name, outcome, time]).toEqual([name, run.outcome, run.time]);
      expect(error).toBeGreaterThan(0);
    }
    expect(told).toEqual([[{ ...result, settings: result.settings.map(({ cost: _, ...setting }) => setting) }]]);
  });

  it('measure the cost of accuracy', () => {
    const { result: results } = doJob('accuracy', { level, terms: DEFAULT_TERMS, runs: [holds, []], methods: 'all' });
    const [result, other] = results;
    expect(other.settings.map(({ outcome }) => outcome)).not.toContain('completed');
    expect(result.settings.find(({ name }) => name === 'precise')).toMatchObject({ outcome: 'completed', sameVerdict: true });
  });
});

/** A search that goes on until it is cancelled. */
const SEARCH = {
  level: { ...level, runs: [] },
  terms: DEFAULT_TERMS,
  goal: ANY,
  objective: 'robust',
  count: 1,
  known: [],
  seed: 1,
  lane: 0,
  budget: null,
} as const;

describe('a worker', () => {
  const start = (job: number): ToWorker => ({ type: 'start', job, kind: 'solve', request: SEARCH });

  it('handles a cancel between two slices, and continues with the next job', () => {
    const { heard, hear, slice } = bench();
    for (const job of [1, 2, 3]) hear(start(job));
    for (let i = 0; i < 2; i++) slice();
    expect(heard.every(({ job }) => job === 1)).toBe(true);
    hear({ type: 'cancel', job: 2 });
    hear({ type: 'cancel', job: 1 });
    const before = heard.length;
    expect(heard.slice(-2)).toEqual([
      { type: 'cancelled', job: 2 },
      { type: 'cancelled', job: 1 },
    ]);
    for (let i = 0; i < 2; i++) slice();
    expect(heard.slice(before).every(({ job }) => job === 3)).toBe(true);
    expect(heard.length).toBeGreaterThan(before);
  });

  it('reports a failing job, and does the next one', () => {
    const { heard, hear, all } = bench();
    hear({ type: 'start', job: 1, kind: 'thumbnail', request: {} as never });
    hear({ type: 'start', job: 2, kind: 'thumbnail', request: { text: '{', terms: DEFAULT_TERMS, width: 1, theme: 'dark' } });
    all();
    expect(heard).toMatchObject([
      { type: 'failed', job: 1, message: expect.any(String) },
      { type: 'done', job: 2 },
    ]);
  });

  it('is idle when everything is done', () => {
    const { hear, all, isIdle } = bench();
    hear({ type: 'start', job: 1, kind: 'thumbnail', request: { text: '{', terms: DEFAULT_TERMS, width: 1, theme: 'dark' } });
    all();
    expect(isIdle()).toBe(true);
    hear({ type: 'cancel', job: 1 });
    expect(isIdle()).toBe(true);
  });

  it.each([1e-5, 1e-3, 0.5])('makes steps of a few milliseconds, whatever a tick costs (%s ms)', (cost) => {
    let time = 0;
    const pace = createPacer(() => time);
    const steps = Array.from({ length: 30 }, () => {
      const before = time;
      pace((ticks) => {
        time += ticks * cost;
      });
      return time - before;
    });
    // a tick that takes longer than any level needs is not divided
    const least = 500 * cost;
    for (const step of steps.slice(10)) expect(step).toBeLessThanOrEqual(Math.max(16, least));
    expect(steps[29]).toBeGreaterThan(8);
  });
});

describe('workers', () => {
  interface Fake extends WorkerPort {
    readonly sent: ToWorker[];
    answer: (message: FromWorker) => void;
    die: (reason: string) => void;
    isOver: boolean;
  }
  function crew() {
    const ports: Fake[] = [];
    const clock = new TurnedClock();
    const workers = createWorkers({
      after: (ms, call) => clock.after(ms, call),
      spawn() {
        const port: Fake = {
          sent: [],
          answer: () => {},
          die: () => {},
          isOver: false,
          postMessage: (message) => void port.sent.push(message),
          onMessage: (listener) => {
            port.answer = listener;
          },
          onDeath: (listener) => {
            port.die = listener;
          },
          terminate: () => {
            port.isOver = true;
          },
        };
        ports.push(port);
        return port;
      },
    });
    return { ports, clock, workers };
  }
  const played = { level, terms: DEFAULT_TERMS };
  const asked = { ...played, holds, goal: ANY };
  const thumb = { text: '{', terms: DEFAULT_TERMS, width: 1, theme: 'dark' } as const;

  it('report the progress of a job and how it ends', async () => {
    const { ports, workers } = crew();
    const told: unknown[] = [];
    const job = workers.start(jobs.fan, { level, terms: DEFAULT_TERMS, holds, goal: ANY }, (progress) => told.push(progress));
    ports[0].answer({ type: 'progress', job: 1, progress: 'half' });
    ports[0].answer({ type: 'done', job: 1, result: 'all' });
    expect(await job.end).toEqual({ kind: 'done', result: 'all' });
    expect(told).toEqual(['half']);
  });

  it('cancel at once; a worker that does not answer is ended, and its other jobs restart elsewhere', async () => {
    const { ports, clock, workers } = crew();
    const told: unknown[] = [];
    const [stuck, next] = [workers.start(jobs.check, played, (p) => told.push(p)), workers.start(jobs.slack, asked)];
    stuck.cancel();
    expect(await stuck.end).toEqual({ kind: 'cancelled' });
    ports[0].answer({ type: 'progress', job: 1, progress: 'late' });
    expect(told).toEqual([]);
    // it sent a message, so it was not stuck
    await clock.pass(100);
    expect(ports).toHaveLength(1);
    const again = workers.start(jobs.check, played);
    again.cancel();
    await clock.pass(49);
    expect(ports[0].isOver).toBe(true);
    expect(ports[1].sent).toMatchObject([{ type: 'start', job: 2, kind: 'slack' }]);
    ports[0].answer({ type: 'done', job: 2, result: 'from the dead' });
    ports[1].answer({ type: 'done', job: 2, result: 'new' });
    expect(await next.end).toEqual({ kind: 'done', result: 'new' });
  });

  it('stop a job at its time limit, counted from its start, and continue with the next', async () => {
    const { ports, clock, workers } = crew();
    const first = workers.start(jobs.check, played);
    const second = workers.start(jobs.check, played);
    const search = workers.start(jobs.solve, SEARCH);
    await clock.pass(19_000);
    expect(ports[0].isOver).toBe(false);
    await clock.pass(2000);
    expect(await first.end).toEqual({ kind: 'gaveUp', message: expect.stringContaining('work limit') });
    expect(ports[0].isOver).toBe(true);
    const next = ports[2];
    expect(next.sent).toMatchObject([{ type: 'start', job: 2, kind: 'check' }]);
    // its own time limit has just started
    await clock.pass(15_000);
    next.answer({ type: 'done', job: 2, result: 'checked' });
    expect(await second.end).toEqual({ kind: 'done', result: 'checked' });
    await clock.pass(600_000);
    expect([next.isOver, ports[1].isOver]).toEqual([false, false]);
    search.cancel();
  });

  it('are reported when they die, and replaced at the next job', async () => {
    const { ports, workers } = crew();
    const job = workers.start(jobs.thumbnail, thumb);
    ports[0].die('out of memory');
    expect(await job.end).toEqual({ kind: 'failed', message: 'out of memory' });
    workers.start(jobs.thumbnail, thumb);
    expect(ports).toHaveLength(2);
  });

  it('take only the job along that they die of: what has waited behind it goes on elsewhere', async () => {
    const { ports, workers } = crew();
    const [deadly, next] = [workers.start(jobs.check, played), workers.start(jobs.slack, asked)];
    ports[0].die('out of memory');
    expect(await deadly.end).toEqual({ kind: 'failed', message: 'out of memory' });
    expect(ports[1].sent).toMatchObject([{ type: 'start', job: 2, kind: 'slack' }]);
    // here it is a job that was cancelled and goes on
    const slow = workers.start(jobs.fan, asked);
    next.cancel();
    ports[1].die('out of memory');
    expect(ports[2].sent).toMatchObject([{ type: 'start', job: 3, kind: 'fan' }]);
    ports[2].answer({ type: 'done', job: 3, result: 'all' });
    expect(await slow.end).toEqual({ kind: 'done', result: 'all' });
  });

  it('share one for quick jobs; each long one has its own, which is used again; closing ends all', async () => {
    const { ports, workers } = crew();
    const job = workers.start(jobs.solve, SEARCH);
    const picture = workers.start(jobs.thumbnail, thumb);
    workers.start(jobs.fan, asked);
    workers.start(jobs.slack, asked);
    expect(ports.map(({ sent }) => sent.length)).toEqual([1, 1, 2]);
    ports[1].answer({ type: 'done', job: 2, result: 'drawn' });
    await picture.end;
    workers.start(jobs.proofs, { ...played, collected: [] });
    expect(ports.map(({ sent }) => sent.length)).toEqual([1, 2, 2]);
    workers.start(jobs.thumbnail, thumb);
    expect(ports.map(({ sent }) => sent.length)).toEqual([1, 2, 2, 1]);
    workers.close();
    expect(await job.end).toEqual({ kind: 'cancelled' });
    await breathe();
    expect(ports.every(({ isOver }) => isOver)).toBe(true);
  });
});
