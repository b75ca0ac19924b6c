import { chmodSync, readdirSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { type LevelFolder, openLevelFolder } from '../../cli/serve/level-folder.ts';
import { Refusal, refusalOf } from '../../cli/serve/refusal.ts';
import { EDIT_API } from '../../schema/index.ts';
import { levelPath, levelText, makeFolder, serve } from './running.ts';

// The texts of refusals, and the obstacles to a change.

const disk = vi.hoisted(() => ({ fails: null as null | ((step: string, path: string) => string | undefined) }));
vi.mock('node:fs', async (original) => {
  const fs = await original<typeof import('node:fs')>();
  const failing = (name: 'openSync' | 'linkSync' | 'renameSync' | 'mkdirSync') => {
    const real = fs[name] as (...args: unknown[]) => unknown;
    return (...args: unknown[]): unknown => {
      const code = disk.fails?.(name, String(args[0]));
      if (code !== undefined) throw Object.assign(new Error(`${code}: ${name}`), { code });
      return real(...args);
    };
  };
  const names = ['openSync', 'linkSync', 'renameSync', 'mkdirSync'] as const;
  return { ...fs, ...Object.fromEntries(names.map((name) => [name, failing(name)])) };
});

let made: ReturnType<typeof makeFolder>;
let levels: LevelFolder;
beforeEach(() => {
  made = makeFolder({
    '01.level.json': levelText('A'),
    '02.level.json': levelText('B'),
    'w/03.level.json': levelText('C'),
    'bad.level.json': '{',
  });
  levels = openLevelFolder(made.folder, 'levels');
});
afterEach(() => {
  disk.fails = null;
  levels.end();
  made.remove();
});

const client = 'page';
const etag = (id: string) => levels.read(id).etag ?? '';
const refusal = async (work: () => unknown): Promise<Pick<Refusal, 'code' | 'message' | 'hint' | 'details'>> => {
  try {
    await work();
  } catch (error) {
    if (error instanceof Refusal) return error;
    throw error;
  }
  throw new Error('was not refused');
};
const said = async (work: () => unknown) => {
  const { code, message } = await refusal(work);
  return `${code}: ${message}`;
};
const other = `"${'0'.repeat(64)}"`;

describe('a refusal names', () => {
  it('a level that does not exist, or that has changed', async () => {
    const long = 'x'.repeat(100);
    expect(await said(() => levels.read('nowhere'))).toBe('unknown-level: there is no level "nowhere" in levels');
    expect(await said(() => levels.read('x'.repeat(80)))).toBe(`unknown-level: there is no level "${'x'.repeat(80)}" in levels`);
    expect(await said(() => levels.read(long))).toBe(`unknown-level: there is no level "${'x'.repeat(80)}…" in levels`);
    expect(await said(() => levels.restore('nowhere', undefined, client))).toBe(
      'unknown-level: there is no level "nowhere" among the deleted levels',
    );
    const changed = await refusal(() => levels.write('01', levelText('x'), { etag: other }, client));
    expect([changed.code, changed.message, changed.details.current?.text]).toEqual([
      'conflict',
      'levels/01.level.json has changed on the disk since the version that was edited',
      levelText('A'),
    ]);
    const gone = await refusal(() => levels.write('new', levelText('x'), { etag: other }, client));
    expect([gone.message, gone.details.current]).toEqual(['levels/new.level.json is no longer there', null]);
    const there = await refusal(() => levels.write('01', levelText('x'), 'no-file', client));
    expect([there.code, there.message, there.details.current?.text]).toEqual([
      'conflict',
      'levels/01.level.json already exists',
      levelText('A'),
    ]);
  });

  it('a name that is taken or not allowed, and a folder that does not exist', async () => {
    const write = (id: string) => levels.write(id, levelText('x'), 'no-file', client);
    expect(await said(() => write('con'))).toBe('bad-name: "con" is not a name that a level file can have on every system');
    expect(await said(() => write('x/new'))).toBe('unknown-folder: there is no folder "x" in levels');
    expect(await said(() => write('/new'))).toBe('unknown-folder: there is no folder "" in levels');
    expect(await said(() => write('W/new'))).toBe('unknown-folder: there is no folder "W" in levels');
    expect(await said(() => write('BAD'))).toBe('name-taken: levels/bad.level.json already exists');
    expect(await said(() => levels.rename('01', '02', etag('01'), client))).toBe(
      'name-taken: levels/02.level.json already exists',
    );
    expect(await said(() => levels.duplicate('01', '01', etag('01'), client))).toBe(
      'name-taken: levels/01.level.json already exists',
    );
    // its own name is not taken, in any case of letters
    expect((await levels.rename('bad', 'BAD', etag('bad'), client)).id).toBe('BAD');
    expect((await levels.rename('BAD', 'BAD', etag('BAD'), client)).id).toBe('BAD');
    expect(readdirSync(made.folder).sort()).toEqual(['01.level.json', '02.level.json', 'BAD.level.json', 'w']);
  });

  it('the number of problems of a text', async () => {
    const write = (text: string) => levels.write('01', text, { etag: etag('01') }, client);
    expect(await said(() => write('{'))).toBe('invalid-level: the text is not a valid level: it has a problem');
    const two = await refusal(() => write(levelText('x').replaceAll('"y": 0', '"y": "0"')));
    expect([two.message, two.details.problems?.length]).toEqual(['the text is not a valid level: it has 2 problems', 2]);
    expect(await said(() => levels.duplicate('bad', 'new', etag('bad'), client))).toMatch(/^invalid-level/);
  });

  it('the folder, if it concerns no single level', async () => {
    disk.fails = (step) => (step === 'openSync' ? 'EACCES' : undefined);
    const { message } = await refusal(() => levels.order('', ['01', '02', 'bad'], client));
    expect(message).toMatch(/^levels: can't be written: /);
    const one = await refusal(() => levels.order('', ['02', '01', 'bad'], client));
    expect(one.message).toMatch(/^levels\/02\.level\.json: can't be written: /);
    disk.fails = null;
    const wrong = await refusal(() => levels.order('w', ['01'], client));
    expect(wrong).toMatchObject({ code: 'list-changed', message: 'these are not the levels of levels/w' });
  });

  it.runIf(process.platform !== 'win32')('a level that is not writable, for every kind of change', async () => {
    chmodSync(join(made.folder, '01.level.json'), 0o444);
    const changes = [
      () => levels.write('01', levelText('x'), { etag: etag('01') }, client),
      () => levels.rename('01', 'new', etag('01'), client),
      () => levels.remove('01', etag('01'), client),
      () => levels.order('', ['02', '01', 'bad'], client),
    ];
    for (const change of changes)
      expect(await said(change)).toMatch(/^not-writable: levels\/01\.level\.json: the file can't be written/);
    // the same request again is already done
    expect(await levels.write('01', levelText('A'), { etag: other }, client)).toMatchObject({
      created: false,
      entry: { name: 'A' },
    });
    expect((await levels.duplicate('01', 'copy', etag('01'), client)).name).toBe('A');
  });

  it('the error of the operating system', () => {
    const words: [code: string, refusal: string][] = [
      ['ENOSPC', 'disk-full'],
      ['EDQUOT', 'disk-full'],
      ['EFBIG', 'disk-full'],
      ['EACCES', 'not-writable'],
      ['EPERM', 'not-writable'],
      ['EROFS', 'not-writable'],
      ['ENOENT', 'unknown-folder'],
      ['EIO', 'failed'],
      ['', 'failed'],
    ];
    for (const [code, expected] of words) {
      const made = refusalOf(Object.assign(new Error(code), { code }), 'levels/a');
      expect([code, made.code, made.hint.endsWith('.')]).toEqual([code, expected, true]);
      expect(made.message).toMatch(/^levels\/a: can't be written: /);
      expect(refusalOf(made, 'other')).toBe(made);
    }
    expect(refusalOf(null, 'a').code).toBe('failed');
  });
});

describe('an order that fails in the middle', () => {
  it('is undone completely', async () => {
    for (const at of [0, 1]) {
      let links = 0;
      disk.fails = (step) => (step === 'linkSync' && links++ === at ? 'EIO' : undefined);
      const before = readdirSync(made.folder).sort();
      expect(await said(() => levels.order('', ['bad', '02', '01'], client))).toMatch(/^failed/);
      expect([at, readdirSync(made.folder).sort()]).toEqual([at, before]);
      disk.fails = null;
    }
    const { renamed } = await levels.order('', ['bad', '02', '01'], client);
    expect(renamed.map(({ from, to }) => `${from} to ${to}`)).toEqual(['bad to 01-bad', '01 to 03']);
    // the second try succeeds
    expect((await levels.order('', ['01-bad', '02', '03'], client)).renamed).toEqual([]);
  });

  it('exchanges names in a cycle through a free name', async () => {
    await levels.write('02-moved-1', levelText('in the way'), 'no-file', client);
    await levels.order('w', ['w/03'], client);
    const ids = () => levels.known.list().levels.map(({ id, name }) => `${id} ${name}`);
    await levels.remove('bad', etag('bad'), client);
    await levels.rename('02-moved-1', 'w/02-moved-1', etag('02-moved-1'), client);
    await levels.order('', ['02', '01'], client);
    expect(ids()).toEqual(['01 B', '02 A', 'w/02-moved-1 in the way', 'w/03 C']);
  });
});

describe('a folder that has become a link', () => {
  it('is not followed any more', async () => {
    const at = join(made.folder, 'w');
    const { renameSync } = await vi.importActual<typeof import('node:fs')>('node:fs');
    const inside = levels.read('w/03');
    renameSync(at, `${at}-away`);
    symlinkSync('w-away', at);
    expect(await said(() => levels.read('w/03'))).toMatch(/^unknown-level/);
    expect(await said(() => levels.write('w/03', levelText('x'), { etag: inside.etag ?? '' }, client))).toMatch(/^conflict/);
    expect(await said(() => levels.write('w/new', levelText('x'), 'no-file', client))).toMatch(/^unknown-folder/);
  });

  it('is reported, even if it is the root', async () => {
    const away = makeFolder({ 'levels/a.level.json': levelText('a') });
    const root = join(away.folder, 'levels');
    const moved = openLevelFolder(root, 'levels');
    const { renameSync } = await vi.importActual<typeof import('node:fs')>('node:fs');
    renameSync(root, `${root}-away`);
    symlinkSync('levels-away', root);
    expect(await said(() => moved.read('a'))).toMatch(/^unknown-folder: .*reached through a link/);
    expect(await said(() => moved.write('new', levelText('x'), 'no-file', client))).toMatch(
      /^unknown-folder: .*reached through a link/,
    );
    moved.end();
    away.remove();
  });
});

it('answers have the status codes that the page expects', async () => {
  const server = await serve(made.folder);
  const { page } = server;
  const statuses: Record<string, number> = {};
  const tag = (await page.get(levelPath('01'))).headers.etag as string;
  const post = (path: string, body: object, headers = {}) => page.send('POST', path, { ...body, client }, headers);
  const base = { 'If-Match': tag };
  statuses.list = (await page.get(EDIT_API.LEVELS)).status;
  statuses.read = (await page.get(levelPath('01'))).status;
  statuses.made = (await page.send('PUT', levelPath('new'), { text: levelText('n'), client }, { 'If-None-Match': '*' })).status;
  statuses.written = (await page.send('PUT', levelPath('01'), { text: levelText('A'), client }, base)).status;
  statuses.copied = (await post(EDIT_API.DUPLICATE, { id: '01', to: 'copy' }, base)).status;
  statuses.renamed = (await post(EDIT_API.RENAME, { id: '01', to: 'z' }, base)).status;
  const removed = await post(EDIT_API.DELETE, { id: 'z' }, base);
  statuses.removed = removed.status;
  statuses.trash = (await page.get(EDIT_API.TRASH)).status;
  statuses.restored = (
    await post(EDIT_API.RESTORE, { trash: (removed.json() as { trashed: { trash: string } }).trashed.trash })
  ).status;
  statuses.ordered = (await post(EDIT_API.ORDER, { folder: 'w', ids: ['w/03'] })).status;
  statuses.page = (await page.get('/')).status;
  const headersOf = async (length: number) => (await page.ask({ headers: { 'X-Long': 'x'.repeat(length) } })).status;
  statuses.longHeaders = await headersOf(14_000);
  statuses.longerHeaders = await headersOf(17_000);
  statuses.nothing = (await page.get('/nothing')).status;
  statuses.method = (await page.ask({ method: 'POST', body: '' })).status;
  expect(statuses).toEqual({
    ...{ list: 200, read: 200, made: 201, written: 200, copied: 201, renamed: 200, removed: 200, trash: 200 },
    ...{ restored: 201, ordered: 200, page: 200, longHeaders: 200, longerHeaders: 431, nothing: 404, method: 405 },
  });
  const unreadable = await page.get(levelPath('w/03'));
  expect(unreadable.headers.etag).toBe((unreadable.json() as { etag: string }).etag);
  await server.close();
});
