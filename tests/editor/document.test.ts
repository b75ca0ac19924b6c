import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  ASTRONAUT,
  addHold,
  addObject,
  addRun,
  alignObjects,
  applyPatches,
  BLACK_HOLE,
  copyObjects,
  createEditedLevel,
  createSelection,
  type DocumentEvent,
  deleteHolds,
  deleteObjects,
  deleteRun,
  diffFiles,
  distributeObjects,
  duplicateObjects,
  duplicateRun,
  type EditedLevel,
  freeRunName,
  holdsOf,
  keyAt,
  lockedIn,
  marksOf,
  moveHold,
  moveObjects,
  objectsOf,
  pasteObjects,
  type Recipe,
  readClipping,
  renameRun,
  reorderObject,
  reorderRun,
  replaceHolds,
  scaleRadius,
  setLevelProperty,
  setObjectProperty,
  setRadius,
  splitHold,
  stretchHold,
} from '../../editor/core/document/index.ts';
import { objectRows } from '../../editor/features/outliner/object-rows.ts';
import { formatLevel, type LevelFile, LIMITS, OBJECT_LISTS, readLevel } from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const PLAIN: LevelFile = {
  version: 1,
  name: 'plain',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: [
    { id: 'aa', x: 10, y: 20, radius: 16 },
    { id: 'bb', x: 110, y: 40, radius: 32, hot: true },
    { id: 'cc', x: 400, y: 90, radius: 16 },
  ],
  aliens: [{ id: 'zz', x: 5, y: 6 }],
  runs: [
    {
      name: 'solution',
      holds: [
        [10, 20],
        [30, 40],
        [60, 90],
      ],
    },
  ],
};
const open = (more: Partial<LevelFile> = {}) => createEditedLevel({ ...PLAIN, ...more });
const holds = (level: EditedLevel) => level.file().runs?.[0].holds;

/** Every operation of the user, with arbitrary numbers. */
type Act = (level: EditedLevel) => void;
const wild = fc.oneof(
  { weight: 5, arbitrary: fc.integer({ min: -300, max: 900 }) },
  {
    weight: 1,
    arbitrary: fc.constantFrom(0, -0, 0.5, 1e12, -1e12, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NaN),
  },
);
const nth = fc.nat(20);
const some = fc.array(nth, { maxLength: 4 });
const keysOf = (level: EditedLevel, indices: readonly number[]): string[] => {
  const keys = [...objectsOf(level.file()).keys()];
  return indices.map((i) => keys[i % keys.length]);
};
const runOf = (level: EditedLevel, n: number): string => {
  const runs = level.file().runs ?? [];
  return runs.length === 0 ? 'none' : runs[n % runs.length].name;
};
const onObjects = (recipe: (keys: string[], a: number, b: number, level: EditedLevel) => Recipe): fc.Arbitrary<Act> =>
  fc.tuple(some, wild, wild, fc.boolean()).map(
    ([indices, a, b, gesture]) =>
      (level: EditedLevel) =>
        void level.change('act', recipe(keysOf(level, indices), a, b, level), gesture ? { gesture: 'g' } : {}),
  );
const onRun = (recipe: (run: string, n: number, a: number, ripple: boolean, level: EditedLevel) => Recipe): fc.Arbitrary<Act> =>
  fc.tuple(nth, nth, wild, fc.boolean()).map(
    ([run, n, a, ripple]) =>
      (level: EditedLevel) =>
        void level.change('act', recipe(runOf(level, run), n % 4, a, ripple, level)),
  );

const arbitraryAct: fc.Arbitrary<Act> = fc.oneof(
  onObjects((keys, a, b) => moveObjects(keys, a, b)),
  onObjects((keys, a) => setRadius(keys, a)),
  onObjects((keys, a, _, level) => scaleRadius(level.file(), keys, a)),
  onObjects((keys) => deleteObjects(keys)),
  onObjects((keys, a, b) => duplicateObjects(keys, a, b)),
  onObjects((keys, _a, _b, level) => alignObjects(level.file(), keys, 'left')),
  onObjects((keys, _a, _b, level) => distributeObjects(level.file(), keys, 'y')),
  onObjects((keys, a) => setObjectProperty(keys, 'vx', a)),
  onObjects((keys, a) => setObjectProperty(keys, 'hot', a > 0)),
  onObjects((keys) => setObjectProperty(keys, 'radius', undefined)),
  onObjects((keys, a) => reorderObject(keys[0] ?? 'none', a)),
  onObjects((_, a, b) =>
    addObject(
      (['hot', 'nova', 'alien', 'mineral', 'repulsor', 'asteroid'] as const)[Math.abs(Math.trunc(a || 0)) % 6] ?? 'nova',
      a,
      b,
    ),
  ),
  onObjects((keys, a, b, level) => {
    const reading = readClipping(copyObjects(level.file(), keys) ?? '');
    return reading.ok ? pasteObjects(reading.clipping, a, b) : () => undefined;
  }),
  onObjects((_, a) => setLevelProperty('range', a > 100 ? undefined : a)),
  onObjects((_, a) => setLevelProperty('name', 'é'.repeat(Math.min(200, Math.max(0, a || 0))))),
  onRun((_run, n, a, first, level) => addRun(freeRunName(level.file(), 'solution'), [[n, a]], first ? 'first' : 'last')),
  onRun((run, _n, _a, _r, level) => duplicateRun(run, freeRunName(level.file(), run))),
  onRun((run, _n, a) => renameRun(run, `run ${a}`)),
  onRun((run) => deleteRun(run)),
  onRun((run, n) => reorderRun(run, n)),
  onRun((run, n, a, ripple) => moveHold(run, n, a, { ripple })),
  onRun((run, n, a, ripple) => stretchHold(run, n, 'press', a, { ripple })),
  onRun((run, n, a, ripple) => stretchHold(run, n, 'release', a, { ripple })),
  onRun((run, n, a) => splitHold(run, n, a)),
  onRun((run, n, a) => addHold(run, n * 50, a)),
  onRun((run, n, _a, ripple) => deleteHolds(run, [n], { ripple })),
  onRun((run, n, a) => replaceHolds(run, [[n, a]])),
  fc.constant<Act>((level) => void level.undo()),
  fc.constant<Act>((level) => void level.redo()),
  fc.constant<Act>((level) => level.seal()),
  fc.tuple(some, wild, wild, fc.boolean()).map(([indices, a, b, commits]) => (level: EditedLevel) => {
    const gesture = level.begin('drag');
    const keys = keysOf(level, indices);
    gesture.set(moveObjects(keys, b, a));
    gesture.set(moveObjects(keys, a, b));
    if (commits) gesture.commit();
    else gesture.cancel();
  }),
);

const isValid = (file: LevelFile) => {
  const reading = readLevel(formatLevel(file));
  return reading.ok ? formatLevel(reading.document.file) === formatLevel(file) : reading.problems;
};

describe('any sequence of operations', () => {
  it('leaves a level that reads back the same; undoing everything restores the start bit for bit, and redoing the end', () => {
    fc.assert(
      fc.property(arbitraryFile, fc.array(arbitraryAct, { minLength: 1, maxLength: 12 }), (file, acts) => {
        const level = createEditedLevel(file);
        const start = structuredClone(level.file());
        for (const act of acts) {
          act(level);
          expect(isValid(level.file())).toBe(true);
        }
        const end = structuredClone(level.file());
        const { done, steps } = level.store.getState();
        while (level.undo());
        expect(level.file()).toStrictEqual(start);
        expect(formatLevel(level.file())).toBe(formatLevel(start));
        level.goTo(done);
        expect(level.file()).toStrictEqual(end);
        expect(level.store.getState()).toMatchObject({ done, steps });
      }),
      { numRuns: 40 },
    );
  });

  it('is reported as patches: live ones between the shown states, and steps between the stored states', () => {
    fc.assert(
      fc.property(arbitraryFile, fc.array(arbitraryAct, { maxLength: 8 }), (file, acts) => {
        const level = createEditedLevel(file);
        let seen = level.file();
        let kept = level.file();
        level.subscribe(({ patches }) => {
          seen = applyPatches(seen, patches);
        });
        level.onStep(({ patches }) => {
          kept = applyPatches(kept, patches);
        });
        for (const act of acts) act(level);
        expect(seen).toStrictEqual(level.file());
        expect(kept).toStrictEqual(level.file());
      }),
      { numRuns: 40 },
    );
  });

  it('finds the objects, their marks and their rows as in a file that was just read', () => {
    fc.assert(
      fc.property(arbitraryFile, fc.array(arbitraryAct, { minLength: 1, maxLength: 12 }), (file, acts) => {
        const level = createEditedLevel(file);
        const look = (of: LevelFile) => ({
          objects: [...objectsOf(of)],
          marks: [...objectsOf(of).values()].map(marksOf),
          locked: lockedIn(of),
          rows: objectRows(of, new Set()),
        });
        // what is the same is reused from the file before
        const seen = acts.map((act) => {
          act(level);
          return { of: level.file(), ...look(level.file()) };
        });
        // nothing of a copy is
        for (const { of, ...found } of seen) expect(found).toStrictEqual(look(structuredClone(of)));
      }),
      { numRuns: 40 },
    );
  });
});

describe('patches', () => {
  it('lead from any file to any other and back', () => {
    fc.assert(
      fc.property(arbitraryFile, arbitraryFile, (a, b) => {
        expect(applyPatches(a, diffFiles(a, b))).toStrictEqual(b);
        expect(applyPatches(b, diffFiles(b, a))).toStrictEqual(a);
        expect(diffFiles(a, structuredClone(a))).toEqual([]);
      }),
      { numRuns: 120 },
    );
  });

  it('name one object if one of many is removed', () => {
    const many = { ...PLAIN, novae: Array.from({ length: 1000 }, (_, i) => ({ id: `n${i}`, x: i, y: 0, radius: 16 })) };
    const level = createEditedLevel(many);
    const steps: DocumentEvent[] = [];
    level.onStep((event) => steps.push(event));
    level.change('Delete', deleteObjects(['n500']));
    expect(steps[0].patches).toEqual([{ op: 'remove', path: ['novae', 500] }]);
  });
});

describe('history', () => {
  it('joins the changes of one gesture, and no others', () => {
    const level = open();
    for (let i = 0; i < 5; i++) level.change('Nudge', moveObjects(['aa'], 1, 0), { gesture: 'nudge aa' });
    expect(level.labels()).toEqual(['Nudge']);
    level.seal();
    level.change('Nudge', moveObjects(['aa'], 1, 0), { gesture: 'nudge aa' });
    level.change('Nudge', moveObjects(['bb'], 1, 0), { gesture: 'nudge bb' });
    expect(level.labels()).toEqual(['Nudge', 'Nudge', 'Nudge']);
    level.goTo(0);
    expect(level.file()).toStrictEqual(createEditedLevel(PLAIN).file());
  });

  it('does not join across an undo', () => {
    const level = open();
    level.change('Nudge', moveObjects(['aa'], 1, 0), { gesture: 'n' });
    level.undo();
    level.redo();
    level.change('Nudge', moveObjects(['aa'], 1, 0), { gesture: 'n' });
    expect(level.labels()).toHaveLength(2);
  });

  it('makes a drag one step, of which each update replaces the last; Escape leaves no trace', () => {
    const level = open();
    const drag = level.begin('Move');
    drag.set(moveObjects(['aa'], 50, 0));
    drag.set(moveObjects(['aa'], 1, 2));
    expect(level.file().asteroids?.[0]).toMatchObject({ x: 11, y: 22 });
    expect(level.labels()).toEqual([]);
    drag.commit();
    expect(level.labels()).toEqual(['Move']);
    const other = level.begin('Move');
    other.set(moveObjects(['aa'], 50, 0));
    other.cancel();
    expect(level.file().asteroids?.[0]).toMatchObject({ x: 11, y: 22 });
    expect(level.labels()).toEqual(['Move']);
  });

  it('ends a drag when something else changes the level, and keeps the drag so far', () => {
    const level = open();
    const drag = level.begin('Move');
    drag.set(moveObjects(['aa'], 1, 0));
    level.replace('Changed on disk', { ...level.file(), name: 'theirs' });
    expect(drag.isLive).toBe(false);
    drag.set(moveObjects(['aa'], 500, 0));
    expect(level.file()).toMatchObject({ name: 'theirs', asteroids: [{ x: 11 }, {}, {}] });
    expect(level.labels()).toEqual(['Move', 'Changed on disk']);
  });

  it('forgets undone steps after another change, and no earlier ones', () => {
    const level = open();
    for (const name of ['one', 'two', 'three']) level.change(name, setLevelProperty('name', name));
    level.undo();
    level.undo();
    level.change('four', setLevelProperty('name', 'four'));
    expect(level.labels()).toEqual(['one', 'four']);
    expect(level.redo()).toBe(false);
  });

  it('adds no step for an operation that changes nothing', () => {
    const level = open();
    level.change('Nothing', moveObjects(['aa'], 0, 0));
    level.change('Nothing', moveObjects(['nowhere'], 5, 0));
    level.begin('Nothing').commit();
    expect(level.labels()).toEqual([]);
  });
});

describe('values', () => {
  it('are clamped to their limits', () => {
    const level = open();
    level.change('Type', setObjectProperty(['aa'], 'x', 1e300));
    level.change('Type', setObjectProperty(['aa'], 'radius', -4));
    level.change('Type', setObjectProperty([ASTRONAUT], 'vy', Number.NEGATIVE_INFINITY));
    expect(level.file().asteroids?.[0]).toMatchObject({ x: LIMITS.coordinate, radius: LIMITS.leastRadius });
    expect(level.file().astronaut.vy).toBe(-LIMITS.velocity);
  });

  it.each<[string, Recipe]>([
    ['not be a number', setObjectProperty(['aa'], 'x', Number.NaN)],
    ['the astronaut has no radius', setObjectProperty([ASTRONAUT], 'radius', 5)],
    ['no hot', setObjectProperty(['zz'], 'hot', true)],
    ['has no radius', setObjectProperty(['aa'], 'radius', undefined)],
    ['needs a name', setLevelProperty('name', '')],
    ['a run called "solution" already', addRun('solution', [])],
    ['a run needs a name', renameRun('solution', '')],
    ['has no colour', (draft) => void Object.assign(draft.astronaut, { colour: 'red' })],
  ])('are refused if no valid value is close: %s', (message, recipe) => {
    const level = open();
    const result = level.change('Type', recipe);
    expect(result).toMatchObject({ ok: false, refusal: { message: expect.stringContaining(message) } });
    expect(level.file()).toStrictEqual(createEditedLevel(PLAIN).file());
  });

  it('of other programs (x-) stay', () => {
    const level = open({ 'x-tool': { a: [1] } } as Partial<LevelFile>);
    level.change('Move', moveObjects(['aa'], 1, 1));
    expect(level.file()).toMatchObject({ 'x-tool': { a: [1] } });
  });
});

describe('objects', () => {
  it('are reported when they are new, so that they can be selected', () => {
    const level = open();
    const selection = createSelection(level);
    const result = level.change('Add', addObject('hot', 1, 2));
    expect(result).toMatchObject({ ok: true, added: [expect.stringMatching(/^[a-z0-9]+$/)] });
    if (result.ok) selection.select(result.added);
    expect(selection.keys()).toHaveLength(1);
    level.undo();
    expect(selection.keys()).toEqual([]);
  });

  it('can be copied between levels as text, and keep everything except their id', () => {
    const text = copyObjects(PLAIN, ['bb', 'zz', ASTRONAUT]) ?? '';
    const reading = readClipping(text);
    expect(reading).toMatchObject({ ok: true, count: 2, clipping: { asteroids: [{ x: 110, y: 40, radius: 32, hot: true }] } });
    const level = open();
    if (reading.ok) level.change('Paste', pasteObjects(reading.clipping, 8, 8));
    expect(level.file().asteroids).toHaveLength(4);
    expect(level.file().asteroids?.[3]).toMatchObject({ x: 118, y: 48, radius: 32, hot: true });
    expect(copyObjects(PLAIN, [ASTRONAUT, BLACK_HOLE])).toBeNull();
  });

  it.each(['', 'hello', '[]', '{}', '{"asteroids": []}', '{"asteroids": [{"x": 1}]}', '{"asteroids": 5}'])(
    'are not pasted from %s',
    (text) => {
      expect(readClipping(text)).toMatchObject({ ok: false });
    },
  );

  it('are aligned by their rims and distributed by their centres', () => {
    const level = open();
    level.change('Align', alignObjects(level.file(), ['aa', 'bb', 'cc'], 'left'));
    expect(level.file().asteroids?.map(({ x, radius }) => x - radius)).toEqual([-6, -6, -6]);
    level.undo();
    level.change('Spread', distributeObjects(level.file(), ['cc', 'aa', 'bb'], 'x'));
    expect(level.file().asteroids?.map(({ x }) => x)).toEqual([10, 205, 400]);
  });

  it('are found by the pointer of a problem', () => {
    expect(['/asteroids/1/x', '/astronaut', '/blackHole/radius', '/aliens/0', '/runs/0', ''].map((p) => keyAt(PLAIN, p))).toEqual(
      ['bb', ASTRONAUT, BLACK_HOLE, 'zz', null, null],
    );
  });

  it('get different ids if they are duplicated twice at the same place', () => {
    const level = open();
    for (let i = 0; i < 3; i++) level.change('Duplicate', duplicateObjects(['aa'], 0, 0));
    const ids = OBJECT_LISTS.flatMap((list) => (level.file()[list] ?? []).map(({ id }) => id));
    expect(new Set(ids).size).toBe(7);
  });
});

describe('holds', () => {
  it('stop one tick before their neighbours, and with Alt push them along', () => {
    const level = open();
    level.change('Move', moveHold('solution', 1, 1000));
    expect(holds(level)).toEqual([
      [10, 20],
      [49, 59],
      [60, 90],
    ]);
    level.undo();
    level.change('Move', moveHold('solution', 1, -1000, { ripple: true }));
    expect(holds(level)).toEqual([
      [10, 20],
      [21, 31],
      [51, 81],
    ]);
    level.undo();
    level.change('Stretch', stretchHold('solution', 0, 'release', 25, { ripple: true }));
    expect(holds(level)).toEqual([
      [10, 25],
      [35, 45],
      [65, 95],
    ]);
    level.undo();
    level.change('Stretch', stretchHold('solution', 0, 'release', 500));
    expect(holds(level)).toEqual([
      [10, 29],
      [30, 40],
      [60, 90],
    ]);
  });

  it('are split by a release of one tick, but not where nothing would be left', () => {
    const level = open();
    level.change('Split', splitHold('solution', 2, 70));
    expect(holds(level)).toEqual([
      [10, 20],
      [30, 40],
      [60, 70],
      [71, 90],
    ]);
    for (const tick of [10, 19, 20]) level.change('Split', splitHold('solution', 0, tick));
    expect(holds(level)).toHaveLength(4);
  });

  it('close the gap with Alt if one is removed', () => {
    const level = open();
    level.change('Delete', deleteHolds('solution', [1], { ripple: true }));
    expect(holds(level)).toEqual([
      [10, 20],
      [50, 80],
    ]);
  });

  it('are sorted by time and joined where they overlap, whatever their order in the file', () => {
    const level = open({
      runs: [
        {
          name: 'solution',
          holds: [
            [50, 60],
            [0, 10],
            [5, 20],
          ],
        },
      ],
    });
    expect(holdsOf(level.file(), 'solution')).toEqual([
      [0, 20],
      [50, 60],
    ]);
    level.change('Move', moveHold('solution', 1, 5));
    expect(holds(level)).toEqual([
      [0, 20],
      [55, 65],
    ]);
  });

  it('are deselected when they vanish', () => {
    const level = open();
    const selection = createSelection(level);
    selection.selectHolds('solution', [0, 2]);
    level.change('Delete', deleteHolds('solution', [1]));
    expect(selection.store.getState().holds).toEqual([0]);
    level.change('Delete', deleteRun('solution'));
    expect(selection.store.getState()).toMatchObject({ holds: [], run: null });
  });
});
