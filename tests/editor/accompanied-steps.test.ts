import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  ASTRONAUT,
  applyPatches,
  createEditedLevel,
  type DocumentEvent,
  type EditedLevel,
  type Gesture,
  moveObjects,
  replaceHolds,
  type StepMark,
  setLevelProperty,
} from '../../editor/core/document/index.ts';
import { createJournal } from '../../editor/core/journal/index.ts';
import { createMemoryStore } from '../../editor/core/journal/journal-store.ts';
import type { Hold, LevelFile } from '../../schema/index.ts';
import '../fast-check.ts';

const PLAIN: LevelFile = {
  version: 1,
  name: 'plain',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 300, y: 0 },
  asteroids: [{ id: 'aa', x: 50, y: 50, radius: 16 }],
  runs: [{ name: 'run', holds: [[10, 20]] }],
};

const holding = (press: number, release: number) => replaceHolds('run', [[press, release]]);
const moved = (by: number) => moveObjects(['aa'], by, 0);
const holdsOf = (level: EditedLevel): readonly Hold[] => level.file().runs?.[0].holds ?? [];

describe('what a gesture changes besides', () => {
  it('stays while the gesture goes on, is replaced by another one, and goes with the gesture', () => {
    const level = createEditedLevel(PLAIN);
    const drag = level.begin('Move');
    expect(level.gesture()).toBe(drag);
    drag.set(moved(5));
    drag.also(holding(11, 21));
    drag.set(moved(9));
    expect([level.file().asteroids?.[0].x, holdsOf(level)]).toEqual([59, [[11, 21]]]);
    drag.also(holding(12, 22));
    expect([level.file().asteroids?.[0].x, holdsOf(level)]).toEqual([59, [[12, 22]]]);
    drag.also(null);
    expect([level.file().asteroids?.[0].x, holdsOf(level)]).toEqual([59, [[10, 20]]]);
    drag.also(holding(12, 22));
    drag.cancel();
    expect(level.file()).toEqual(PLAIN);
    expect(level.gesture()).toBeNull();
    expect(drag.also(holding(1, 2))).toEqual({ ok: true, added: [] });
    expect(level.file()).toEqual(PLAIN);
  });

  it('is one step together with the gesture', () => {
    const level = createEditedLevel(PLAIN);
    const drag = level.begin('Move');
    drag.set(moved(5));
    drag.also(holding(11, 21));
    drag.commit();
    const after = level.file();
    expect(level.labels()).toEqual(['Move']);
    level.undo();
    expect(level.file()).toEqual(PLAIN);
    level.redo();
    expect(level.file()).toEqual(after);
  });

  it('changes nothing where it is refused', () => {
    const level = createEditedLevel(PLAIN);
    const drag = level.begin('Move');
    drag.set(moved(5));
    expect(drag.also((draft) => void Object.assign(draft, { nonsense: 1 })).ok).toBe(false);
    drag.set(moved(6));
    expect(level.file().asteroids?.[0].x).toBe(56);
  });
});

describe('a step that is extended afterwards', () => {
  it('is refused after another step, an undo, a change on disk, and while a gesture is in progress', () => {
    const others: ((level: EditedLevel) => void)[] = [
      (level) => void level.change('other', moved(1)),
      (level) => void level.replace('other', { ...level.file(), name: 'other' }),
      (level) => void (level.undo() && level.redo()),
      (level) => void level.undo(),
      (level) => void level.begin('other'),
      (level) => {
        const drag = level.begin('other');
        drag.set(moved(3));
        drag.commit();
      },
    ];
    for (const other of others) {
      const level = createEditedLevel(PLAIN);
      level.change('Move', moved(5));
      const step = level.lastStep() as StepMark;
      other(level);
      const { file, steps } = level.store.getState();
      expect(level.amend(step, holding(1, 2)).ok).toBe(false);
      expect(level.store.getState()).toMatchObject({ file, steps });
    }
  });

  it('may be extended after a gesture that changed nothing', () => {
    const level = createEditedLevel(PLAIN);
    level.change('Move', moved(5));
    const step = level.lastStep() as StepMark;
    level.begin('Click').cancel();
    expect(level.amend(step, holding(1, 2)).ok).toBe(true);
    level.undo();
    expect(level.file()).toEqual(PLAIN);
  });

  it('stays one step while keys are held down', () => {
    const level = createEditedLevel(PLAIN);
    level.change('Move', moved(1), { gesture: 'keys' });
    level.amend(level.lastStep() as StepMark, holding(11, 21));
    level.change('Move', moved(1), { gesture: 'keys' });
    expect([level.file().asteroids?.[0].x, holdsOf(level), level.labels()]).toEqual([52, [[11, 21]], ['Move']]);
    level.undo();
    expect(level.file()).toEqual(PLAIN);
  });

  it('says where its step began', () => {
    const level = createEditedLevel(PLAIN);
    const seen: DocumentEvent[] = [];
    level.subscribe((event) => seen.push(event));
    level.change('Move', moved(1), { gesture: 'keys' });
    level.change('Move', moved(1), { gesture: 'keys' });
    level.amend(level.lastStep() as StepMark, holding(11, 21));
    expect(seen.map(({ start }) => start.asteroids?.[0].x)).toEqual([50, 50, 50]);
    expect(seen.map(({ before }) => before.asteroids?.[0].x)).toEqual([50, 51, 52]);
    expect(seen.map(({ how }) => how)).toEqual(['edited', 'edited', 'amended']);
  });
});

/** What is done to a level and to the model of it: a list of the files at the ends of steps. */
type Act = (level: EditedLevel, model: Model) => void;

class Model {
  files: LevelFile[];
  done = 0;
  step: StepMark | null = null;
  drag: Gesture | null = null;

  constructor(file: LevelFile) {
    this.files = [file];
  }

  /** The level was changed in a step of its own. */
  stepped(level: EditedLevel): void {
    this.files = [...this.files.slice(0, this.done + 1), level.file()];
    this.done++;
  }

  /** A gesture in progress ends: it is a step if it has changed something. */
  ended(level: EditedLevel): void {
    this.drag = null;
    if (level.store.getState().done > this.done) this.stepped(level);
  }
}

const by = fc.integer({ min: -9, max: 9 });
const tick = fc.integer({ min: 0, max: 60 });
const anyAct: fc.Arbitrary<Act> = fc.oneof(
  by.map(
    (dx): Act =>
      (level, model) => {
        if (model.drag !== null) {
          level.seal();
          model.ended(level);
        }
        level.change('Move', moveObjects([ASTRONAUT, 'aa'], dx, 1));
        model.stepped(level);
      },
  ),
  fc.constant<Act>((level, model) => {
    if (model.drag === null) model.drag = level.begin('Drag');
  }),
  by.map(
    (dx): Act =>
      (_, { drag }) =>
        void drag?.set(moved(dx)),
  ),
  fc.tuple(tick, tick).map(
    ([a, b]): Act =>
      (_, { drag }) =>
        void drag?.also(a === b ? null : holding(Math.min(a, b), Math.max(a, b))),
  ),
  fc.constant<Act>((level, model) => {
    model.drag?.commit();
    model.ended(level);
  }),
  fc.constant<Act>((level, model) => {
    model.drag?.cancel();
    model.drag = null;
    expect(level.file()).toEqual(model.files[model.done]);
  }),
  fc.constant<Act>((level, model) => {
    model.step = level.lastStep();
  }),
  fc.tuple(tick, fc.integer({ min: 1, max: 30 })).map(
    ([press, length]): Act =>
      (level, model) => {
        if (model.step === null) return;
        const { file, steps, done } = level.store.getState();
        const isLast = model.drag === null && level.lastStep() === model.step;
        expect(level.amend(model.step, holding(press, press + length)).ok).toBe(isLast);
        expect(level.store.getState()).toMatchObject({ steps, done });
        if (isLast) model.files[model.done] = level.file();
        else expect(level.file()).toBe(file);
      },
  ),
  fc.constant<Act>((level, model) => {
    if (model.drag !== null) {
      level.seal();
      model.ended(level);
    }
    if (level.undo()) model.done--;
    expect(level.file()).toEqual(model.files[model.done]);
  }),
  fc.constant<Act>((level, model) => {
    if (model.drag !== null) {
      level.seal();
      model.ended(level);
    }
    if (level.redo()) model.done++;
    expect(level.file()).toEqual(model.files[model.done]);
  }),
  fc.constantFrom('a', 'b').map(
    (name): Act =>
      (level, model) => {
        if (model.drag !== null) {
          level.seal();
          model.ended(level);
        }
        const { steps, done, file } = level.store.getState();
        level.change('Rename', setLevelProperty('name', name));
        const now = level.store.getState();
        if (now.file !== file || now.steps !== steps || now.done !== done) model.stepped(level);
      },
  ),
);

describe('any history of gestures, extended steps, undo and redo', () => {
  it('comes back to exactly the former files, and what is kept of it leads to the same file', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(anyAct, { maxLength: 30 }), async (acts) => {
        const level = createEditedLevel(PLAIN);
        const model = new Model(level.file());
        const kept: DocumentEvent[] = [];
        level.onStep((event) => kept.push(event));
        const journal = createJournal(createMemoryStore(), () => 0);
        const disk = level.file();
        const keeping = journal.follow('here', level, { file: disk, etag: null });
        for (const act of acts) act(level, model);
        if (model.drag !== null) {
          level.seal();
          model.ended(level);
        }
        expect(level.store.getState().done).toBe(model.done);
        expect(level.file()).toEqual(model.files[model.done]);
        expect(kept.reduce((file, { patches }) => applyPatches(file, patches), disk)).toEqual(level.file());
        expect((kept.at(-1)?.file ?? disk) as LevelFile).toEqual(level.file());
        await keeping.settled();
        const recovered = await journal.recover('here');
        expect(recovered?.file ?? disk).toEqual(level.file());
        const steps = level.store.getState().steps;
        expect(model.files).toHaveLength(steps + 1);
        for (let done = steps; done >= 0; done--) {
          level.goTo(done);
          expect(level.file()).toEqual(model.files[done]);
        }
        level.goTo(steps);
        expect(level.file()).toEqual(model.files[steps]);
      }),
      { numRuns: 300 },
    );
  });
});
