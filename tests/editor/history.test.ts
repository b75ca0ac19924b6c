import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  ASTRONAUT,
  addObject,
  applyPatches,
  BLACK_HOLE,
  createEditedLevel,
  createSelection,
  type DocumentEvent,
  deleteObjects,
  deleteRun,
  diffFiles,
  moveObjects,
  type Patch,
  setLevelProperty,
} from '../../editor/core/document/index.ts';
import { isSame, type LevelFile } from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const PLAIN: LevelFile = {
  version: 1,
  name: 'plain',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  novae: ['aa', 'bb', 'cc'].map((id, i) => ({ id, x: i, y: 0, radius: 16 })),
  runs: [{ name: 'run', holds: [1, 2, 3, 4, 5].map((n) => [10 * n, 10 * n + 5]) }],
};
const named = (name: string) => setLevelProperty('name', name);

describe('the history', () => {
  it('reports what undo and redo would do, and the position', () => {
    const level = createEditedLevel(PLAIN);
    const state = () => {
      const { file, revision, ...rest } = level.store.getState();
      expect(file).toBe(level.file());
      return rest;
    };
    expect(state()).toEqual({ undoLabel: null, redoLabel: null, done: 0, steps: 0 });
    expect([level.undo(), level.redo()]).toEqual([false, false]);
    for (const name of ['one', 'two', 'three']) level.change(name, named(name));
    expect(state()).toEqual({ undoLabel: 'three', redoLabel: null, done: 3, steps: 3 });
    expect([level.undo(), level.undo()]).toEqual([true, true]);
    expect(state()).toEqual({ undoLabel: 'one', redoLabel: 'two', done: 1, steps: 3 });
    level.goTo(3);
    expect(state()).toEqual({ undoLabel: 'three', redoLabel: null, done: 3, steps: 3 });
    level.goTo(1);
    expect([level.file().name, state().done]).toEqual(['one', 1]);
    level.goTo(1);
    expect(state().done).toBe(1);
    level.goTo(99);
    level.goTo(-99);
    expect(state()).toEqual({ undoLabel: null, redoLabel: 'one', done: 0, steps: 3 });
    const drag = level.begin('Drag');
    drag.set(named('dragged'));
    drag.commit();
    expect(state()).toEqual({ undoLabel: 'Drag', redoLabel: null, done: 1, steps: 1 });
  });

  it('has a different number for every content that is shown', () => {
    const level = createEditedLevel(PLAIN);
    const seen = [level.store.getState().revision];
    level.subscribe(() => seen.push(level.store.getState().revision));
    level.change('a', named('a'));
    level.undo();
    const drag = level.begin('b');
    drag.set(named('b'));
    drag.set(named('b'));
    drag.set(named('c'));
    drag.cancel();
    level.redo();
    expect(seen).toHaveLength(7);
    expect(new Set(seen).size).toBe(7);
  });

  it('reports a drag while it is shown, and stores it once at its end', () => {
    const level = createEditedLevel(PLAIN);
    const [seen, kept]: DocumentEvent[][] = [[], []];
    const stops = [level.subscribe((event) => seen.push(event)), level.onStep((event) => kept.push(event))];
    const drag = level.begin('Drag');
    const first = level.file();
    drag.set(named('b'));
    expect(level.committedFile()).toBe(first);
    drag.set(named('c'));
    expect([seen.length, kept.length]).toEqual([2, 0]);
    drag.commit();
    expect(kept).toEqual([
      {
        kind: 'change',
        how: 'edited',
        label: 'Drag',
        start: first,
        before: first,
        file: level.file(),
        patches: diffFiles(first, level.file()),
      },
    ]);
    expect(level.committedFile()).toBe(level.file());
    drag.cancel();
    drag.commit();
    expect(drag.set(named('d'))).toEqual({ ok: true, added: [] });
    level.undo();
    level.redo();
    expect(kept.map(({ kind, label }) => `${kind} ${label}`)).toEqual(['change Drag', 'undo Drag', 'redo Drag']);
    expect(seen.map(({ kind }) => kind)).toEqual(['change', 'change', 'undo', 'redo']);
    // a drag that returns to its start leaves no step
    const back = level.begin('Back');
    back.set(named('x'));
    back.set(named('c'));
    back.commit();
    const none = level.begin('None');
    none.cancel();
    expect([seen.length, kept.length]).toEqual([6, 3]);
    for (const stop of stops) stop();
    level.change('later', named('later'));
    expect([seen.length, kept.length]).toEqual([6, 3]);
  });

  it('ends a drag when anything else is done, and loses neither', () => {
    const others: ((level: ReturnType<typeof createEditedLevel>) => void)[] = [
      (level) => level.seal(),
      (level) => void level.change('other', named('other')),
      (level) => void level.replace('other', { ...level.file(), name: 'other' }),
      (level) => void level.begin('other'),
      (level) => void (level.undo() && level.redo()),
    ];
    for (const other of others) {
      const level = createEditedLevel(PLAIN);
      const drag = level.begin('Drag');
      drag.set(moveObjects(['aa'], 7, 0));
      expect(drag.isLive).toBe(true);
      other(level);
      expect(drag.isLive).toBe(false);
      expect(level.labels()[0]).toBe('Drag');
      expect(level.committedFile().novae?.[0].x).toBe(7);
      drag.cancel();
      expect(level.file().novae?.[0].x).toBe(7);
    }
  });

  it('joins the parts of one gesture in one step, reported one by one and undone together', () => {
    const level = createEditedLevel(PLAIN);
    level.change('before', named('before'));
    const kept: DocumentEvent[] = [];
    level.onStep((event) => kept.push(event));
    for (let i = 0; i < 3; i++) level.change('Nudge', moveObjects(['aa'], 1, 0), { gesture: 'n' });
    expect(kept.map(({ file }) => file.novae?.[0].x)).toEqual([1, 2, 3]);
    expect(level.labels()).toEqual(['before', 'Nudge']);
    level.undo();
    expect(level.file()).toMatchObject({ name: 'before', novae: [{ x: 0 }, {}, {}] });
    level.redo();
    expect(level.file().novae?.[0].x).toBe(3);
    // any other change in between ends it
    const between: (() => void)[] = [
      () => void level.change('other', named('x')),
      () => void level.replace('other', { ...level.file(), name: 'y' }),
      () => level.begin('other').cancel(),
      () => level.seal(),
    ];
    for (const act of between) {
      level.change('Nudge', moveObjects(['aa'], 1, 0), { gesture: 'n' });
      const before = level.labels().length;
      act();
      const after = level.labels().length;
      level.change('Nudge', moveObjects(['aa'], 1, 0), { gesture: 'n' });
      expect([level.labels().length - after, after - before <= 1]).toEqual([1, true]);
    }
  });

  it('reports the objects that a change has added', () => {
    const level = createEditedLevel(PLAIN);
    expect(level.change('Move', moveObjects(['aa'], 1, 0))).toEqual({ ok: true, added: [] });
    const added = level.change('Add', addObject('nova', 5, 5));
    expect(added).toEqual({ ok: true, added: [level.file().novae?.[3].id] });
    expect(level.change('Delete', deleteObjects(['aa']))).toEqual({ ok: true, added: [] });
    const swapped = level.change('Swap', (draft) => void Object.assign(draft.novae?.[0] ?? {}, { id: 'dd' }));
    expect(swapped).toEqual({ ok: true, added: ['dd'] });
    const drag = level.begin('Drag');
    expect(drag.set(addObject('alien', 1, 1))).toMatchObject({ ok: true, added: [expect.any(String)] });
    // since the beginning of the drag, however often it is updated
    expect(drag.set(addObject('alien', 1, 1))).toMatchObject({ ok: true, added: [expect.any(String)] });
    expect(drag.set((draft) => void Object.assign(draft, { name: '' }))).toMatchObject({ ok: false });
    drag.cancel();
    const empty = createEditedLevel({ ...PLAIN, novae: undefined });
    expect(empty.change('Add', addObject('nova', 5, 5))).toEqual({ ok: true, added: [empty.file().novae?.[0].id] });
  });

  it('ends a cancelled drag, which does not appear any more', () => {
    const level = createEditedLevel(PLAIN);
    const drag = level.begin('Drag');
    drag.set(named('dragged'));
    drag.cancel();
    expect(drag.isLive).toBe(false);
    drag.set(named('dragged'));
    drag.commit();
    level.seal();
    expect([level.file().name, level.labels()]).toEqual(['plain', []]);
    level.change('later', named('later'));
    expect(level.committedFile().name).toBe('later');
  });

  it('returns files that are frozen', () => {
    const isFrozen = (value: unknown): boolean =>
      typeof value !== 'object' || value === null || (Object.isFrozen(value) && Object.values(value).every(isFrozen));
    const level = createEditedLevel(structuredClone(PLAIN));
    expect(isFrozen(level.file())).toBe(true);
    level.change('Add', addObject('alien', 1, 1));
    expect(isFrozen(level.file())).toBe(true);
    level.replace('Replace', structuredClone({ ...PLAIN, name: 'other' }));
    expect(isFrozen(level.file())).toBe(true);
    level.undo();
    expect(isFrozen(level.file())).toBe(true);
  });
});

describe('patches', () => {
  const entries = fc.array(fc.constantFrom('a', 'b', 'c', 'd'), { maxLength: 5 });
  const holds = entries.map((list) => list.map((c): [number, number] => [c.charCodeAt(0), 200]));
  const withHolds = (list: [number, number][]): LevelFile => ({ ...PLAIN, runs: [{ name: 'run', holds: list }] });

  it('remove or add the middle of a list of holds, and do not touch the rest', () => {
    fc.assert(
      fc.property(holds, holds, holds, holds, (head, a, b, tail) => {
        fc.pre(a.length !== b.length);
        const [before, after] = [a, b].map((middle) => withHolds([...head, ...middle, ...tail]));
        const patches = diffFiles(before, after);
        expect(applyPatches(before, patches)).toEqual(after);
        expect(patches.length).toBeLessThanOrEqual(a.length + b.length);
        for (const { op, path } of patches)
          expect([op, path.slice(0, 3)]).toEqual([expect.stringMatching(/add|remove/), ['runs', 0, 'holds']]);
      }),
    );
  });

  it('name added, removed and changed values by their place, and a reordered list as a whole', () => {
    const [aa, bb, cc] = PLAIN.novae ?? [];
    const dd = { ...aa, id: 'dd' };
    const to = (novae: LevelFile['novae']): Patch[] => diffFiles(PLAIN, { ...PLAIN, novae });
    expect(to([aa, cc])).toEqual([{ op: 'remove', path: ['novae', 1] }]);
    expect(to([dd, aa, bb, cc])).toEqual([{ op: 'add', path: ['novae', 0], value: dd }]);
    expect(to([aa, dd, { ...cc, x: 9 }])).toEqual([
      { op: 'remove', path: ['novae', 1] },
      { op: 'add', path: ['novae', 1], value: dd },
      { op: 'replace', path: ['novae', 2, 'x'], value: 9 },
    ]);
    expect(to([bb, aa, cc])).toEqual([{ op: 'replace', path: ['novae'], value: [bb, aa, cc] }]);
    expect(to([aa, aa, cc])).toEqual([{ op: 'replace', path: ['novae'], value: [aa, aa, cc] }]);
    expect(to([aa, bb, { ...cc, hot: true } as never])).toEqual([{ op: 'add', path: ['novae', 2, 'hot'], value: true }]);
    const other = { ...PLAIN, 'x-own': { a: 1, b: [1] } } as LevelFile;
    expect(diffFiles(other, { ...other, 'x-own': { a: 2, b: [1] } } as LevelFile)).toEqual([
      { op: 'replace', path: ['x-own'], value: { a: 2, b: [1] } },
    ]);
    expect(diffFiles(other, { ...other, 'x-own': { b: [1], a: 1 } } as LevelFile)).toEqual([]);
    const runs = (...names: string[]) => ({ ...PLAIN, runs: names.map((name) => ({ name, holds: [] })) });
    expect(diffFiles(runs('a', 'b', 'c', 'd'), runs('b', 'x', 'd'))).toEqual([
      { op: 'remove', path: ['runs', 2] },
      { op: 'remove', path: ['runs', 0] },
      { op: 'add', path: ['runs', 1], value: { name: 'x', holds: [] } },
    ]);
    expect(diffFiles(PLAIN, { ...PLAIN, runs: [] })).toEqual([{ op: 'remove', path: ['runs', 0] }]);
  });

  it('are empty between values that differ at most in the order of keys, and not between others', () => {
    const shuffled = (value: unknown): unknown => {
      if (Array.isArray(value)) return value.map(shuffled);
      if (typeof value !== 'object' || value === null) return value;
      return Object.fromEntries(
        Object.entries(value)
          .reverse()
          .map(([key, inner]) => [key, shuffled(inner)]),
      );
    };
    const sorted = (value: unknown): string =>
      JSON.stringify(value, (_, inner) =>
        typeof inner === 'object' && inner !== null && !Array.isArray(inner)
          ? Object.fromEntries(Object.entries(inner).sort(([a], [b]) => (a < b ? -1 : 1)))
          : inner,
      );
    const small = fc.letrec<{ value: unknown }>((tie) => ({
      value: fc.oneof(
        { maxDepth: 2 },
        fc.constantFrom<unknown>(0, 1, '', '0', null, true),
        fc.array(tie('value'), { maxLength: 2 }),
        fc.dictionary(fc.constantFrom('a', 'b', '0', 'length'), tie('value'), { maxKeys: 2 }),
      ),
    })).value;
    fc.assert(
      fc.property(small, small, (a, b) => {
        expect(isSame(a, shuffled(a))).toBe(true);
        expect(isSame(a, b)).toBe(sorted(a) === sorted(b));
      }),
      { numRuns: 800 },
    );
    expect(isSame({ a: undefined }, { b: undefined })).toBe(false);
    expect(isSame({ a: undefined }, {})).toBe(false);
  });

  it('are empty between a file and itself, except between a missing and an empty list', () => {
    fc.assert(
      fc.property(arbitraryFile, arbitraryFile, (a, b) => {
        expect(diffFiles(a, b).length === 0).toBe(isSame(a, b));
      }),
    );
    expect(diffFiles(PLAIN, { ...PLAIN, aliens: [] })).toEqual([{ op: 'add', path: ['aliens'], value: [] }]);
    expect(diffFiles({ ...PLAIN, aliens: [] }, PLAIN)).toEqual([{ op: 'remove', path: ['aliens'] }]);
  });
});

describe('the selection', () => {
  it('contains existing objects, each once, in the order of their selection', () => {
    const selection = createSelection(createEditedLevel(PLAIN));
    selection.select(['cc', 'nowhere', 'aa', 'cc']);
    expect(selection.keys()).toEqual(['cc', 'aa']);
    selection.add(['bb', 'aa', 'nowhere']);
    expect(selection.keys()).toEqual(['cc', 'aa', 'bb']);
    selection.toggle(['aa']);
    expect(selection.keys()).toEqual(['cc', 'bb']);
    selection.toggle(['aa']);
    selection.toggle(['nowhere']);
    expect(selection.keys()).toEqual(['cc', 'bb', 'aa']);
    selection.selectAll();
    expect(selection.keys()).toEqual([ASTRONAUT, BLACK_HOLE, 'aa', 'bb', 'cc']);
    selection.clear();
    expect(selection.store.getState()).toEqual({ keys: [], holds: [], run: null });
  });

  it('contains objects or holds, not both', () => {
    const selection = createSelection(createEditedLevel(PLAIN));
    for (const act of [
      () => selection.select(['aa']),
      () => selection.add(['aa']),
      () => selection.toggle(['aa']),
      () => selection.selectAll(),
    ]) {
      selection.selectHolds('run', [3, 1, 3, 7]);
      expect(selection.store.getState()).toEqual({ keys: [], holds: [1, 3], run: 'run' });
      act();
      expect(selection.store.getState()).toEqual({ keys: expect.arrayContaining(['aa']), holds: [], run: null });
    }
    selection.selectHolds('run', [4, 5]);
    expect(selection.store.getState().holds).toEqual([4]);
    selection.selectHolds('run', []);
    expect(selection.store.getState()).toEqual({ keys: [], holds: [], run: null });
    selection.selectHolds('nowhere', [0]);
    expect(selection.store.getState()).toEqual({ keys: [], holds: [], run: null });
  });

  it('loses what vanishes while it follows the level, and reports nothing else', () => {
    const level = createEditedLevel(PLAIN);
    const selection = createSelection(level);
    let times = 0;
    selection.store.subscribe(() => times++);
    selection.select(['bb', ASTRONAUT, 'aa']);
    level.change('Move', moveObjects(['aa'], 1, 1));
    expect(times).toBe(1);
    level.change('Delete', deleteObjects(['bb']));
    expect([selection.keys(), times]).toEqual([[ASTRONAUT, 'aa'], 2]);
    selection.selectHolds('run', [0, 4]);
    level.change('Delete', deleteRun('run'));
    expect(selection.store.getState()).toEqual({ keys: [], holds: [], run: null });
    selection.select(['aa']);
    selection.close();
    level.change('Delete', deleteObjects(['aa']));
    expect(selection.keys()).toEqual(['aa']);
  });
});
