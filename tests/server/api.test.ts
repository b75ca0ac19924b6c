import { chmodSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import {
  deleteResponseSchema,
  EDIT_API,
  errorResponseSchema,
  listResponseSchema,
  orderResponseSchema,
  readResponseSchema,
  trashResponseSchema,
  writeResponseSchema,
} from '../../schema/index.ts';
import { type Answered, everythingIn, levelPath, levelText, makeFolder, put, serve } from './running.ts';

const client = 'page-1';
let made: ReturnType<typeof makeFolder>;
let server: Awaited<ReturnType<typeof serve>>;

beforeEach(async () => {
  made = makeFolder({
    '02-b.level.json': levelText('B'),
    '10-c.level.json': levelText('C'),
    '1-a.level.json': levelText('A'),
    'world/01-w.level.json': levelText('W'),
    'notes.txt': 'not a level',
    'node_modules/x/n.level.json': levelText('N'),
  });
  server = await serve(made.folder);
});
afterEach(async () => {
  expect(server.crashes).toEqual([]);
  await server.close();
  made.remove();
});

const on = (name: string): string => readFileSync(join(made.folder, name), 'utf8');
const list = async () => listResponseSchema.parse((await server.page.get(EDIT_API.LEVELS)).json());
const ids = async (): Promise<string[]> => (await list()).levels.map(({ id }) => id);
const read = async (id: string) => readResponseSchema.parse((await server.page.get(levelPath(id))).json());
const etag = async (id: string): Promise<string> => (await read(id)).etag ?? '';
const write = (id: string, text: string, headers: Record<string, string>): Promise<Answered> =>
  server.page.send('PUT', levelPath(id), { text, client }, headers);
const post = (path: string, body: object, headers?: Record<string, string>): Promise<Answered> =>
  server.page.send('POST', path, { ...body, client }, headers);
const errorOf = (answer: Answered) => ({ status: answer.status, ...errorResponseSchema.parse(answer.json()).error });

describe('the list', () => {
  it('contains every level below the folder, in order of play', async () => {
    const { levels, folders, troubles, folder } = await list();
    expect(levels.map(({ id, name, status }) => [id, name, status])).toEqual([
      ['1-a', 'A', 'valid'],
      ['02-b', 'B', 'valid'],
      ['10-c', 'C', 'valid'],
      ['world/01-w', 'W', 'valid'],
    ]);
    expect(levels[3].file).toBe(join(made.folder, 'world/01-w.level.json'));
    expect({ folders, troubles }).toEqual({ folders: ['', 'world'], troubles: [] });
    const other = await serve(made.folder);
    expect((await other.page.get(EDIT_API.LEVELS)).json()).toMatchObject({ folder: { id: folder.id } });
    expect(other.page.token).not.toBe(server.page.token);
    await other.close();
  });

  it('contains files that can not be read, with the reason', async () => {
    put(made.folder, 'bad.level.json', '{\n  "version": 1,\n}');
    put(made.folder, 'latin.level.json', Buffer.from([0x7b, 0xe9, 0x7d]));
    put(made.folder, 'large.level.json', ' '.repeat(9 * 1024 * 1024));
    mkdirSync(join(made.folder, 'folder.level.json'));
    symlinkSync('nowhere', join(made.folder, 'lost.level.json'));
    const before = everythingIn(made.folder);
    const { levels } = await list();
    const broken = levels.filter(({ status }) => status !== 'valid');
    expect(broken.map(({ id, status, problems }) => [id, status, problems[0].code])).toEqual([
      ['bad', 'invalid', expect.any(String)],
      ['large', 'unreadable', 'file-too-large'],
      ['latin', 'invalid', 'not-utf8'],
      ['lost', 'unreadable', 'unreadable-file'],
    ]);
    expect(broken[0].problems[0]).toMatchObject({ line: 2, column: expect.any(Number), hint: expect.stringMatching(/./) });
    expect((await read('bad')).text).toBe('{\n  "version": 1,\n}');
    expect((await read('large')).text).toBeNull();
    expect(everythingIn(made.folder)).toEqual(before);
  });

  it('marks files that are not writable', async () => {
    if (process.getuid?.() === 0) return; // root may write everything
    chmodSync(join(made.folder, '02-b.level.json'), 0o444);
    expect((await list()).levels[1].readOnly).toMatch(/permission denied/);
    const answer = await write('02-b', levelText('new'), { 'If-Match': await etag('02-b') });
    expect(errorOf(answer)).toMatchObject({ status: 403, code: 'not-writable' });
  });
});

describe('writing', () => {
  it('stores the text unchanged, and returns its etag', async () => {
    const text = levelText('Ünïcode 🚀').replaceAll('\n', '\r\n');
    chmodSync(join(made.folder, '02-b.level.json'), 0o640);
    const answer = await write('02-b', text, { 'If-Match': await etag('02-b') });
    expect(answer.status).toBe(200);
    const { entry } = writeResponseSchema.parse(answer.json());
    expect(entry).toMatchObject({ id: '02-b', name: 'Ünïcode 🚀', status: 'valid', etag: answer.headers.etag });
    expect(on('02-b.level.json')).toBe(text);
    expect(await etag('02-b')).toBe(entry.etag);
    expect(statSync(join(made.folder, '02-b.level.json')).mode & 0o777).toBe(0o640);
    expect(readdirSync(made.folder).filter((name) => name.startsWith('.'))).toEqual([]);
  });

  it('is refused if the content on the disk differs, which the answer contains', async () => {
    const base = await etag('02-b');
    put(made.folder, '02-b.level.json', levelText('from git'));
    const answer = await write('02-b', levelText('mine'), { 'If-Match': base });
    const { status, code, current } = errorOf(answer);
    expect({ status, code }).toEqual({ status: 412, code: 'conflict' });
    expect(current).toMatchObject({ text: levelText('from git'), name: 'from git' });
    expect(on('02-b.level.json')).toBe(levelText('from git'));
    // based on that content, it succeeds
    expect((await write('02-b', levelText('merged'), { 'If-Match': current?.etag ?? '' })).status).toBe(200);
    expect(on('02-b.level.json')).toBe(levelText('merged'));
  });

  it('is refused if the file is gone, and creates it again on request', async () => {
    const base = await etag('world/01-w');
    rmSync(join(made.folder, 'world/01-w.level.json'));
    const gone = errorOf(await write('world/01-w', levelText('mine'), { 'If-Match': base }));
    expect(gone).toMatchObject({ status: 412, code: 'conflict', current: null });
    expect(existsSync(join(made.folder, 'world/01-w.level.json'))).toBe(false);
    expect((await write('world/01-w', levelText('mine'), { 'If-None-Match': '*' })).status).toBe(201);
    expect(on('world/01-w.level.json')).toBe(levelText('mine'));
  });

  it('accepts the same request twice, as the first answer may have been lost', async () => {
    const base = await etag('02-b');
    const answers = [
      await write('02-b', levelText('new'), { 'If-Match': base }),
      await write('02-b', levelText('new'), { 'If-Match': base }),
      await write('fresh', levelText('new'), { 'If-None-Match': '*' }),
      await write('fresh', levelText('new'), { 'If-None-Match': '*' }),
    ];
    expect(answers.map(({ status }) => status)).toEqual([200, 200, 201, 200]);
    expect(new Set(answers.map(({ headers }) => headers.etag)).size).toBe(1);
  });

  it('refuses an invalid level, with problems and places; a valid text may replace an invalid file', async () => {
    put(made.folder, 'bad.level.json', '{');
    const answer = errorOf(await write('bad', levelText('x').replace('"y": 0', '"y": "0"'), { 'If-Match': await etag('bad') }));
    expect(answer).toMatchObject({ status: 422, code: 'invalid-level' });
    expect(answer.problems?.[0]).toMatchObject({ line: 6, pointer: '/astronaut/y' });
    expect(on('bad.level.json')).toBe('{');
    expect((await write('bad', levelText('mended'), { 'If-Match': await etag('bad') })).status).toBe(200);
    expect(on('bad.level.json')).toBe(levelText('mended'));
  });

  it('creates no name that clashes on other systems, and no folder', async () => {
    const fresh = { 'If-None-Match': '*' };
    expect(errorOf(await write('02-B', levelText('x'), fresh))).toMatchObject({ status: 409, code: 'name-taken' });
    expect(errorOf(await write('nowhere/x', levelText('x'), fresh))).toMatchObject({ status: 404, code: 'unknown-folder' });
    expect(errorOf(await write('con', levelText('x'), fresh))).toMatchObject({ status: 400, code: 'bad-name' });
    expect((await write('world/New level_2', levelText('x'), fresh)).status).toBe(201);
    mkdirSync(join(made.folder, 'taken.level.json'));
    expect(errorOf(await write('taken', levelText('x'), fresh))).toMatchObject({ status: 409, code: 'name-taken' });
  });
});

describe('renaming, copying, deleting', () => {
  it('renames a level, but never to the name of another file', async () => {
    const base = { 'If-Match': await etag('02-b') };
    expect((await post(EDIT_API.RENAME, { id: '02-b', to: 'world/02-b' }, base)).status).toBe(200);
    expect(await ids()).toEqual(['1-a', '10-c', 'world/01-w', 'world/02-b']);
    expect(on('world/02-b.level.json')).toBe(levelText('B'));
    const onto = errorOf(await post(EDIT_API.RENAME, { id: 'world/02-b', to: 'world/01-w' }, base));
    expect(onto).toMatchObject({ status: 409, code: 'name-taken' });
    expect((await post(EDIT_API.RENAME, { id: 'world/02-b', to: 'world/02-B' }, base)).status).toBe(200);
    expect(readdirSync(join(made.folder, 'world')).sort()).toEqual(['01-w.level.json', '02-B.level.json']);
    expect(on('world/01-w.level.json')).toBe(levelText('W'));
  });

  it('copies a valid level', async () => {
    const base = { 'If-Match': await etag('02-b') };
    expect((await post(EDIT_API.DUPLICATE, { id: '02-b', to: '02-b-copy' }, base)).status).toBe(201);
    expect([on('02-b.level.json'), on('02-b-copy.level.json')]).toEqual([levelText('B'), levelText('B')]);
    expect(errorOf(await post(EDIT_API.DUPLICATE, { id: '02-b', to: '10-c' }, base))).toMatchObject({ code: 'name-taken' });
    put(made.folder, 'bad.level.json', '{');
    const bad = await post(EDIT_API.DUPLICATE, { id: 'bad', to: 'worse' }, { 'If-Match': await etag('bad') });
    expect(errorOf(bad)).toMatchObject({ status: 422, code: 'invalid-level' });
    expect(on('10-c.level.json')).toBe(levelText('C'));
  });

  it('keeps every deleted level and restores it, but never over another file', async () => {
    const base = { 'If-Match': await etag('world/01-w') };
    const { trashed } = deleteResponseSchema.parse((await post(EDIT_API.DELETE, { id: 'world/01-w' }, base)).json());
    await write('world/01-w', levelText('W'), { 'If-None-Match': '*' });
    await post(EDIT_API.DELETE, { id: 'world/01-w' }, base);
    await write('world/01-w', levelText('W2'), { 'If-None-Match': '*' });
    const { trash } = trashResponseSchema.parse((await server.page.get(EDIT_API.TRASH)).json());
    expect(trash.map(({ id }) => id)).toEqual(['world/01-w', 'world/01-w']);
    expect(trash[1]).toEqual(trashed);
    expect(Number.isNaN(Date.parse(trashed.deleted))).toBe(false);
    expect(on('.gq-trash/.gitignore')).toBe('*\n');

    const onto = errorOf(await post(EDIT_API.RESTORE, { trash: trashed.trash }));
    expect(onto).toMatchObject({ status: 409, code: 'name-taken' });
    const back = await post(EDIT_API.RESTORE, { trash: trashed.trash, to: 'world/01-w-old' });
    expect(back.status).toBe(201);
    expect(on('world/01-w-old.level.json')).toBe(levelText('W'));
    expect(on('world/01-w.level.json')).toBe(levelText('W2'));
    expect((await post(EDIT_API.RESTORE, { trash: trashed.trash })).status).toBe(404);
    expect(trashResponseSchema.parse((await server.page.get(EDIT_API.TRASH)).json()).trash).toHaveLength(1);
  });

  it('refuses to delete if the trash is a link', async () => {
    const outside = makeFolder({});
    symlinkSync(outside.folder, join(made.folder, '.gq-trash'));
    const answer = await post(EDIT_API.DELETE, { id: '02-b' }, { 'If-Match': await etag('02-b') });
    expect(errorOf(answer)).toMatchObject({ status: 403, code: 'not-writable' });
    expect(on('02-b.level.json')).toBe(levelText('B'));
    expect(everythingIn(outside.folder)).toEqual({});
    outside.remove();
  });
});

describe('the order', () => {
  it('is that of the names, whose numbers are reassigned', async () => {
    const answer = await post(EDIT_API.ORDER, { folder: '', ids: ['10-c', '1-a', '02-b'] });
    const { renamed, levels } = orderResponseSchema.parse(answer.json());
    expect(renamed).toEqual([
      { from: '10-c', to: '01-c' },
      { from: '1-a', to: '02-a' },
      { from: '02-b', to: '10-b' },
    ]);
    expect(levels.map(({ id, name }) => [id, name])).toEqual([
      ['01-c', 'C'],
      ['02-a', 'A'],
      ['10-b', 'B'],
      ['world/01-w', 'W'],
    ]);
  });

  it('can exchange names in a cycle', async () => {
    for (const n of [1, 2, 3]) put(made.folder, `ring/0${n}.level.json`, levelText(`${n}`));
    const answer = await post(EDIT_API.ORDER, { folder: 'ring', ids: ['ring/03', 'ring/01', 'ring/02'] });
    expect(answer.status).toBe(200);
    expect([1, 2, 3].map((n) => on(`ring/0${n}.level.json`))).toEqual(['3', '1', '2'].map((name) => levelText(name)));
    expect(readdirSync(join(made.folder, 'ring'))).toHaveLength(3);
  });

  it('is refused if the ids are not those of the folder', async () => {
    for (const wrong of [['1-a', '02-b'], ['1-a', '02-b', '02-b'], ['1-a', '02-b', 'world/01-w'], []]) {
      expect(errorOf(await post(EDIT_API.ORDER, { folder: '', ids: wrong }))).toMatchObject({
        status: 409,
        code: 'list-changed',
      });
    }
    expect(await ids()).toEqual(['1-a', '02-b', '10-c', 'world/01-w']);
  });
});

describe('the page', () => {
  it('is served from a list of its files, with a strict policy', async () => {
    const [root, index, script] = await Promise.all(
      ['/', '/index.html', '/assets/index-abc.js'].map((path) => server.page.get(path)),
    );
    expect(root.text).toBe(index.text);
    expect(script).toMatchObject({ status: 200, text: 'export {};\n' });
    expect(script.headers).toMatchObject({
      'content-type': 'text/javascript; charset=utf-8',
      'cache-control': expect.stringContaining('immutable'),
    });
    for (const { headers } of [root, script, await server.page.get(EDIT_API.LEVELS), await server.page.get('/nothing')]) {
      expect(headers).toMatchObject({
        'x-content-type-options': 'nosniff',
        'x-frame-options': 'DENY',
        'cross-origin-opener-policy': 'same-origin',
        'cross-origin-resource-policy': 'same-origin',
      });
      const policy = String(headers['content-security-policy']);
      expect(policy).toContain("default-src 'none'; script-src 'self';");
      expect(policy).toContain("frame-ancestors 'none'");
      expect(headers).not.toHaveProperty('access-control-allow-origin');
    }
    const again = await server.page.ask({ headers: { 'If-None-Match': String(root.headers.etag) } });
    expect(again).toMatchObject({ status: 304, text: '' });
  });
});
