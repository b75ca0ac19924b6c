import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createEditedLevel, type EditedLevel, moveObjects } from '../../editor/core/document/index.ts';
import { createMemoryVersions, type Version, type VersionStore } from '../../editor/core/versions/index.ts';
import { deltaBetween, fromStored, toStored, withDelta } from '../../editor/core/versions/stored-text.ts';
import { STAGES, thin } from '../../editor/core/versions/thinning.ts';
import { checkOf } from '../../editor/core/versions/version.ts';
import { movedHeads } from '../../editor/core/versions/version-store.ts';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { itDeep, itQuick } from '../depth.ts';
import { apply, arbitraryEdits } from '../review/arbitrary-edits.ts';
import { arbitraryFile } from './arbitrary-file.ts';
import { breathe, FILE, passingVersions } from './stage.ts';

const line = fc.constantFrom('a', 'b', 'c', '', '  { "x": 1 },', '  { "x": 2 },', '"é"', '\r');
const text = fc.oneof(
  fc.array(line, { maxLength: 12 }).map((lines) => lines.join('\n')),
  fc.string(),
);

describe('the delta of two texts', () => {
  it('makes the second text of the first, also as JSON', () => {
    fc.assert(
      fc.property(text, text, (before, after) => {
        expect(withDelta(before, JSON.parse(JSON.stringify(deltaBetween(before, after))))).toBe(after);
      }),
      { numRuns: 2000 },
    );
  });

  it('holds only the lines that differ, wherever they are', () => {
    const lines = Array.from({ length: 1000 }, (_, i) => `line ${i}`);
    const after = lines.flatMap((one, i) => (i === 10 ? ['new', one] : i === 900 ? [] : i === 500 ? ['changed'] : [one]));
    expect(deltaBetween(lines.join('\n'), after.join('\n'))).toEqual([
      [10, 0, 'new'],
      [500, 1, 'changed'],
      [900, 1],
    ]);
    expect(deltaBetween('same', 'same')).toEqual([]);
  });

  it('is refused by a text that it does not fit', () => {
    expect(() => withDelta('a', [[0, 5]])).toThrow(RangeError);
    expect(() =>
      withDelta('a\nb\nc', [
        [2, 1],
        [0, 1],
      ]),
    ).toThrow(RangeError);
  });
});

/** A clock for versions, ms. */
const START = Date.UTC(2026, 10, 27, 12);

interface Begun {
  readonly store: VersionStore;
  readonly level: EditedLevel;
  readonly clock: { now: number };
  readonly versions: ReturnType<ReturnType<typeof passingVersions>['follow']>;
  readonly keeper: ReturnType<typeof passingVersions>;
}

function begin(file: LevelFile = FILE, store: VersionStore = createMemoryVersions()): Begun {
  const clock = { now: START };
  const keeper = passingVersions(store, () => clock.now);
  const level = createEditedLevel(file);
  return { store, level, clock, keeper, versions: keeper.follow('f/07', level) };
}

const listed = async ({ versions }: Begun): Promise<readonly Version[]> => {
  await versions.load();
  return versions.store.getState() ?? [];
};

const move = (dx: number) => moveObjects(['aa'], dx, 0);

describe('the history of a level', () => {
  it('has each version that reached the disk, with the labels of its steps, its time and who wrote it', async () => {
    const all = begin();
    const { level, versions, clock } = all;
    versions.note(level.file(), 'found');
    level.change('Move', move(1));
    level.change('Move again', move(1));
    const sent = level.file();
    level.change('Later', move(1));
    clock.now += 1000;
    versions.note(sent, 'page');
    level.undo();
    clock.now += 1000;
    versions.note(level.file(), 'other');
    const found = await listed(all);
    // after the undo, the text is that of the second version again, so nothing is added
    expect(found).toMatchObject([
      { number: 1, by: 'found', labels: [], time: START, name: null },
      { number: 2, by: 'page', labels: ['Move', 'Move again'], time: START + 1000, changes: 'Asteroid 1 moved 2 px right' },
    ]);
    level.change('More', move(5));
    versions.note(level.file(), 'other');
    expect((await listed(all)).at(-1)).toMatchObject({ number: 3, by: 'other', labels: ['More'] });
  });

  itQuick('takes in thousands of versions at once, each bit for bit, and knows them the second time', async () => {
    const all = begin();
    const text = (x: number) => formatLevel({ ...FILE, blackHole: { ...FILE.blackHole, x } });
    const past = Array.from({ length: 2000 }, (_, i) => ({
      ...{ time: START - 50 * 60_000 + i * 1000, by: 'page' as const, labels: [`Step ${i}`], more: 0, changes: '' },
      ...{ name: i === 100 ? 'Kept' : null, text: text(905 + i) },
    }));
    all.versions.note(all.level.file(), 'found');
    expect(await listed(all)).toHaveLength(1);
    expect(await all.versions.import(past)).toBe(2000);
    const found = await listed(all);
    expect(found).toHaveLength(2001);
    expect(found[100].name).toBe('Kept');
    for (const i of [0, 1, 100, 999, 1999]) expect(await all.versions.text(found[i])).toBe(past[i].text);
    expect(await all.versions.import(past)).toBe(0);
  });

  it('restores every version bit for bit after any edits, undo and redo', async () => {
    await fc.assert(
      fc.asyncProperty(
        arbitraryFile,
        fc.array(arbitraryEdits(3), { maxLength: 30 }),
        fc.array(fc.nat(5)),
        async (file, all, dice) => {
          const begun = begin(file);
          const { level, versions } = begun;
          const texts: string[] = [];
          const note = () => {
            versions.note(level.file(), 'page');
            const now = formatLevel(level.file());
            if (texts.at(-1) !== now) texts.push(now);
          };
          note();
          for (const [i, edits] of all.entries()) {
            const roll = dice[i] ?? 0;
            if (roll === 4) level.undo();
            else if (roll === 5) level.redo();
            else {
              const next = structuredClone(level.file()) as LevelFile;
              for (const edit of edits) apply(next, edit);
              level.replace('Edit', next);
            }
            if (roll !== 3) note();
          }
          note();
          const found = await listed(begun);
          expect(found).toHaveLength(texts.length);
          for (const [i, version] of found.entries()) expect(await versions.text(version)).toBe(texts[i]);
        },
      ),
      { numRuns: 60 },
    );
  });

  itDeep('is small: three hundred moves in a level of a thousand objects take less than thirty times its text', async () => {
    const asteroids = Array.from({ length: 1000 }, (_, i) => ({ id: `a${i}`, x: i, y: 2 * i, radius: 9 }));
    const all = begin({ ...FILE, asteroids });
    const { level, versions } = all;
    for (let i = 0; i < 300; i++) {
      level.change('Move', moveObjects([`a${(i * 37) % 1000}`], 1, 0));
      versions.note(level.file(), 'page');
    }
    const found = await listed(all);
    const size = found.reduce((sum, version) => sum + version.size, 0);
    expect(found).toHaveLength(300);
    expect(size).toBeLessThan(30 * formatLevel(level.file()).length);
  });

  itQuick('loses no other version by one damaged row, and only its own if that held its text alone', async () => {
    const all = begin({ ...FILE, asteroids: Array.from({ length: 40 }, (_, i) => ({ id: `a${i}`, x: i, y: 0, radius: 9 })) });
    const { level, versions, store } = all;
    const texts: string[] = [];
    for (let i = 0; i < 260; i++) {
      if (i > 0) level.change('Move', moveObjects([`a${i % 40}`], i % 7 === 0 ? 900 : 1, 1));
      versions.note(level.file(), 'page');
      texts.push(formatLevel(level.file()));
    }
    const found = await listed(all);
    expect(found).toHaveLength(260);
    const history = await store.open('f/07');
    /** Every row, as it is stored. */
    const rows = await Promise.all(
      found.map(async (version) => ({ version, rows: (await store.texts(history, version)).copies })),
    );
    expect(new Set(found.map(({ base }) => base)).size).toBeGreaterThan(1);
    const damages: ((row: unknown) => unknown)[] = [
      () => undefined,
      () => null,
      () => 'gone',
      (row) => ({ ...(row as object), whole: 'x', hunks: [[0, 1, 'x']] }),
      (row) => ({ ...(row as object), hunks: [[99_999, 3]] }),
      (row) => ({ ...(row as object), hunks: 7 }),
      (row) => {
        const { whole, ...rest } = row as { whole?: string };
        return whole === undefined ? { ...rest, hunks: [] } : { ...rest, whole: `${whole} ` };
      },
    ];
    const byNumber = new Map(rows.map((one) => [one.version.number, one.rows]));
    const readWith = ({ version }: (typeof rows)[number], rowsOf: (number: number) => readonly unknown[]) =>
      fromStored(rowsOf(version.number), rowsOf(version.base), version.check);
    for (const [i, one] of rows.entries()) expect(readWith(one, (number) => byNumber.get(number) ?? [])).toBe(texts[i]);
    for (const damage of damages) {
      for (let hit = 0; hit < rows.length; hit += 9) {
        const damaged = rows[hit].version.number;
        for (const copy of rows[hit].rows.keys()) {
          const damagedRows = (number: number) => {
            const of = byNumber.get(number) ?? [];
            return number !== damaged ? of : of.map((row, i) => (i === copy ? damage(row) : row));
          };
          for (const [i, one] of rows.entries()) {
            // any other version is read from the same rows as without the damage
            if (one.version.number !== damaged && one.version.base !== damaged) continue;
            const read = readWith(one, damagedRows);
            if (i === hit && rows[hit].rows.length === 1) expect([null, texts[i]]).toContain(read);
            else expect(read).toBe(texts[i]);
          }
        }
      }
    }
  });

  it('reads what is left where a row of the list is damaged', async () => {
    const all = begin();
    const { level, versions, store } = all;
    for (let i = 0; i < 4; i++) {
      versions.note(level.file(), 'page');
      level.change('Move', move(1));
    }
    await versions.settled();
    const history = await store.open('f/07');
    const list = await store.list(history);
    await store.change(history, [], [{ ...list[1], labels: 7 } as never, { ...list[2], time: Number.NaN }]);
    expect((await listed(all)).map(({ number }) => number)).toEqual([1, 4]);
    versions.note(level.file(), 'page');
    expect((await listed(all)).map(({ number }) => number)).toEqual([1, 4, 5]);
  });

  it('goes on in another page from what the first one stored, without a version twice', async () => {
    const first = begin();
    first.versions.note(first.level.file(), 'found');
    first.level.change('Move', move(1));
    first.versions.note(first.level.file(), 'page');
    await first.versions.settled();
    const second = begin(first.level.file(), first.store);
    second.versions.note(second.level.file(), 'found');
    expect(await listed(second)).toHaveLength(2);
    second.level.change('Move', move(1));
    second.versions.note(second.level.file(), 'page');
    const found = await listed(second);
    expect(found).toHaveLength(3);
    expect(await second.versions.text(found[2])).toBe(formatLevel(second.level.file()));
  });

  it('is not damaged by two pages that both write', async () => {
    const store = createMemoryVersions();
    const pages = [begin(FILE, store), begin(FILE, store)];
    for (let i = 0; i < 30; i++) {
      const { level, versions } = pages[i % 2];
      level.change('Move', move(1 + i));
      versions.note(level.file(), 'page');
    }
    await Promise.all(pages.map(({ versions }) => versions.settled()));
    const found = await listed(pages[0]);
    expect(new Set(found.map(({ number }) => number)).size).toBe(found.length);
    for (const version of found) expect(checkOf((await pages[0].versions.text(version)) ?? '')).toBe(version.check);
  });
});

/** What a page asks of the database that goes away after `die`: nothing begins any more, and nothing answers. */
function mortal(store: VersionStore): { readonly store: VersionStore; die(): void } {
  let isDead = false;
  const never = new Promise<never>(() => {});
  const get = (of: VersionStore, key: string) => {
    const call = Reflect.get(of, key) as (...given: unknown[]) => Promise<unknown>;
    return (...given: unknown[]) => (isDead ? never : call(...given).then((answer) => (isDead ? never : answer)));
  };
  return {
    store: new Proxy<VersionStore>(store, { get: (of, key) => get(of, String(key)) }),
    die() {
      isDead = true;
    },
  };
}

describe('a page that goes away at once', () => {
  it('leaves each version that it has noted to the next one, with its steps, what it changed and who made it', async () => {
    const lasting = createMemoryVersions();
    const first = mortal(lasting);
    const { level, versions, clock } = begin(FILE, first.store);
    await breathe();
    versions.note(level.file(), 'found');
    level.change('Move', move(1));
    clock.now += 1000;
    versions.note(level.file(), 'page');
    level.change('Move again', move(2));
    clock.now += 500;
    versions.note(level.file(), 'page');
    first.die();
    const second = begin(level.file(), lasting);
    second.clock.now += 60_000;
    second.versions.note(second.level.file(), 'found');
    const found = await listed(second);
    expect(found).toMatchObject([
      { by: 'found', labels: [], time: START },
      { by: 'page', labels: ['Move'], time: START + 1000, changes: 'Asteroid 1 moved 1 px right' },
      { by: 'page', labels: ['Move again'], time: START + 1500, changes: 'Asteroid 1 moved 2 px right' },
    ]);
    expect(await second.versions.text(found[2])).toBe(formatLevel(level.file()));
  });

  it('leaves what it was recording, once, wherever it got to', async () => {
    for (let turns = 0; turns < 40; turns++) {
      const lasting = createMemoryVersions();
      const first = mortal(lasting);
      const { level, versions } = begin(FILE, first.store);
      await breathe();
      versions.note(level.file(), 'found');
      for (const dx of [1, 2, 3]) {
        level.change('Move', move(dx));
        versions.note(level.file(), 'page');
      }
      void versions.settled();
      for (let i = 0; i < turns; i++) await Promise.resolve();
      first.die();
      const second = begin(level.file(), lasting);
      second.clock.now += 60_000;
      second.versions.note(second.level.file(), 'found');
      const found = await listed(second);
      expect(found.map(({ changes }) => changes)).toEqual(['', ...[1, 2, 3].map((dx) => `Asteroid 1 moved ${dx} px right`)]);
    }
  });

  it('leaves what waits to the new name of the level', async () => {
    const lasting = createMemoryVersions();
    const first = mortal(lasting);
    const { level, versions } = begin(FILE, first.store);
    await breathe();
    level.change('Move', move(1));
    versions.note(level.file(), 'page');
    first.die();
    const keeper = passingVersions(lasting, () => START + 1000);
    keeper.moved([{ from: 'f/07', to: 'f/08', token: 'a' }]);
    const renamed = keeper.follow('f/08', createEditedLevel(level.file()));
    await renamed.load();
    expect(renamed.store.getState()).toMatchObject([{ labels: ['Move'] }]);
  });
});

describe('names of versions', () => {
  it('are given to the present version, changed and taken away', async () => {
    const all = begin();
    const { level, versions } = all;
    versions.note(level.file(), 'found');
    level.change('Move', move(1));
    // not on disk yet: it is recorded all the same
    expect(await versions.nameNow('good')).toBe(true);
    const [, named] = await listed(all);
    expect(named).toMatchObject({ number: 2, name: 'good', labels: ['Move'] });
    versions.note(level.file(), 'page');
    expect(await listed(all)).toHaveLength(2);
    expect(await versions.rename(named, 'better')).toBe(true);
    expect((await listed(all))[1].name).toBe('better');
    await versions.rename(named, null);
    expect((await listed(all))[1].name).toBeNull();
  });
});

describe('a browser whose database fails', () => {
  const failing = () => {
    const store = createMemoryVersions();
    const state = { error: null as Error | null, adds: 0 };
    const add: VersionStore['add'] = async (...given) => {
      state.adds++;
      if (state.error !== null) throw state.error;
      return store.add(...given);
    };
    return { store: { ...store, add }, state };
  };

  it('is survived and said; what comes later contains the labels of what was lost', async () => {
    const { store, state } = failing();
    const all = begin(FILE, store);
    const { level, versions, keeper } = all;
    versions.note(level.file(), 'found');
    await versions.settled();
    expect(keeper.trouble.getState()).toBeNull();
    state.error = new DOMException('gone', 'InvalidStateError');
    level.change('One', move(1));
    versions.note(level.file(), 'page');
    await versions.settled();
    expect(keeper.trouble.getState()).toMatchObject({ kind: 'failing', message: expect.stringContaining('gone') });
    expect(await versions.nameNow('x')).toBe(false);
    state.error = null;
    level.change('Two', move(1));
    versions.note(level.file(), 'page');
    const found = await listed(all);
    expect(keeper.trouble.getState()).toBeNull();
    expect(found.flatMap(({ labels }) => labels)).toEqual(['One', 'Two']);
    expect(await versions.text(found[found.length - 1])).toBe(formatLevel(level.file()));
  });

  it('because it is full gets rid of the older half of what has no name, and goes on', async () => {
    const { store, state } = failing();
    const all = begin(FILE, store);
    const { level, versions, keeper } = all;
    for (let i = 0; i < 20; i++) {
      level.change('Move', move(1));
      versions.note(level.file(), 'page');
      if (i === 3) await versions.nameNow('kept');
    }
    await versions.settled();
    const full = new DOMException('full', 'QuotaExceededError');
    const { change } = store;
    store.change = async (...given) => {
      state.error = null;
      await change(...given);
    };
    state.error = full;
    level.change('Move', move(1));
    versions.note(level.file(), 'page');
    const found = await listed(all);
    expect(keeper.trouble.getState()).toBeNull();
    expect(found.length).toBeLessThan(15);
    expect(found.map(({ name }) => name)).toContain('kept');
    for (const version of found) expect(checkOf((await versions.text(version)) ?? '')).toBe(version.check);
    expect(await versions.text(found[found.length - 1])).toBe(formatLevel(level.file()));
    // and if it stays full, that is said
    store.change = change;
    state.error = full;
    level.change('Move', move(1));
    versions.note(level.file(), 'page');
    await versions.settled();
    expect(keeper.trouble.getState()?.message).toContain('no room');
  });

  it('loses none that were recorded before it answered', async () => {
    const keeper = passingVersions(null);
    const levels = ['f/07', 'f/08'].map((place) => {
      const level = createEditedLevel(FILE);
      return { place, level, versions: keeper.follow(place, level) };
    });
    for (const { level, versions } of levels) {
      versions.note(level.file(), 'found');
      level.change('Move', move(1));
      versions.note(level.file(), 'page');
    }
    await levels[0].versions.settled();
    await levels[1].versions.nameNow('kept');
    levels[1].versions.close();
    const lasting = createMemoryVersions();
    keeper.adopt(lasting);
    expect(keeper.trouble.getState()).toBeNull();
    levels[0].level.change('Later', move(1));
    levels[0].versions.note(levels[0].level.file(), 'page');
    await levels[0].versions.settled();
    for (const { place, level, versions } of levels) {
      const found = await lasting.list(await lasting.open(place));
      expect(found.flatMap(({ labels }) => labels)).toEqual(place === 'f/07' ? ['Move', 'Later'] : ['Move']);
      expect(found.at(-1)?.name).toBe(place === 'f/07' ? null : 'kept');
      expect(await versions.text(found[found.length - 1])).toBe(formatLevel(level.file()));
    }
  });

  it('has a history as long as the page, and says so', async () => {
    const keeper = passingVersions(null);
    expect(keeper.trouble.getState()?.kind).toBe('missing');
    const level = createEditedLevel(FILE);
    const versions = keeper.follow('f/07', level);
    versions.note(level.file(), 'found');
    await versions.load();
    expect(versions.store.getState()).toHaveLength(1);
  });
});

const MINUTE = 60_000;
const versionAt = (number: number, time: number, name: string | null = null): Version => ({
  ...{
    number,
    time,
    name,
    by: 'page',
    labels: [`step ${number}`],
    more: 0,
    changes: `change ${number}`,
    check: String(number),
    base: 1,
    size: 100,
  },
});

describe('thinning', () => {
  it('keeps the last of each minute, hour and day as versions age, every name, and the last one', () => {
    const arbitrary = fc.array(fc.tuple(fc.nat(40 * 24 * 60), fc.boolean()), { minLength: 1, maxLength: 200 });
    fc.assert(
      fc.property(arbitrary, (drawn) => {
        const now = START + 123_456;
        const sorted = drawn.sort((p, q) => q[0] - p[0]);
        const versions = sorted.map(([age, isNamed], i) =>
          versionAt(i + 1, now - age * MINUTE, isNamed && i % 3 === 0 ? 'x' : null),
        );
        const { drop, put } = thin(versions, now);
        const gone = new Set(drop);
        const kept = versions.filter(({ number }) => !gone.has(number));
        expect(gone.has(versions.length)).toBe(false);
        for (const { number, name } of versions) if (name !== null) expect(gone.has(number)).toBe(false);
        const stretchOf = ({ time }: Version): string => {
          const stage = STAGES.find(({ age }) => now - time > age);
          return stage === undefined ? String(time) : `${stage.apart} ${Math.floor(time / stage.apart)}`;
        };
        for (const number of gone) {
          // a later version of the same stretch stays
          const own = versions[number - 1];
          expect(kept.some((one) => one.number > number && stretchOf(one) === stretchOf(own))).toBe(true);
        }
        // no step is forgotten, and what a version changed is told only as long as the one before it is there
        const after = kept.map((version) => put.find(({ number }) => number === version.number) ?? version);
        for (const { number, changes } of after) expect(changes === '').toBe(gone.has(number - 1));
        expect(after.reduce((sum, { labels, more }) => sum + labels.length + more, 0)).toBe(versions.length);
        // thinning again changes nothing
        expect(thin(after, now)).toEqual({ drop: [], put: [] });
      }),
      { numRuns: 300 },
    );
  });

  it('keeps a limited number and size of versions without a name: the newest', () => {
    const versions = Array.from({ length: 50 }, (_, i) => versionAt(i + 1, START - (50 - i) * 1000, i === 2 ? 'x' : null));
    const { drop } = thin(versions, START, { versions: 10, size: 1e9 });
    expect(versions.map(({ number }) => number).filter((number) => !drop.includes(number))).toEqual([
      3, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50,
    ]);
    expect(thin(versions, START, { versions: 1e9, size: 1000 }).drop).toEqual(drop);
  });

  itQuick('does not touch the texts of versions that stay', async () => {
    const all = begin();
    const { level, versions, clock } = all;
    clock.now = START - 50 * 24 * 3_600_000;
    for (let i = 0; i < 320; i++) {
      level.change('Move', move(1));
      versions.note(level.file(), 'page');
      await versions.settled();
      clock.now += (i % 9 === 0 ? 300 : 7) * MINUTE;
    }
    clock.now = START;
    for (let i = 0; i < 60; i++) {
      level.change('Move', move(1));
      versions.note(level.file(), 'page');
      await versions.settled();
    }
    const found = await listed(all);
    expect(found.length).toBeLessThan(200);
    for (const version of found) expect(checkOf((await versions.text(version)) ?? '')).toBe(version.check);
    expect(found.reduce((sum, { labels, more }) => sum + labels.length + more, 0)).toBe(380);
  });
});

describe('a history follows its level', () => {
  const heads = (...places: string[]) =>
    new Map(places.map((place, i) => [place, { place, history: i + 1, token: null as string | null }]));
  const moved = (map: ReturnType<typeof heads>, moves: Parameters<typeof movedHeads>[1]) => {
    const change = movedHeads(map, moves);
    const next = new Map(map);
    for (const place of change?.gone ?? []) next.delete(place);
    for (const head of change?.put ?? []) next.set(head.place, head);
    return next;
  };
  const names = (map: ReturnType<typeof heads>) =>
    Object.fromEntries([...map.values()].map(({ place, history }) => [place, history]));

  it('to its new name, also where two swap names, once however many pages hear of it', () => {
    const swap = [
      { from: 'a', to: 'b', token: 'a b 1' },
      { from: 'b', to: 'a', token: 'b a 2' },
    ];
    const once = moved(heads('a', 'b', 'c'), swap);
    expect(names(once)).toEqual({ a: 2, b: 1, c: 3 });
    expect(names(moved(once, swap))).toEqual({ a: 2, b: 1, c: 3 });
    const back = [
      { from: 'a', to: 'b', token: 'a b 2' },
      { from: 'b', to: 'a', token: 'b a 1' },
    ];
    expect(names(moved(once, back))).toEqual({ a: 1, b: 2, c: 3 });
  });

  it('and what had that name before is set aside, not lost', () => {
    expect(names(moved(heads('a', 'b'), [{ from: 'a', to: 'b', token: 't' }]))).toEqual({ b: 1, 'b?aside 2': 2 });
    expect(names(moved(heads('a'), [{ from: 'x', to: 'a', token: 't' }]))).toEqual({ a: 1 });
  });

  it('as long as the page records, too', async () => {
    const all = begin();
    const { level, versions, keeper, store } = all;
    versions.note(level.file(), 'found');
    keeper.moved([{ from: 'f/07', to: 'f/08', token: 't' }]);
    versions.moveTo('f/08');
    level.change('Move', move(1));
    versions.note(level.file(), 'page');
    expect(await listed(all)).toHaveLength(2);
    expect(await store.list(await store.open('f/08'))).toHaveLength(2);
    expect(await store.list(await store.open('f/07'))).toHaveLength(0);
  });

  it('whenever it is opened, recorded, swapped with another, or reopened', async () => {
    const action = fc.constantFrom('save', 'save', 'record', 'list', 'swap', 'swap', 'reopen', 'wait');
    await fc.assert(
      fc.asyncProperty(fc.array(fc.tuple(action, fc.nat(1)), { maxLength: 25 }), async (actions) => {
        const { store, keeper } = begin();
        const places = ['f/01', 'f/02'];
        const levels = ['A', 'B'].map((name) => createEditedLevel({ ...FILE, name }));
        const follow = (i: number) => keeper.follow(places[i], levels[i]);
        const histories = [follow(0), follow(1)];
        const saves = [0, 0];
        const save = (i: number) => {
          levels[i].change('Move', move(1));
          histories[i].note(levels[i].file(), 'page');
          saves[i]++;
        };
        for (const [n, [what, i]] of actions.entries()) {
          if (what === 'save') save(i);
          else if (what === 'record') void histories[i].settled();
          else if (what === 'list') void histories[i].load();
          else if (what === 'wait') await Promise.resolve();
          else if (what === 'reopen') {
            histories[i].close();
            histories[i] = follow(i);
          } else {
            const [a, b] = places;
            const moves = [
              { from: a, to: b, token: `${n}` },
              { from: b, to: a, token: `${n}` },
            ];
            keeper.moved(moves);
            places.reverse();
            for (const [level, history] of histories.entries()) history.moveTo(places[level]);
          }
        }
        for (const history of histories) await history.load();
        for (const [i, place] of places.entries()) {
          const history = await store.open(place);
          const versions = await store.list(history);
          const names = await Promise.all(
            versions.map(async (version) => {
              const { copies, bases } = await store.texts(history, version);
              return JSON.parse(fromStored(copies, bases, version.check) as string).name;
            }),
          );
          expect(names).toEqual(Array(saves[i]).fill('AB'[i]));
        }
      }),
      { numRuns: 2000 },
    );
  });
});

it('a text is stored whole where a delta would not be shorter, and twice', () => {
  expect(toStored('abc', null)).toEqual({ whole: 'abc', check: checkOf('abc') });
  expect(toStored('abc', { number: 1, text: 'xyz', uses: 1 })).toMatchObject({ whole: 'abc' });
});
