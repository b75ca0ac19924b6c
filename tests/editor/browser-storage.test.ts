import { beforeEach, describe, expect, it } from 'vitest';
import { createBrowserStorage, type LevelStorage } from '../../editor/files/index.ts';
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
  it('are told in the shapes of the server', async () => {
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

  it('can be renamed in their place, duplicated, deleted and brought back', async () => {
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

  it('are not written over by a page that has an older one, nor by what is no level, nor under a name that is taken', async () => {
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

  it('keep their order by play, also when a name is a number', async () => {
    await storage.write('10', text('ten'), null);
    expect(await ids()).toEqual(['a', 'b', 'c', '10']);
  });

  it('that have no room say so', async () => {
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
      error: { code: 'disk-full', hint: expect.stringContaining('download') },
    });
  });
});
