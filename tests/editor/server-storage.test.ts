import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { setLevelProperty } from '../../editor/core/document/index.ts';
import {
  createServerStorage,
  createWorkspace,
  type LevelStorage,
  type Link,
  pageTimers,
  type Workspace,
} from '../../editor/core/files/index.ts';
import { createJournal, createMemoryStore } from '../../editor/core/journal/index.ts';
import type { EditEvent } from '../../schema/index.ts';
import { levelText, makeFolder, put, serve } from '../server/running.ts';
import { until } from '../until.ts';
import { passingVersions } from './stage.ts';

let made: ReturnType<typeof makeFolder>;
let server: Awaited<ReturnType<typeof serve>>;
let storage: LevelStorage;
const stops: (() => void)[] = [];

/** The fetch function of a page, with the Origin header that a browser adds. */
const fetchFrom =
  (origin: string): typeof fetch =>
  (input, init) =>
    fetch(input, {
      ...init,
      headers: { ...(init?.headers as Record<string, string>), Origin: origin, 'Sec-Fetch-Site': 'same-origin' },
    });

const storageOf = (client: string, token = server.page.token): LevelStorage => {
  const origin = `http://127.0.0.1:${server.port}`;
  return createServerStorage({
    origin,
    token,
    key: { learn: async () => {}, renew: async () => null },
    client,
    fetch: fetchFrom(origin),
  });
};
const onDisk = (id: string) => readFileSync(join(made.folder, `${id}.level.json`), 'utf8');

beforeEach(async () => {
  made = makeFolder({
    '01-a.level.json': levelText('A'),
    '02-b.level.json': levelText('B'),
    '03-bad.level.json': '{ "version": 1,',
  });
  server = await serve(made.folder);
  storage = storageOf('page-1');
});
afterEach(async () => {
  for (const stop of stops.splice(0)) stop();
  await server.close();
  made.remove();
});

describe('the folder behind gq edit', () => {
  it('is listed, read and written', async () => {
    const list = await storage.list();
    expect(list).toMatchObject({
      ok: true,
      value: { levels: [{ id: '01-a', status: 'valid' }, { id: '02-b' }, { id: '03-bad', status: 'invalid' }] },
    });
    const read = await storage.read('01-a');
    if (!read.ok) throw new Error(read.error.message);
    expect(read.value.text).toBe(levelText('A'));
    const written = await storage.write('01-a', levelText('A2'), read.value.etag);
    expect(written).toMatchObject({ ok: true, value: { name: 'A2' } });
    expect(onDisk('01-a')).toBe(levelText('A2'));
    expect(await storage.write('04-new', levelText('N'), null)).toMatchObject({ ok: true, value: { id: '04-new' } });
  });

  it('returns the current state if it differs from the base', async () => {
    expect(await storage.write('01-a', levelText('X'), `"${'0'.repeat(64)}"`)).toMatchObject({
      ok: false,
      error: { code: 'conflict', current: { text: levelText('A') } },
    });
    expect(await storage.write('01-a', levelText('X'), null)).toMatchObject({ ok: false });
    expect(await storage.write('01-a', '{', null)).toMatchObject({ ok: false });
    expect(await storage.read('nowhere')).toMatchObject({
      ok: false,
      error: { code: 'unknown-level', hint: expect.stringMatching(/./) },
    });
    expect(onDisk('01-a')).toBe(levelText('A'));
  });

  it('can be renamed, duplicated, deleted, restored and reordered', async () => {
    const etagOf = async (id: string) => {
      const read = await storage.read(id);
      return read.ok ? (read.value.etag ?? '') : '';
    };
    expect(await storage.rename('02-b', '05-b', await etagOf('02-b'))).toMatchObject({ ok: true, value: { id: '05-b' } });
    expect(await storage.duplicate('05-b', '06-c', await etagOf('05-b'))).toMatchObject({ ok: true });
    const removed = await storage.remove('06-c', await etagOf('06-c'));
    if (!removed.ok) throw new Error(removed.error.message);
    expect(existsSync(join(made.folder, '06-c.level.json'))).toBe(false);
    expect(await storage.trash()).toMatchObject({ ok: true, value: [{ id: '06-c' }] });
    expect(await storage.restore(removed.value.trashed.trash)).toMatchObject({ ok: true, value: { id: '06-c' } });
    const list = await storage.list();
    const ids = list.ok ? list.value.levels.map(({ id }) => id) : [];
    expect(await storage.order('', [...ids].reverse())).toMatchObject({ ok: true });
  });

  it('reports the changes of others, but not those of the page itself', async () => {
    const events: EditEvent[] = [];
    const links: Link[] = [];
    stops.push(
      storage.watch(
        (event) => events.push(event),
        (link) => links.push(link),
      ),
    );
    await until(() => events.length > 0);
    const read = await storage.read('01-a');
    await storage.write('01-a', levelText('mine'), read.ok ? read.value.etag : null);
    const other = storageOf('page-2');
    const b = await other.read('02-b');
    await other.write('02-b', levelText('theirs'), b.ok ? b.value.etag : null);
    await until(() => events.some((event) => event.type === 'changed'));
    put(made.folder, '07-tool.level.json', levelText('by a tool'));
    await until(() => events.some((event) => event.type === 'changed' && event.entry.id === '07-tool'));
    rmSync(join(made.folder, '02-b.level.json'));
    await until(() => events.some((event) => event.type === 'removed'));
    expect(events[0].type).toBe('list');
    expect(events.filter((event) => event.type === 'changed').map(({ entry }) => entry.id)).toEqual(['02-b', '07-tool']);
    expect(links).toEqual(['up']);
  });

  it('is reported as unreachable when its server is gone, and when it is back', async () => {
    const links: Link[] = [];
    stops.push(
      storage.watch(
        () => {},
        (link) => links.push(link),
      ),
    );
    await until(() => links.length === 1);
    await server.close();
    await until(() => links.length === 2);
    expect(await storage.list()).toMatchObject({ ok: false, error: { code: 'unreachable' } });
    expect(links).toEqual(['up', 'gone']);
  });

  it('refuses a page of another run, which is reported', async () => {
    const links: Link[] = [];
    stops.push(
      storageOf('page-3', 'wrong').watch(
        () => {},
        (link) => links.push(link),
      ),
    );
    await until(() => links.length === 1);
    expect(links).toEqual(['otherRun']);
    expect(await storageOf('page-3', 'wrong').list()).toMatchObject({
      ok: false,
      error: { code: 'wrong-token', hint: expect.stringMatching(/./) },
    });
  });
});

describe('a page on it', () => {
  const open = async (): Promise<Workspace> => {
    const workspace = createWorkspace({
      storage,
      journal: createJournal(createMemoryStore(), () => 0),
      versions: passingVersions(),
      timers: pageTimers,
      locks: null,
      channel: () => null,
    });
    await workspace.start();
    stops.push(() => void workspace.close());
    return workspace;
  };
  const levelIn = (workspace: Workspace) => workspace.store.getState().opened?.level;

  it('saves automatically, and shows the changes of a tool without unsaved changes', async () => {
    const workspace = await open();
    await workspace.open('01-a');
    levelIn(workspace)?.change('Rename', setLevelProperty('name', 'from the page'));
    await until(() => onDisk('01-a').includes('from the page'));
    await until(() => workspace.store.getState().opened?.saver.store.getState().kind === 'saved');
    writeFileSync(join(made.folder, '01-a.level.json'), levelText('from a tool'));
    await until(() => levelIn(workspace)?.file().name === 'from a tool');
    expect(workspace.store.getState().opened?.saver.isUnsaved()).toBe(false);
    levelIn(workspace)?.undo();
    await until(() => onDisk('01-a').includes('from the page'));
  });

  it('reorders levels, and each keeps its own history', async () => {
    const workspace = await open();
    await workspace.open('01-a');
    levelIn(workspace)?.change('Rename', setLevelProperty('name', 'A, changed'));
    await workspace.open('02-b');
    levelIn(workspace)?.change('Rename', setLevelProperty('name', 'B, changed'));
    // unsaved changes are written first
    const ordered = await workspace.order('', ['02-b', '01-a', '03-bad']);
    expect(ordered.ok && ordered.value.renamed).toHaveLength(2);
    const [b, a] = workspace.store.getState().list?.levels.map(({ id }) => id) ?? [];
    expect([b, a]).toEqual(['01-b', '02-a']);
    expect(workspace.store.getState().opened?.id()).toBe(b);
    expect([onDisk(b), onDisk(a)]).toEqual([expect.stringContaining('B, changed'), expect.stringContaining('A, changed')]);
    levelIn(workspace)?.change('Rename', setLevelProperty('name', 'B again'));
    await workspace.open(a);
    expect(onDisk(b)).toContain('B again');
    expect(levelIn(workspace)?.labels()).toEqual(['Rename']);
    levelIn(workspace)?.undo();
    await until(() => onDisk(a).includes('"A"'));
  });

  it('copies, deletes and restores levels including unsaved changes', async () => {
    const workspace = await open();
    const entry = (id: string) => {
      const found = workspace.store.getState().list?.levels.find((level) => level.id === id);
      if (found === undefined) throw new Error(`${id} is not listed`);
      return found;
    };
    await workspace.open('01-a');
    levelIn(workspace)?.change('Rename', setLevelProperty('name', 'one'));
    expect(await workspace.duplicate(entry('01-a'), '04-copy')).toMatchObject({ ok: true, value: { name: 'one' } });
    expect(entry('04-copy').name).toBe('one');
    levelIn(workspace)?.change('Rename', setLevelProperty('name', 'two'));
    const removed = await workspace.remove(entry('01-a'));
    if (!removed.ok) throw new Error(removed.error.message);
    expect(workspace.store.getState().list?.levels.some(({ id }) => id === '01-a')).toBe(false);
    await workspace.leave();
    expect(existsSync(join(made.folder, '01-a.level.json'))).toBe(false);
    expect(await workspace.restore(removed.value.trashed.trash)).toMatchObject({ ok: true, value: { name: 'two' } });
    expect(entry('01-a').name).toBe('two');
    // the level has changed since the list: nothing is done, and the list is requested again
    put(made.folder, '04-copy.level.json', levelText('three'));
    expect(await workspace.remove({ ...entry('04-copy'), etag: `"${'0'.repeat(64)}"` })).toMatchObject({
      ok: false,
      error: { code: 'conflict' },
    });
    expect(entry('04-copy').name).toBe('three');
  });

  it('opens a file that is not a level as text', async () => {
    const workspace = await open();
    expect(await workspace.open('03-bad')).toMatchObject({
      ok: false,
      kind: 'invalid',
      text: '{ "version": 1,',
      problems: [{ code: 'truncated-json', line: 1 }],
    });
    expect(onDisk('03-bad')).toBe('{ "version": 1,');
  });
});
