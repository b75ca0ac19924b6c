import { beforeEach, describe, expect, it } from 'vitest';
import { createBrowserStorage, type LevelStorage } from '../../editor/core/files/index.ts';
import { type EditEvent, editEventSchema, listResponseSchema } from '../../schema/index.ts';
import { breathe, createChannels, createKeyValues } from './stage.ts';

const text = (name: string) => JSON.stringify({ version: 1, name, astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } });

let storage: LevelStorage;
let other: LevelStorage;
const events: EditEvent[] = [];
const etagOf = async (id: string): Promise<string> => {
  const read = await storage.read(id);
  return read.ok ? (read.value.etag ?? '') : '';
};
const ids = async () => {
  const list = await storage.list();
  return list.ok ? list.value.levels.map(({ id }) => id) : [];
};

beforeEach(async () => {
  const [database, channels] = [createKeyValues(), createChannels()];
  storage = createBrowserStorage(database, channels('levels'), () => 0);
  other = createBrowserStorage(database, channels('levels'), () => 0);
  for (const id of ['a', 'b', 'c']) await storage.write(id, text(id), null);
  events.length = 0;
  other.watch(
    (event) => events.push(event),
    () => {},
  );
  await breathe();
  events.length = 0;
});

describe('levels in the browser', () => {
  it('have the same shapes as those of the server', async () => {
    const list = await storage.list();
    expect(listResponseSchema.safeParse(list.ok && list.value)).toMatchObject({ success: true });
    await storage.write('a', text('A'), await etagOf('a'));
    await storage.rename('a', 'd', await etagOf('a'));
    await storage.remove('b', await etagOf('b'));
    await storage.order('', ['c', 'd']);
    await breathe();
    expect(events.map((event) => editEventSchema.safeParse(event).success && event.type)).toEqual([
      'changed',
      'renamed',
      'removed',
      'list',
    ]);
  });

  it('can be renamed in place, duplicated, deleted and restored', async () => {
    await storage.rename('b', 'z', await etagOf('b'));
    await storage.duplicate('z', 'y', await etagOf('z'));
    expect(await ids()).toEqual(['a', 'z', 'c', 'y']);
    const removed = await storage.remove('z', await etagOf('z'));
    expect(await ids()).toEqual(['a', 'c', 'y']);
    expect(await storage.trash()).toMatchObject({ ok: true, value: [{ id: 'z', deleted: '1970-01-01T00:00:00.000Z' }] });
    if (removed.ok) await storage.restore(removed.value.trashed.trash, 'b');
    expect(await ids()).toEqual(['a', 'c', 'y', 'b']);
    expect(await storage.read('b')).toMatchObject({ ok: true, value: { name: 'b' } });
  });

  it('are not overwritten by a page with an older version, by an invalid level, or under a taken name', async () => {
    const old = await etagOf('a');
    await other.write('a', text('newer'), old);
    expect(await storage.write('a', text('mine'), old)).toMatchObject({
      ok: false,
      error: { code: 'conflict', current: { text: text('newer') } },
    });
    expect(await storage.write('a', '{', await etagOf('a'))).toMatchObject({ ok: false, error: { code: 'invalid-level' } });
    expect(await storage.write('A', text('x'), null)).toMatchObject({ ok: false, error: { code: 'name-taken' } });
    expect(await storage.write('../x', text('x'), null)).toMatchObject({ ok: false, error: { code: 'bad-name' } });
    expect(await storage.rename('b', 'c', await etagOf('b'))).toMatchObject({ ok: false, error: { code: 'name-taken' } });
    expect(await storage.order('', ['a', 'b'])).toMatchObject({ ok: false, error: { code: 'list-changed' } });
    expect(await ids()).toEqual(['a', 'b', 'c']);
  });

  it('stay in order of play, also with numeric names', async () => {
    await storage.write('10', text('ten'), null);
    expect(await ids()).toEqual(['a', 'b', 'c', '10']);
  });

  it('report that there is no space', async () => {
    const full = createBrowserStorage(
      {
        get: async () => undefined,
        update: async () => Promise.reject(Object.assign(new Error('full'), { name: 'QuotaExceededError' })),
      },
      null,
      () => 0,
    );
    expect(await full.write('a', text('a'), null)).toMatchObject({
      ok: false,
      error: { code: 'disk-full', message: expect.stringContaining('no room'), hint: expect.stringContaining('download') },
    });
  });

  it('report the error of the database', async () => {
    for (const [thrown, why] of [
      [new DOMException('denied', 'SecurityError'), 'denied'],
      ['no reason', 'no reason'],
      [{ name: 'QuotaExceededError' }, 'object'],
    ] as const) {
      const fail = () => Promise.reject(thrown);
      const failing = createBrowserStorage({ get: fail, update: fail }, null, () => 0);
      const error = { code: 'failed', message: expect.stringContaining(why), hint: expect.stringContaining('download') };
      for (const answer of [await failing.list(), await failing.write('a', text('a'), null)])
        expect(answer).toMatchObject({ ok: false, error });
      const told: unknown[] = [];
      failing.watch(
        (event) => told.push(event),
        (link) => told.push(link),
      );
      await breathe();
      expect(told).toEqual(['up']);
    }
  });

  it('are those of the last call if the database calls an update twice', async () => {
    // as a database does that restarts a transaction
    const kept: unknown[] = [];
    const database = createKeyValues();
    await createBrowserStorage(database, null, () => 0).write('a', text('a'), null);
    const full = await database.get('gravity-quest-editor-levels');
    const twice = (first: unknown, second: unknown) =>
      createBrowserStorage(
        {
          get: async () => second,
          async update(_, change) {
            for (const state of [first, second]) kept.push(change(state));
          },
        },
        null,
        () => 0,
      );
    expect(await twice(undefined, full).write('a', text('new'), null)).toMatchObject({
      ok: false,
      error: { code: 'name-taken' },
    });
    expect(kept.at(-1)).toBe(full);
    expect(await twice(full, undefined).write('a', text('new'), null)).toMatchObject({ ok: true, value: { name: 'new' } });
  });

  it('never get the same etag twice, and are restored only from the trash and to a free name', async () => {
    const etags = new Set([await etagOf('a')]);
    for (let i = 0; i < 20; i++) {
      await storage.write('a', text('same'), await etagOf('a'));
      etags.add(await etagOf('a'));
    }
    expect(etags.size).toBe(21);
    const names: string[] = [];
    for (let i = 0; i < 3; i++) {
      const removed = await storage.remove('a', await etagOf('a'));
      if (removed.ok) names.push(removed.value.trashed.trash);
      etags.add(await etagOf('a'));
      await storage.write('a', text(`a ${i}`), null);
      etags.add(await etagOf('a'));
    }
    expect([etags.size, new Set(names).size]).toEqual([25, 3]);
    const trash = async () => {
      const answer = await storage.trash();
      return answer.ok ? answer.value.map((entry) => entry.trash) : [];
    };
    expect(await trash()).toEqual(names.toReversed());
    expect(await storage.restore(names[1])).toMatchObject({ ok: false, error: { code: 'name-taken' } });
    expect(await storage.restore('nowhere')).toMatchObject({ ok: false, error: { code: 'unknown-level' } });
    expect(await storage.restore(names[1], 'back')).toMatchObject({ ok: true, value: { id: 'back', name: 'a 0' } });
    expect(await trash()).toEqual([names[2], names[0]]);
    expect(await storage.restore(names[1], 'again')).toMatchObject({ ok: false, error: { code: 'unknown-level' } });
    await storage.remove('a', await etagOf('a'));
    expect(await storage.restore(names[0])).toMatchObject({ ok: true, value: { id: 'a', name: 'same' } });
  });

  it('are written in place, and reordered only by a list of all of them', async () => {
    await storage.write('b', text('B'), await etagOf('b'));
    expect(await ids()).toEqual(['a', 'b', 'c']);
    for (const wrong of [
      ['a', 'b', 'x'],
      ['a', 'b', 'b'],
      ['a', 'b'],
      ['a', 'b', 'c', 'x'],
      ['x', 'y', 'z'],
    ])
      expect(await storage.order('', wrong)).toMatchObject({ ok: false, error: { code: 'list-changed' } });
    expect(await storage.order('', ['c', 'a', 'b'])).toMatchObject({
      ok: true,
      value: { renamed: [], levels: [{ id: 'c' }, {}, {}] },
    });
    expect(await ids()).toEqual(['c', 'a', 'b']);
    // a name that differs only in case is taken, except for the level itself
    expect(await storage.rename('b', 'B', await etagOf('b'))).toMatchObject({ ok: true, value: { id: 'B', name: 'B' } });
    expect(await storage.duplicate('B', 'b', await etagOf('B'))).toMatchObject({ ok: false, error: { code: 'name-taken' } });
  });

  it('are reported to other pages of the same list until the page stops listening', async () => {
    const told: unknown[] = [];
    const stop = other.watch(
      (event) => told.push(event),
      (link) => told.push(link),
    );
    await breathe();
    expect(told).toMatchObject(['up', { type: 'list', list: { levels: [{ id: 'a' }, { id: 'b' }, { id: 'c' }] } }]);
    told.length = 0;
    await storage.write('n', text('n'), null);
    await storage.rename('n', 'm', await etagOf('n'));
    await storage.remove('m', await etagOf('m'));
    await breathe();
    expect(told).toMatchObject([
      { type: 'changed', entry: { id: 'n' } },
      { type: 'renamed', from: 'n', entry: { id: 'm' } },
      { type: 'removed', id: 'm' },
    ]);
    stop();
    const count = told.length;
    await storage.write('n', text('n'), null);
    // nor the answer to an earlier request
    const stopAtOnce = other.watch(
      (event) => told.push(event),
      () => {},
    );
    stopAtOnce();
    await breathe();
    expect(told).toHaveLength(count);
  });

  it('are listed as invalid if they are not levels, and can be fixed', async () => {
    const database = createKeyValues();
    const shelf = createBrowserStorage(database, null, () => 0);
    await shelf.write('a', text('a'), null);
    await database.update('gravity-quest-editor-levels', (old) => {
      const { levels, ...rest } = old as { levels: Map<string, object> };
      return { ...rest, levels: new Map([...levels].map(([id, level]) => [id, { ...level, text: '{' }])) };
    });
    const found = await shelf.read('a');
    expect(found).toMatchObject({ ok: true, value: { status: 'invalid', name: null, text: '{', problems: [{}] } });
    expect(await shelf.write('a', text('mended'), found.ok ? found.value.etag : null)).toMatchObject({
      ok: true,
      value: { status: 'valid', problems: [] },
    });
  });
});
