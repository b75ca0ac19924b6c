import { describe, expect, it } from 'vitest';
import { createEditedLevel, setLevelProperty } from '../../editor/core/document/index.ts';
import { createProofStore } from '../../editor/core/proof/index.ts';
import { createSession } from '../../editor/core/session/index.ts';
import { createFixSession } from '../../editor/features/solver/fix-session.ts';
import { createSearchSettings } from '../../editor/features/solver/search-task.ts';
import type { Fixing, JobEnd, Requests, Results, Workers } from '../../editor/workers/index.ts';
import { JOBS } from '../../editor/workers/runner.ts';
import { ACCURACIES, compile, DEFAULT_TERMS, simulate } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { createRepair, proveImpossible } from '../../solver/index.ts';
import { fakeDesk } from './fake-desk.ts';

const TIME_ENOUGH = 1e9;

/** She falls along the x axis, 26 px beside the black hole. */
const ASIDE: LevelFile = {
  version: 1,
  name: 'Aside',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 170, y: 60 },
  asteroids: [{ id: 'rock', x: 100, y: 0, radius: 16 }],
  runs: [{ name: 'hold', holds: [[0, 600]] }],
};

function stage(file: LevelFile = ASIDE) {
  const document = createEditedLevel(file);
  const proof = createProofStore(document, DEFAULT_TERMS);
  const session = createSession([]);
  session.subscribe(({ run }) => proof.showRun(run));
  let asked: Requests['fix'] | null = null;
  let tell: (progress: Fixing) => void = () => {};
  let end: (end: JobEnd<Results['fix']>) => void = () => {};
  const cancelled: boolean[] = [];
  const start = (_: 'fix', request: Requests['fix'], onProgress: (progress: Fixing) => void) => {
    asked = request;
    tell = onProgress;
    const ended = new Promise<JobEnd<Results['fix']>>((resolve) => {
      end = resolve;
    });
    return { end: ended, cancel: () => void cancelled.push(true) };
  };
  const desk = { ...fakeDesk().desk, workers: { start: start as never as Workers['start'] } };
  const fixes = createFixSession({ level: { document, proof }, session, desk, settings: createSearchSettings() });
  /** Does the job as a worker does. */
  const work = (): Fixing => {
    if (asked === null) throw new Error('no job was started');
    const steps = JOBS.fix({ ...asked, budget: TIME_ENOUGH }, () => 0);
    for (;;) {
      const step = steps.next();
      if (step.done === true) return step.value;
    }
  };
  const found = async () => {
    fixes.start();
    end({ kind: 'done', result: work() });
    await Promise.resolve();
    await Promise.resolve();
    const { fixing } = fixes.store.getState();
    if (fixing === null) throw new Error('nothing was found');
    return fixing.proposals;
  };
  return { document, proof, session, fixes, found, cancelled, tell: (fixing: Fixing) => tell(fixing) };
}

describe('proposals in the editor', () => {
  it('are those of gq fix', async () => {
    const { found, proof, fixes } = stage();
    const proposals = await found();
    const { level } = proof.proof();
    const repair = createRepair(level, ACCURACIES.precise, { proof: proveImpossible(level, { accuracy: 'precise' }) });
    while (!repair.finished) repair.advance(1_000_000);
    expect(proposals).toEqual(repair.proposals);
    expect(proposals).toHaveLength(3);
    expect(fixes.store.getState()).toMatchObject({
      phase: 'done',
      isOld: false,
      fixing: { isImpossible: true, completing: null },
    });
  });

  it('are previewed without a step, and the page shows that the level is completed', async () => {
    const { found, fixes, document, proof } = stage();
    const before = document.file();
    for (const proposal of await found()) {
      fixes.preview(proposal);
      expect(proof.proof()).toMatchObject({ verdict: 'completable', run: { outcome: 'completed', time: proposal.run.time } });
      expect(document.committedFile()).toBe(before);
      expect(document.store.getState().steps).toBe(0);
      expect(fixes.store.getState()).toMatchObject({ previewed: proposal, isOld: false });
    }
    fixes.back();
    expect(document.file()).toEqual(before);
    expect(fixes.store.getState().previewed).toBeNull();
  });

  it('are taken in one step, which undo takes back', async () => {
    const { found, fixes, document, proof } = stage();
    const before = document.file();
    const [first] = await found();
    fixes.preview(first);
    fixes.take();
    expect(document.store.getState()).toMatchObject({ steps: 1, done: 1 });
    expect(proof.proof().verdict).toBe('completable');
    expect(fixes.store.getState()).toMatchObject({ previewed: null, isOld: true });
    document.undo();
    expect(document.file()).toEqual(before);
  });

  it('add the run that a search found, and it completes the level', async () => {
    const { found, fixes, document, session } = stage({ ...ASIDE, runs: [] });
    const proposals = await found();
    fixes.preview(proposals[0]);
    fixes.take();
    const runs = document.file().runs ?? [];
    expect(runs.map(({ name }) => name)).toEqual(['solution']);
    expect(session.getState().run).toBe('solution');
  });

  it('are not for a level that has changed since', async () => {
    const { found, fixes, document } = stage();
    const [first] = await found();
    document.change('Wider', setLevelProperty('range', 300));
    expect(fixes.store.getState().isOld).toBe(true);
    fixes.preview(first);
    expect(document.store.getState().steps).toBe(1);
    expect(document.file().range).toBe(300);
  });

  it('a change ends the search for them, and what it tells afterwards is not heard', () => {
    const { fixes, document, cancelled, tell } = stage();
    fixes.start();
    document.change('Wider', setLevelProperty('range', 300));
    expect(cancelled).toEqual([true]);
    const late: Fixing = { proposals: [], effort: { runs: 1, ticks: 1 }, isImpossible: false, completing: null, finished: true };
    tell(late);
    expect(fixes.store.getState()).toMatchObject({ phase: 'done', fixing: null });
  });

  it('say that there is nothing to fix where a run completes the level', async () => {
    const { found, fixes, proof } = stage({ ...ASIDE, blackHole: { x: 170, y: 0 } });
    expect(await found()).toEqual([]);
    expect(fixes.store.getState().fixing?.completing).toBe(0);
    expect(simulate(compile(proof.proof().level), [[0, 600]]).outcome).toBe('completed');
  });
});
