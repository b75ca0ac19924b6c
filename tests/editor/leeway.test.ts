import { describe, expect, it } from 'vitest';
import type { Box } from '../../editor/canvas/index.ts';
import {
  createEditedLevel,
  createSelection,
  duplicateObjects,
  moveHold,
  moveObjects,
  setLevelProperty,
  setRadius,
} from '../../editor/core/document/index.ts';
import { createProofStore } from '../../editor/core/proof/index.ts';
import { createSession } from '../../editor/core/session/index.ts';
import { createSettings } from '../../editor/core/settings/index.ts';
import {
  meaningInWords,
  movedInWords,
  noteInWords,
  reachInWords,
  samplingInWords,
} from '../../editor/features/leeway/leeway-words.ts';
import { isOnlyMoved, leewayOf, type Question, watchLeeway } from '../../editor/features/leeway/watch-leeway.ts';
import { type Leeway, MOST_REACH, type Reach, type Requests } from '../../editor/workers/index.ts';
import { DEFAULT_TERMS, termsOf } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import { type FakeJob, FakeWorkers } from './fake-desk.ts';
import { breathe } from './stage.ts';
import { SWING } from './swing-level.ts';

const FILE: LevelFile = {
  ...SWING,
  novae: [
    { id: 'n1', x: 400, y: 700, radius: 16 },
    { id: 'n2', x: 420, y: 760, radius: 16 },
  ],
  wormholes: [{ id: 'w1', x: 100, y: 100, toX: 180, toY: 100, radius: 16 }],
};

const KNOWN: Leeway = {
  base: 'completes',
  lattice: { x: 600, y: 620, unit: 1, base: 1 },
  cells: Int32Array.of(0, 0, 16, 16, 0),
  reach: [],
  isReachKnown: false,
  every: 16,
  atEdges: 0,
  isCovered: true,
  samples: 5,
  isFinished: false,
};

/** A page whose rest and workers a test controls. */
function stage() {
  const document = createEditedLevel(FILE);
  const proof = createProofStore(document, DEFAULT_TERMS);
  const selection = createSelection(document);
  const session = createSession([{ id: 'leeway', title: 'leeway', isShown: false }]);
  const settings = createSettings(null);
  const view = { seen: { left: 0, top: 0, right: 900, bottom: 900 } as Box, calls: [] as (() => void)[] };
  const workers = new FakeWorkers();
  const jobs = workers.jobs as (FakeJob & { readonly request: Requests['leeway'] })[];
  let waiting: (() => void) | null = null;
  const afterRest = (_: number, call: () => void) => {
    waiting = call;
    return () => {
      if (waiting === call) waiting = null;
    };
  };
  const level = { document, proof, selection };
  const close = watchLeeway({
    level,
    session,
    settings,
    seen: {
      now: () => view.seen,
      subscribe: (call) => {
        view.calls.push(call);
        return () => {};
      },
    },
    desk: { workers, afterRest, after: afterRest },
  });
  return {
    document,
    proof,
    selection,
    session,
    settings,
    jobs,
    close,
    rest() {
      const call = waiting;
      waiting = null;
      call?.();
    },
    show: (leeway: boolean) => session.setState(({ layers }) => ({ layers: { ...layers, leeway } })),
    see(seen: Box) {
      view.seen = seen;
      for (const call of view.calls) call();
    },
    shown: () => leewayOf(level).getState(),
    store: leewayOf(level),
    running: () => jobs.filter(({ isCancelled }) => !isCancelled).length,
  };
}

/** With an answer on the screen. */
function answered() {
  const all = stage();
  all.show(true);
  all.selection.select(['bjzg']);
  all.rest();
  all.jobs[0].tell(KNOWN);
  return all;
}

describe('where the selection may stand', () => {
  it('costs nothing while it is hidden or nothing is selected, and begins once the page rests', () => {
    const { selection, jobs, rest, show, shown, session, running } = stage();
    selection.select(['bjzg']);
    rest();
    expect([jobs.length, shown().phase]).toEqual([0, 'off']);
    selection.clear();
    show(true);
    rest();
    expect([jobs.length, shown().phase]).toEqual([0, 'nothing selected']);
    selection.select(['bjzg']);
    expect([jobs.length, shown().phase]).toEqual([0, 'waiting']);
    rest();
    const [{ request, tell }] = jobs;
    expect(request).toMatchObject({
      holds: [[150, 435]],
      objects: [{ kind: 'asteroid', index: 0 }],
      only: null,
      lead: { x: 600, y: 620 },
      grid: 8,
      seen: { right: 900 },
    });
    tell(KNOWN);
    expect([shown().phase, shown().answer?.leeway]).toEqual(['sampling', KNOWN]);
    session.setState({ mode: 'play' });
    expect([running(), shown().phase]).toEqual([0, 'off']);
    session.setState({ mode: 'edit' });
    rest();
    expect(running()).toBe(1);
    show(false);
    expect([running(), shown().answer]).toEqual([0, null]);
  });

  it('is thrown away when the level, the run, the accuracy or the selection changes', () => {
    for (const change of [
      ({ document }) => void document.change('Move', moveObjects(['n1'], 3, 0)),
      ({ document }) => void document.change('Range', setLevelProperty('range', 260)),
      ({ document }) => void document.change('Hold', moveHold('solution', 0, 2)),
      ({ document }) => void document.change('Resize', setRadius(['bjzg'], 30)),
      ({ proof }) => proof.setTerms(termsOf('arcade')),
      ({ proof }) => proof.setTerms({ ...DEFAULT_TERMS, rules: { pull: 40 } }),
      ({ selection }) => selection.select(['n1']),
      ({ selection }) => selection.add(['n1']),
      ({ settings }) => settings.setState({ snapToGrid: false }),
    ] as ((all: ReturnType<typeof stage>) => void)[]) {
      const all = answered();
      change(all);
      expect([all.shown().phase, all.shown().answer, all.running()], String(change)).toEqual(['waiting', null, 0]);
      // what the old job still says is not believed
      all.jobs[0].tell(KNOWN);
      expect(all.shown().answer).toBeNull();
      all.rest();
      expect(all.running()).toBe(1);
    }
  });

  it('stays while the object itself is dragged, also if holds are re-timed, and until something newer is known', () => {
    const { document, shown, jobs, rest, running } = answered();
    const gesture = document.begin('Move');
    gesture.set(moveObjects(['bjzg'], 8, -8));
    expect(shown().answer?.leeway).toBe(KNOWN);
    gesture.set((draft) => {
      moveObjects(['bjzg'], 16, 0)(draft);
      moveHold('solution', 0, 3)(draft);
    });
    expect(shown().answer?.leeway).toBe(KNOWN);
    // nothing is drawn meanwhile
    jobs[0].tell({ ...KNOWN, samples: 50 });
    expect(shown().answer?.leeway).toBe(KNOWN);
    gesture.set(moveObjects(['bjzg'], 16, 0));
    gesture.commit();
    // the same shade is true for the object at its new place
    expect([shown().answer?.leeway, shown().phase]).toEqual([KNOWN, 'waiting']);
    rest();
    expect([running(), jobs[1].request.lead]).toEqual([1, { x: 616, y: 620 }]);
    jobs[1].tell({ ...KNOWN, samples: 7 });
    expect(shown().answer?.leeway.samples).toBe(7);
  });

  it('shows what came during a drag that was cancelled', () => {
    const { document, shown, jobs } = answered();
    const gesture = document.begin('Move');
    gesture.set(moveObjects(['bjzg'], 8, 0));
    jobs[0].tell({ ...KNOWN, samples: 50, isFinished: true });
    gesture.cancel();
    expect([shown().answer?.leeway.samples, shown().phase]).toEqual([50, 'done']);
  });

  it('goes with any other change in a drag', () => {
    for (const recipe of [
      setRadius(['bjzg'], 20),
      moveObjects(['n1'], 4, 0),
      moveObjects(['bjzg', 'n1'], 4, 0),
      duplicateObjects(['bjzg'], 30, 0),
    ]) {
      const { document, shown, rest, running } = answered();
      const gesture = document.begin('Change');
      gesture.set(recipe);
      expect(shown().answer).toBeNull();
      gesture.cancel();
      rest();
      expect(running()).toBe(1);
    }
  });

  it('of several objects: moved together', () => {
    const { selection, shown, jobs, rest, show, document } = stage();
    show(true);
    selection.select(['n1', 'n2']);
    rest();
    expect(jobs[0].request.objects).toEqual([
      { kind: 'nova', index: 0 },
      { kind: 'nova', index: 1 },
    ]);
    jobs[0].tell(KNOWN);
    const question = shown().answer?.question as Question;
    const movedBy = (keys: string[], dx: number) => {
      const other = createEditedLevel(document.file());
      other.change('Move', moveObjects(keys, dx, 0));
      return { file: other.file(), level: resolveLevel(other.file()) };
    };
    expect(isOnlyMoved(question, movedBy(['n1', 'n2'], 5))).toBe(true);
    expect(isOnlyMoved(question, movedBy(['n1'], 5))).toBe(false);
    expect(isOnlyMoved(question, movedBy(['n2'], 5))).toBe(false);
    expect(isOnlyMoved(question, movedBy(['n1', 'n2', 'bjzg'], 5))).toBe(false);
  });

  it('of one mouth of a wormhole', () => {
    const { selection, store, shown, jobs, rest, show } = stage();
    show(true);
    selection.select(['w1']);
    rest();
    expect([jobs[0].request.only, jobs[0].request.lead]).toEqual([null, { x: 100, y: 100 }]);
    store.setState({ only: 1 });
    rest();
    expect([jobs[1].request.only, jobs[1].request.lead]).toEqual([1, { x: 180, y: 100 }]);
    jobs[1].tell(KNOWN);
    expect(movedInWords(shown().answer?.question as Question)).toBe('Second mouth of wormhole 1');
    // other objects have one place only
    selection.select(['bjzg']);
    rest();
    expect(jobs[2].request.only).toBeNull();
  });

  it('samples anew when more of the level is in view, and not when less is', () => {
    const { see, running, jobs, shown, rest } = answered();
    see({ left: 100, top: 100, right: 500, bottom: 500 });
    expect(running()).toBe(1);
    see({ left: -100, top: 100, right: 500, bottom: 500 });
    expect([running(), shown().answer?.leeway]).toEqual([0, KNOWN]);
    rest();
    expect(jobs[1].request.seen.left).toBe(-100);
  });

  it('says what it does not know', async () => {
    const { jobs, shown, selection, rest } = answered();
    jobs[0].tell({ ...KNOWN, base: 'unknown' });
    expect([shown().phase, shown().answer]).toEqual(['too large', null]);
    expect(noteInWords(shown())).toBe('Not sampled: the run takes too much work.');
    selection.select(['n1']);
    rest();
    jobs[1].end({ kind: 'failed', message: 'the worker could not be loaded' });
    await breathe();
    expect(noteInWords(shown())).toBe('Failed: the worker could not be loaded. Hide and show it to try again.');
  });
});

describe('the legend in words', () => {
  const reach = (direction: Reach['direction'], same: number, isEnd = true): Reach => ({ direction, same, isEnd });
  const all = [reach('left', 8), reach('right', MOST_REACH, false), reach('up', 0), reach('down', 1)];

  it('says how far it may go, or where it would have to', () => {
    expect(reachInWords({ ...KNOWN, reach: all })).toBeNull();
    expect(reachInWords({ ...KNOWN, reach: all, isReachKnown: true })).toBe(
      'May go left 8 px, right 400 px or more, up not at all, down 1 px.',
    );
    expect(reachInWords({ base: 'fails', reach: all, isReachKnown: true })).toBe(
      'Would complete left by 9 px, right not within 400 px, up by 1 px, down by 2 px.',
    );
  });

  it('says how finely it is sampled, and whether that goes on', () => {
    const { shown, jobs } = answered();
    expect(samplingInWords(shown())).toBe('Sampled every 16 px; refining…');
    jobs[0].tell({ ...KNOWN, every: 64, atEdges: 16, isCovered: false });
    expect(samplingInWords(shown())).toBe('Sampled every 64 px, at edges every 16 px; dotted: not sampled yet; refining…');
    // where samples differ, a cell is still larger than the grid: not all of its places were sampled
    jobs[0].tell({ ...KNOWN, every: 8, atEdges: 16 });
    expect(samplingInWords(shown())).toBe('Sampled every 16 px; refining…');
    jobs[0].tell({ ...KNOWN, lattice: { x: 0, y: 0, unit: 1, base: 8 }, every: 8, atEdges: 1, isFinished: true });
    expect(samplingInWords(shown())).toBe('Sampled at every grid place (8 px), at edges every 1 px.');
  });

  it('says what the shade means, also where the run fails', () => {
    const { shown, jobs } = answered();
    const meaning = () => meaningInWords(shown().answer as NonNullable<ReturnType<typeof shown>['answer']>);
    expect(meaning()).toBe('Hatched: solution still completes the level.');
    jobs[0].tell({ ...KNOWN, base: 'fails' });
    expect(meaning()).toBe('Hatched: solution would complete the level. It fails as it is: there is no place to keep.');
  });
});
