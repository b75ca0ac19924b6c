import { readdirSync, readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { moveObjects, type ObjectKey, objectsOf, replaceHolds, setLevelProperty } from '../../editor/core/document/index.ts';
import { aliveInWords } from '../../editor/features/alive/index.ts';
import { formatLevel, type LevelFile, readLevel, withIds } from '../../schema/index.ts';
import '../fast-check.ts';
import { describeQuick, itQuick } from '../depth.ts';
import { aliveStage, outcomeOf } from './alive-stage.ts';

const LEVELS = new URL('../../levels/', import.meta.url);
const SLUGS = readdirSync(LEVELS).filter((file) => file.endsWith('.level.json'));

/** A shipped level as the editor opens it. */
function shipped(name: string): LevelFile {
  const reading = readLevel(readFileSync(new URL(name, LEVELS)));
  if (!reading.ok) throw new Error(name);
  return withIds(reading.document.file);
}

/** Three swings, whose run a shift of its second asteroid by 8 px breaks. */
const SWINGS = shipped('15-three-swings.level.json');
const [RUN] = (SWINGS.runs ?? []).map(({ name }) => name);
const SECOND = SWINGS.asteroids?.[1].id ?? '';
const broken = () => moveObjects([SECOND], 8, 8);

describe('a run that is kept alive', () => {
  itQuick('completes the level that a drag has broken, and one undo takes back both', async () => {
    const { document, proof, store, work, settle } = aliveStage(SWINGS);
    const before = formatLevel(document.file());
    const drag = document.begin('Move');
    drag.set(broken());
    expect(proof.proof().run.outcome).not.toBe('completed');
    expect(store.getState()).toEqual({ kind: 'working' });
    await work();
    expect(proof.proof().run.outcome).toBe('completed');
    expect(store.getState()).toMatchObject({ kind: 'alive', isFinal: false });
    drag.commit();
    await settle();
    expect(store.getState()).toMatchObject({ kind: 'alive', isFinal: true, lost: 0, others: { complete: 2, of: 2 } });
    expect(aliveInWords(store.getState())).toMatch(
      /^kept alive: (1 edge moved by|\d+ edges moved, at most) \d+ ticks?; certified /,
    );
    expect(outcomeOf(document.file(), RUN)).toBe('completed');
    expect(document.labels()).toEqual(['Move']);
    document.undo();
    expect(formatLevel(document.file())).toBe(before);
    expect(store.getState()).toEqual({ kind: 'idle' });
    document.redo();
    expect(outcomeOf(document.file(), RUN)).toBe('completed');
  });

  itQuick('is as it was when the drag is taken back, or comes back to where it began', async () => {
    const { document, store, work } = aliveStage(SWINGS);
    const before = document.file();
    const drag = document.begin('Move');
    drag.set(broken());
    await work();
    drag.set(moveObjects([SECOND], 1, 0));
    while (await work());
    expect(document.file().runs).toEqual(before.runs);
    expect(store.getState()).toEqual({ kind: 'idle' });
    drag.set(broken());
    await work();
    drag.cancel();
    expect(document.file()).toEqual(before);
    expect(store.getState()).toEqual({ kind: 'idle' });
    expect(await work()).toBe(false);
  });

  it('is sought again from what worked, where the answer comes too late for the place', async () => {
    const { document, work, asked, proof } = aliveStage(SWINGS);
    const drag = document.begin('Move');
    drag.set(broken());
    expect(asked().map(({ warm }) => warm)).toEqual([null]);
    drag.set(moveObjects([SECOND], 24, 24));
    expect(asked()).toHaveLength(1);
    await work();
    const again = asked();
    expect(again).toHaveLength(1);
    expect(again[0].level.asteroids[1].x).toBe((SWINGS.asteroids?.[1].x ?? 0) + 24);
    expect(again[0].warm).not.toBeNull();
    await work();
    const { run } = proof.proof();
    // whatever is shown is true of the level as it is
    expect(run.outcome).toBe(outcomeOf(document.file(), RUN));
  });

  itQuick('is kept by a single change, too, and by the next of keys held down, in one step', async () => {
    const { document, settle } = aliveStage(SWINGS);
    const before = formatLevel(document.file());
    for (let i = 0; i < 4; i++) {
      document.change('Move', moveObjects([SECOND], 2, 2), { gesture: 'keys' });
      await settle();
      expect(outcomeOf(document.file(), RUN)).toBe('completed');
    }
    expect(document.labels()).toEqual(['Move']);
    document.undo();
    expect(formatLevel(document.file())).toBe(before);
  });

  it('is not touched when something else was done before it was found', async () => {
    const others: ((document: ReturnType<typeof aliveStage>['document']) => void)[] = [
      (document) => void document.change('Rename', setLevelProperty('name', 'other')),
      (document) => void document.undo(),
      (document) => void document.change('Holds', replaceHolds(RUN, [[1, 2]])),
      (document) => void document.replace('From disk', { ...document.file(), description: 'other' }),
    ];
    for (const other of others) {
      const { document, work, rest, jobs } = aliveStage(SWINGS);
      document.change('Move', broken());
      expect(jobs()).toBe(1);
      other(document);
      const after = document.file();
      while (await work());
      await rest();
      while (await work());
      expect(document.file()).toBe(after);
    }
  });

  it('waits for a click that changes nothing', async () => {
    const { document, work, settle } = aliveStage(SWINGS);
    document.change('Move', broken());
    const click = document.begin('Move');
    const before = document.file();
    await work();
    expect(document.file()).toBe(before);
    click.cancel();
    await settle();
    expect(outcomeOf(document.file(), RUN)).toBe('completed');
    expect(document.labels()).toEqual(['Move']);
  });

  it('is left to the user who edits its holds, and is not sought while it is turned off', async () => {
    const { document, settings, jobs, store } = aliveStage(SWINGS);
    document.change('Holds', replaceHolds(RUN, [[1, 2]]));
    expect([jobs(), store.getState().kind]).toEqual([0, 'idle']);
    document.undo();
    const both = document.begin('Both');
    both.set((draft) => {
      broken()(draft);
      replaceHolds(RUN, [[1, 2]])(draft);
    });
    expect(jobs()).toBe(0);
    both.cancel();
    settings.setState({ keepAlive: false });
    document.change('Move', broken());
    expect([jobs(), store.getState().kind]).toEqual([0, 'idle']);
  });

  it('that failed before is left alone', () => {
    const { document, jobs } = aliveStage({ ...SWINGS, runs: [{ name: 'fails', holds: [[0, 1]] }] });
    document.change('Move', broken());
    expect(jobs()).toBe(0);
  });

  itQuick('says so where no shift within the limit completes the level', async () => {
    const { document, store, settle } = aliveStage(SWINGS);
    document.change('Move', moveObjects(['@blackHole'], 4000, 4000));
    await settle();
    const state = store.getState();
    expect(state).toMatchObject({ kind: 'failed', within: 90, isFinal: true });
    expect(aliveInWords(state)).toMatch(/within 90 ticks of the old holds/);
    expect(outcomeOf(document.file(), RUN)).not.toBe('completed');
    expect(document.file().runs).toEqual(SWINGS.runs);
  });

  it('follows a change of the rules', async () => {
    const { document, settle, proof } = aliveStage(SWINGS);
    document.change('Pull', (draft) => {
      draft.rules = { pull: 44 };
    });
    expect(proof.proof().run.outcome).not.toBe('completed');
    await settle();
    expect(outcomeOf(document.file(), RUN)).toBe('completed');
  });
});

/** A swing whose run the recoil carries past an alien; no shift of its holds helps once its asteroid is 30 px higher. */
const KICKBACK: LevelFile = withIds({
  version: 1,
  name: 'Kickback',
  astronaut: { x: 320, y: 360 },
  blackHole: { x: 640, y: 360 },
  recoil: true,
  asteroids: [
    { id: 'o06tc5', x: 480, y: 360, radius: 16 },
    { id: 'jz3o2j', x: 600, y: 440, radius: 16 },
  ],
  aliens: [{ id: 'e7uie0', x: 560, y: 288 }],
  // holds that touch: joined, they are [0, 132]
  runs: [
    {
      name: 'solution',
      holds: [
        [0, 60],
        [60, 132],
      ],
    },
  ],
});
const up = (by: number) => moveObjects(['o06tc5'], 0, -by);

describeQuick('a run that can not be kept alive', () => {
  it('has the holds of its author after a drag that had found others on the way', async () => {
    const { document, store, work, settle, proof } = aliveStage(KICKBACK);
    const drag = document.begin('Move');
    const found = new Set<string>();
    for (let by = 1; by <= 30; by++) {
      drag.set(up(by));
      while (await work());
      found.add(proof.proof().run.holds.join());
    }
    expect(found.size).toBeGreaterThan(1);
    drag.commit();
    // before the last search as well as after it
    expect(document.file().runs).toEqual(KICKBACK.runs);
    await settle();
    expect(store.getState()).toMatchObject({ kind: 'failed', isFinal: true });
    expect(document.file().runs).toEqual(KICKBACK.runs);
    expect(document.labels()).toEqual(['Move']);
  });

  it('has them after keys held down, a worker that died, and when it is turned off or left in a drag', async () => {
    const ends: ((stage: ReturnType<typeof aliveStage>) => void)[] = [
      ({ die }) => die(),
      ({ settings }) => settings.setState({ keepAlive: false }),
      ({ stop }) => stop(),
      ({ document }) => void document.change('Rename', setLevelProperty('name', 'other')),
    ];
    for (const end of ends) {
      for (const isDrag of [false, true]) {
        const stage = aliveStage(KICKBACK);
        const { document, work, proof } = stage;
        const drag = isDrag ? document.begin('Move') : null;
        const move = (by: number) =>
          drag === null ? document.change('Move', moveObjects(['o06tc5'], 0, -by), { gesture: 'keys' }) : drag.set(up(by));
        move(5);
        while (await work());
        expect(proof.proof().run.outcome).toBe('completed');
        expect(document.file().runs).not.toEqual(KICKBACK.runs);
        move(isDrag ? 30 : 25);
        end(stage);
        drag?.commit();
        expect(document.file().runs).toEqual(KICKBACK.runs);
      }
    }
  });
});

const step = fc.integer({ min: -12, max: 12 });
const path = fc.array(fc.tuple(step, step, fc.boolean()), { minLength: 1, maxLength: 6 });

describe('any drag of any object of the shipped levels', () => {
  it('keeps the run alive wherever it says so, and one undo gives the former file', async () => {
    await fc.assert(
      fc.asyncProperty(fc.constantFrom(...SLUGS), fc.nat(40), path, fc.boolean(), async (name, nth, moves, isLate) => {
        const { document, store, work, settle, stop, proof } = aliveStage(shipped(name));
        const before = formatLevel(document.file());
        const keys: ObjectKey[] = [...objectsOf(document.file()).keys()];
        const key = keys[nth % keys.length];
        const run = proof.proof().run.name ?? '';
        const drag = document.begin('Move');
        let [x, y] = [0, 0];
        for (const [dx, dy, works] of moves) {
          x += dx;
          y += dy;
          drag.set(moveObjects([key], x, y));
          if (works) await work();
          if (store.getState().kind === 'alive') expect(outcomeOf(document.file(), run)).toBe('completed');
        }
        if (!isLate) while (await work());
        drag.commit();
        await settle();
        const state = store.getState();
        if (state.kind === 'alive') expect(outcomeOf(document.file(), run)).toBe('completed');
        if (state.kind === 'failed') expect(outcomeOf(document.file(), run)).not.toBe('completed');
        if ((state.kind === 'alive' || state.kind === 'failed' || state.kind === 'others') && state.others !== null) {
          const complete = (document.file().runs ?? []).filter((one) => outcomeOf(document.file(), one.name) === 'completed');
          expect(state.others.complete).toBe(complete.length);
        }
        expect(document.labels().length).toBeLessThanOrEqual(1);
        document.undo();
        expect(formatLevel(document.file())).toBe(before);
        stop();
      }),
      { numRuns: 40 },
    );
  });
});

describe('whatever is done, in any order', () => {
  const FILES = [KICKBACK, SWINGS];
  const act = fc.oneof(
    fc.record({ kind: fc.constant('drag'), x: step, y: fc.integer({ min: -40, max: 40 }) }),
    fc.record({ kind: fc.constant('nudge'), x: step, y: step }),
    fc.record({ kind: fc.constantFrom('work', 'work', 'drop', 'cancel', 'rest', 'die', 'undo', 'redo', 'toggle', 'rename') }),
  );

  it('a step leaves each run as it was, or completes the level with it', async () => {
    await fc.assert(
      fc.asyncProperty(fc.nat(1), fc.nat(3), fc.array(act, { minLength: 4, maxLength: 14 }), async (which, nth, acts) => {
        const stage = aliveStage(FILES[which]);
        const { document, settings } = stage;
        const keys: ObjectKey[] = [...objectsOf(document.file()).keys()];
        const key = keys[nth % keys.length];
        let drag: ReturnType<typeof document.begin> | null = null;
        /** The level before the last step; null if that was undone or redone. */
        const last: { start: LevelFile | null } = { start: null };
        document.onStep((event) => {
          last.start = event.kind === 'change' ? event.start : null;
        });
        for (const one of acts) {
          if (one.kind === 'drag' && 'x' in one) {
            if (drag?.isLive !== true) drag = document.begin('Move');
            drag.set(moveObjects([key], one.x, one.y));
          } else if (one.kind === 'nudge' && 'x' in one)
            document.change('Move', moveObjects([key], one.x, one.y), { gesture: 'keys' });
          else if (one.kind === 'work') await stage.work();
          else if (one.kind === 'drop') drag?.commit();
          else if (one.kind === 'cancel') drag?.cancel();
          else if (one.kind === 'rest') await stage.rest();
          else if (one.kind === 'die') await stage.die();
          else if (one.kind === 'undo') document.undo();
          else if (one.kind === 'redo') document.redo();
          else if (one.kind === 'toggle') settings.setState({ keepAlive: !settings.getState().keepAlive });
          else document.change('Rename', setLevelProperty('name', `${document.labels().length}`));
          const { start } = last;
          if (start === null) continue;
          const now = document.committedFile();
          for (const run of now.runs ?? []) {
            const former = start.runs?.find(({ name }) => name === run.name);
            if (JSON.stringify(run) !== JSON.stringify(former)) expect(outcomeOf(now, run.name)).toBe('completed');
          }
        }
        stage.stop();
      }),
      { numRuns: 60 },
    );
  });
});
