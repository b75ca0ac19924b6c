import { describe, expect, it } from 'vitest';
import { createStore } from 'zustand/vanilla';
import { createEditedLevel, moveObjects, setLevelProperty } from '../../editor/core/document/index.ts';
import { createProofStore } from '../../editor/core/proof/index.ts';
import { createSession } from '../../editor/core/session/index.ts';
import { createSettings } from '../../editor/core/settings/index.ts';
import type { AliveState } from '../../editor/features/alive/index.ts';
import { type MendSession, mendSessionOf, watchMend } from '../../editor/features/mend/watch-mend.ts';
import type { JobEnd, Requests, Results, Workers } from '../../editor/workers/index.ts';
import { JOBS } from '../../editor/workers/runner.ts';
import { DEFAULT_TERMS } from '../../engine/index.ts';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { outcomeOf } from './alive-stage.ts';

/** She falls through an asteroid into the black hole behind it; beside her way is a nova. */
const FALL: LevelFile = {
  version: 1,
  name: 'Fall',
  astronaut: { x: 200, y: 304 },
  blackHole: { x: 704, y: 304 },
  asteroids: [{ id: 'rock', x: 448, y: 304, radius: 16 }],
  novae: [{ id: 'nova', x: 448, y: 420, radius: 32 }],
  runs: [{ name: 'solution', holds: [[0, 600]] }],
};

/** Finds with which work ends: more than one kind of them is among so many. */
const ENOUGH = 3;

function stage(file: LevelFile = FALL) {
  const document = createEditedLevel(file);
  const proof = createProofStore(document, DEFAULT_TERMS);
  const session = createSession([]);
  session.subscribe(({ run }) => proof.showRun(run));
  const settings = createSettings(null);
  const alive = createStore<AliveState>(() => ({ kind: 'idle' }));
  let rests: (() => void)[] = [];
  let job: { request: Requests['mend']; end: (end: JobEnd<Results['mend']>) => void } | null = null;
  const workers = {
    start: ((_: 'mend', request: Requests['mend']) => {
      let end: (end: JobEnd<Results['mend']>) => void = () => {};
      const ended = new Promise<JobEnd<Results['mend']>>((resolve) => {
        end = resolve;
      });
      job = { request, end };
      return { end: ended, cancel: () => end({ kind: 'cancelled' }) };
    }) as never as Workers['start'],
  };
  const afterRest = (_: number, call: () => void) => {
    rests.push(call);
    return () => {
      rests = rests.filter((other) => other !== call);
    };
  };
  const desk = { workers, afterRest, after: afterRest };
  const stop = watchMend({ level: { document, proof }, session, settings, desk, alive });
  const mend = mendSessionOf({ document }) as MendSession;
  return {
    document,
    proof,
    session,
    settings,
    alive,
    mend,
    stop,
    phase: () => mend.store.getState().phase,
    rest: () => {
      const due = rests;
      rests = [];
      for (const call of due) call();
    },
    work: async (): Promise<Results['mend']> => {
      if (job === null) throw new Error('nothing was asked for');
      const steps = JOBS.mend(structuredClone(job.request), () => 0);
      for (;;) {
        const { value, done } = steps.next();
        // the rest of the search would only find more
        if (value === null || (done !== true && value.found.length < ENOUGH)) continue;
        job.end({ kind: 'done', result: structuredClone(value) });
        await Promise.resolve();
        await Promise.resolve();
        return value;
      }
    },
  };
}

const intoTheWay = moveObjects(['nova'], 0, -100);

describe('the offer to mend', () => {
  it('comes when a finished change breaks the level, and says what became of the run', () => {
    const { document, mend, phase, rest } = stage();
    const drag = document.begin('Move');
    drag.set(intoTheWay);
    rest();
    expect(phase()).toBe('none');
    drag.commit();
    expect(phase()).toBe('none');
    rest();
    expect(phase()).toBe('offered');
    expect(mend.store.getState().sentence).toMatch(
      /^Run "solution" no longer completes the level: she collides with nova 1 at \d+\.\d\d s\.$/,
    );
  });

  it('does not come for an undo, a version from disk, a change that breaks nothing, or a level that was broken before', () => {
    const { document, phase, rest } = stage();
    document.change('Aside', moveObjects(['nova'], 0, 10));
    rest();
    expect(phase()).toBe('none');
    document.change('Into the way', intoTheWay);
    document.change('Aside', moveObjects(['nova'], 0, 100));
    rest();
    document.undo();
    rest();
    expect(phase()).toBe('none');
    document.change('Rename', setLevelProperty('name', 'other'));
    rest();
    expect(phase()).toBe('none');
    document.goTo(0);
    document.replace('From disk', { ...FALL, novae: [{ id: 'nova', x: 448, y: 304, radius: 32 }] });
    rest();
    expect(phase()).toBe('none');
  });

  it('is gone when the level changes, is mended, or the offer is dismissed', () => {
    const { document, mend, phase, rest } = stage();
    const breakIt = () => {
      document.goTo(0);
      document.change('Into the way', intoTheWay);
      rest();
      expect(phase()).toBe('offered');
    };
    breakIt();
    document.undo();
    expect(phase()).toBe('none');
    breakIt();
    mend.leave();
    rest();
    expect(phase()).toBe('none');
    breakIt();
    document.change('Rename', setLevelProperty('name', 'other'));
    rest();
    expect(phase()).toBe('none');
  });

  it('waits while the run is kept alive, and does not come where that works', () => {
    const { document, settings, alive, phase, rest } = stage();
    settings.setState({ keepAlive: true });
    alive.setState({ kind: 'working' }, true);
    document.change('Into the way', intoTheWay);
    rest();
    expect(phase()).toBe('none');
    alive.setState({ kind: 'failed', run: 'solution', within: 90, isWhole: true, isFinal: true, others: null }, true);
    rest();
    expect(phase()).toBe('offered');
  });
});

describe('what mends a level on the page', () => {
  it('is previewed without a step, taken in one, and undone', async () => {
    const { document, proof, session, mend, phase, rest, work } = stage();
    document.change('Into the way', intoTheWay);
    rest();
    const broken = document.file();
    mend.start();
    const { found } = await work();
    expect(phase()).toBe('done');
    expect(found.length).toBeGreaterThanOrEqual(ENOUGH);
    for (const one of mend.store.getState().mending?.found ?? []) {
      mend.preview(one);
      expect(document.committedFile()).toBe(broken);
      expect(document.store.getState().steps).toBe(1);
      expect(proof.proof()).toMatchObject({
        verdict: 'completable',
        run: { name: one.run, outcome: 'completed', time: one.time },
      });
      // in the file as it would be written
      expect(outcomeOf(document.file(), one.run)).toBe('completed');
      expect(formatLevel(document.file())).toBe(formatLevel(one.file));
    }
    mend.leave();
    expect(document.file()).toEqual(broken);
    expect([phase(), session.getState().run]).toEqual(['done', null]);
    mend.preview(found[0]);
    mend.take();
    rest();
    expect(document.labels()).toHaveLength(2);
    expect(document.labels()[1]).toMatch(/^Move nova 1 back by [\d.]+ px$/);
    expect([phase(), proof.proof().verdict]).toEqual(['none', 'completable']);
    document.undo();
    expect(document.file()).toEqual(broken);
  });
});
