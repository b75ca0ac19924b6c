import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createAttemptKeeper } from '../../editor/core/attempts/attempt-keeper.ts';
import { type AttemptStore, createMemoryAttempts } from '../../editor/core/attempts/attempt-store.ts';
import { type Attempt, attemptsAt, createAttempts } from '../../editor/core/attempts/attempts.ts';
import { createBrowserStorage, createWorkspace, type LevelStorage, type OpenedLevel } from '../../editor/core/files/index.ts';
import { createJournal, createMemoryStore } from '../../editor/core/journal/index.ts';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import '../fast-check.ts';
import { breathe, createChannels, createKeyValues, createLine, LockKeeper, passingVersions, TurnedClock } from './stage.ts';

const fileOf = (name: string): LevelFile => ({ version: 1, name, astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } });

/** An attempt that can be told from others by its tick. */
const attemptOf = (tick: number): Omit<Attempt, 'id' | 'number'> => ({
  holds: [[0, tick]],
  end: { outcome: 'lost', with: null, time: tick / 60, tick },
  tick,
  minerals: 0,
  accuracy: 'precise',
  points: Float32Array.of(0, tick),
  played: { bytes: Uint8Array.of(tick % 256), hash: '', file: fileOf('played'), rules: {} },
});
/** Nothing is tried again by itself. */
const never = () => () => {};
const ticksOf = (attempts: readonly Attempt[]) => attempts.map(({ tick }) => tick);

describe('attempts of earlier pages', () => {
  it('are there again, before those of this page, and numbers go on', async () => {
    const store = createMemoryAttempts();
    const first = createAttempts();
    createAttemptKeeper(store, never).follow('f/a', first);
    for (const tick of [10, 20, 30]) first.add(attemptOf(tick));
    first.remove(2);
    await breathe();
    const second = createAttempts();
    createAttemptKeeper(store, never).follow('f/a', second);
    // before the list is read
    second.add(attemptOf(40));
    await breathe();
    expect(second.store.getState().map(({ number, tick }) => [number, tick])).toEqual([
      [1, 10],
      [3, 30],
      [4, 40],
    ]);
    expect(second.add(attemptOf(50)).number).toBe(5);
    await breathe();
    const third = createAttempts();
    createAttemptKeeper(store, never).follow('f/a', third);
    await breathe();
    expect(ticksOf(third.store.getState())).toEqual([10, 30, 40, 50]);
    expect(third.store.getState()[0]).toEqual(first.store.getState()[0]);
  });

  it('of two pages at once are all there, though they have the same numbers', async () => {
    const store = createMemoryAttempts();
    for (const tick of [1, 2]) {
      const attempts = createAttempts();
      createAttemptKeeper(store, never).follow('f/a', attempts);
      attempts.add(attemptOf(tick));
    }
    await breathe();
    const next = createAttempts();
    createAttemptKeeper(store, never).follow('f/a', next);
    await breathe();
    expect(new Set(ticksOf(next.store.getState()))).toEqual(new Set([1, 2]));
    expect(next.store.getState().map(({ number }) => number)).toEqual([1, 2]);
  });

  it('stay in the page, with the reason, while they can not be kept, and are kept with the next one that can', async () => {
    const memory = createMemoryAttempts();
    let isFull = true;
    const store: AttemptStore = {
      ...memory,
      put: (list, attempts) =>
        isFull ? Promise.reject(new DOMException('full', 'QuotaExceededError')) : memory.put(list, attempts),
    };
    const keeper = createAttemptKeeper(store, never);
    const attempts = createAttempts();
    keeper.follow('f/a', attempts);
    attempts.add(attemptOf(1));
    await breathe();
    expect(keeper.trouble.getState()).toMatch(/no room left/);
    expect(ticksOf(attempts.store.getState())).toEqual([1]);
    isFull = false;
    attempts.add(attemptOf(2));
    await breathe();
    expect(keeper.trouble.getState()).toBeNull();
    const next = createAttempts();
    createAttemptKeeper(store, never).follow('f/a', next);
    await breathe();
    expect(ticksOf(next.store.getState())).toEqual([1, 2]);
  });

  it('made without a database say so, and are kept once it answers after all, also of a level that was renamed', async () => {
    const keeper = createAttemptKeeper(null, never);
    expect(keeper.trouble.getState()).toMatch(/last as long as this page/);
    const attempts = createAttempts();
    keeper.follow('f/a', attempts);
    attempts.add(attemptOf(1));
    keeper.moved([{ from: 'f/a', to: 'f/b', token: 'a to b' }]);
    await breathe();
    const late = createMemoryAttempts();
    keeper.adopt(late);
    await breathe();
    expect(keeper.trouble.getState()).toBeNull();
    const next = createAttempts();
    createAttemptKeeper(late, never).follow('f/b', next);
    await breathe();
    expect(ticksOf(next.store.getState())).toEqual([1]);
  });
});

it('an attempt that ends after its level was closed is kept at its level', async () => {
  const store = createMemoryAttempts();
  const keeper = createAttemptKeeper(store, never);
  const [one, other] = [createAttempts(), createAttempts()];
  keeper.follow('f/a', one);
  keeper.follow('f/b', other);
  one.add(attemptOf(1));
  await breathe();
  const next = createAttempts();
  createAttemptKeeper(store, never).follow('f/a', next);
  await breathe();
  expect(ticksOf(next.store.getState())).toEqual([1]);
});

describe('whatever is done, in any order', () => {
  const level = fc.constantFrom('a', 'b', 'c');
  const page = fc.nat(1);
  const act = fc.oneof(
    { weight: 6, arbitrary: fc.record({ what: fc.constant('record' as const), level, page }) },
    {
      weight: 6,
      arbitrary: fc.record({
        what: fc.constantFrom(
          ...(['discard', 'open', 'rename', 'swap', 'delete', 'restore', 'change', 'reload', 'fail', 'mend', 'rest'] as const),
        ),
        level,
        page,
      }),
    },
  );

  it('each attempt that was not discarded is at its level, in a new page', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(act, { minLength: 5, maxLength: 30 }), async (acts) => {
        const disk: LevelStorage = createBrowserStorage(createKeyValues(), null, () => 0);
        for (const name of ['a', 'b', 'c']) await disk.write(name, formatLevel(fileOf(name)), null);
        const [clock, locks, channel, journal] = [new TurnedClock(), new LockKeeper(), createChannels(), createMemoryStore()];
        const memory = createMemoryAttempts();
        let isFailing = false;
        const may = <T>(act: () => Promise<T>): Promise<T> => (isFailing ? Promise.reject(new Error('it fails')) : act());
        const store: AttemptStore = {
          ...memory,
          put: (list, attempts) => may(() => memory.put(list, attempts)),
        };
        let pages = 0;
        const begin = async () => {
          const workspace = createWorkspace({
            ...{ storage: createLine(disk), journal: createJournal(journal, () => 0), versions: passingVersions() },
            ...{ timers: clock, channel, locks: locks.of(`page ${pages++}`) },
          });
          const keeper = createAttemptKeeper(store, (ms, call) => clock.after(ms, call));
          workspace.onMoved(keeper.moved);
          let last: OpenedLevel | null = null;
          // as the page does it
          workspace.store.subscribe(({ opened, list }) => {
            if (opened === last) return;
            last = opened;
            if (opened !== null) keeper.follow(`${list?.folder.id}/${opened.id()}`, attemptsAt(opened.level));
          });
          await workspace.start();
          return { workspace, keeper };
        };
        const both = [await begin(), await begin()];
        /** What must be there, by the name of the level, which stays with it. */
        const wanted = new Map<string, Set<number>>([
          ['a', new Set()],
          ['b', new Set()],
          ['c', new Set()],
        ]);
        const entryOf = async (name: string) => {
          const list = await disk.list();
          return list.ok ? list.value.levels.find((one) => one.name === name) : undefined;
        };
        const open = async ({ workspace }: (typeof both)[number], name: string) => {
          const entry = await entryOf(name);
          if (entry === undefined) return null;
          await workspace.refresh();
          if (workspace.store.getState().opened?.id() !== entry.id) await workspace.open(entry.id);
          await breathe();
          return workspace.store.getState().opened;
        };
        let tick = 0;
        for (const { what, level: name, page: nth } of acts) {
          const one = both[nth];
          const { workspace } = one;
          // pages are told of moves by others; here, only one page moves levels
          const mover = both[0].workspace;
          const entry = await entryOf(name);
          if (what === 'record') {
            const opened = await open(one, name);
            if (opened === null) continue;
            attemptsAt(opened.level).add(attemptOf(++tick));
            wanted.get(name)?.add(tick);
          } else if (what === 'discard') {
            const opened = workspace.store.getState().opened;
            const first = opened === null ? undefined : attemptsAt(opened.level).store.getState()[0];
            if (opened === null || first === undefined || isFailing) continue;
            attemptsAt(opened.level).remove(first.number);
            wanted.get(opened.level.file().name)?.delete(first.tick);
            // another page may have it still, and keeps it then
            await both[1 - nth].workspace.leave();
            both[1 - nth] = await begin();
          } else if (what === 'open') await open(one, name);
          else if (what === 'rename' && entry !== undefined) {
            await mover.refresh();
            await mover.rename(entry, `${name}${++tick}`);
            await both[1].workspace.leave();
          } else if (what === 'delete' && entry !== undefined) {
            await mover.refresh();
            await mover.remove(entry);
            await both[1].workspace.leave();
          } else if (what === 'restore') {
            const trash = await disk.trash();
            const found = trash.ok ? trash.value[0] : undefined;
            if (found !== undefined) await mover.restore(found.trash, `restored${++tick}`);
          } else if (what === 'swap') {
            const list = await disk.list();
            if (list.ok) await mover.order('', [...list.value.levels.map(({ id }) => id)].reverse());
          } else if (what === 'change' && entry !== undefined) {
            // by another program: the level is another document when it is opened again
            const file = { ...fileOf(name), description: `changed ${++tick}` };
            await disk.write(entry.id, formatLevel(file), entry.etag);
          } else if (what === 'reload' && !isFailing) {
            await breathe();
            await workspace.close();
            both[nth] = await begin();
          } else if (what === 'fail') isFailing = true;
          else if (what === 'mend') isFailing = false;
          await breathe();
        }
        isFailing = false;
        // what could not be kept is tried again
        await clock.pass(60_000);
        for (const one of both) await one.workspace.leave();
        await breathe();
        for (;;) {
          const trash = await disk.trash();
          const found = trash.ok ? trash.value[0] : undefined;
          if (found === undefined) break;
          await both[0].workspace.restore(found.trash, `back${++tick}`);
        }
        const next = await begin();
        for (const [name, ticks] of wanted) {
          const opened = await open(next, name);
          if (opened === null) throw new Error(`${name} is gone`);
          await breathe();
          expect([name, new Set(ticksOf(attemptsAt(opened.level).store.getState()))]).toEqual([name, ticks]);
        }
      }),
      { numRuns: 60 },
    );
  });
});
