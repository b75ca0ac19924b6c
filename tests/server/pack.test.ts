import { existsSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { EDIT_API, errorResponseSchema, type ListResponse, listResponseSchema, packResponseSchema } from '../../schema/index.ts';
import { levelText, makeFolder, put, serve } from './running.ts';

let made: ReturnType<typeof makeFolder>;
let server: Awaited<ReturnType<typeof serve>>;
beforeEach(async () => {
  made = makeFolder({ 'a.level.json': levelText('A'), 'sub/b.level.json': levelText('B') });
  server = await serve(made.folder);
});
afterEach(async () => {
  expect(server.crashes).toEqual([]);
  await server.close();
  made.remove();
});

const text = (...levels: string[]): string => JSON.stringify({ version: 1, name: 'Test', levels });
const onDisk = (): string | null => {
  const path = join(made.folder, 'pack.json');
  return existsSync(path) ? readFileSync(path, 'utf8') : null;
};
const list = async (): Promise<ListResponse> => listResponseSchema.parse((await server.page.get(EDIT_API.LEVELS)).json());
const write = (content: string | null, base: string | null) =>
  server.page.send(
    'PUT',
    EDIT_API.PACK,
    { text: content, client: 'me' },
    base === null ? { 'If-None-Match': '*' } : { 'If-Match': base },
  );
const written = async (content: string | null, base: string | null) => {
  const answer = await write(content, base);
  expect([answer.status, answer.text]).toEqual([200, expect.any(String)]);
  return packResponseSchema.parse(answer.json()).pack;
};
const refused = async (content: string | null, base: string | null) => {
  const answer = await write(content, base);
  const { code, message } = errorResponseSchema.parse(answer.json()).error;
  return [answer.status, code, message];
};

it('pack.json is listed, written as it is sent, and removed; it is no level', async () => {
  expect(await list()).not.toHaveProperty('pack');
  const first = await written(text('sub/b', 'a'), null);
  expect(first).toMatchObject({ text: text('sub/b', 'a'), readOnly: null });
  expect(onDisk()).toBe(text('sub/b', 'a'));
  const known = await list();
  expect(known.pack).toEqual(first);
  expect(known.levels.map(({ id }) => id)).toEqual(['a', 'sub/b']);
  const second = await written(text('a'), first?.etag ?? null);
  expect(onDisk()).toBe(text('a'));
  expect(await written(null, second?.etag ?? null)).toBe(null);
  expect([onDisk(), await list()]).toEqual([null, expect.not.objectContaining({ pack: expect.anything() })]);
});

it('what is not valid, and what was made from another content, is refused, and nothing changes', async () => {
  expect((await refused('{ "version": 1 }', null)).slice(0, 2)).toEqual([422, 'invalid-pack']);
  expect(onDisk()).toBe(null);
  const first = await written(text('a'), null);
  expect((await refused(text('sub/b'), null)).slice(0, 2)).toEqual([412, 'conflict']);
  writeFileSync(join(made.folder, 'pack.json'), text('a', 'sub/b'));
  for (const content of [text('sub/b'), null])
    expect((await refused(content, first?.etag ?? '')).slice(0, 2)).toEqual([412, 'conflict']);
  expect(onDisk()).toBe(text('a', 'sub/b'));
  expect((await list()).pack?.text).toBe(text('a', 'sub/b'));
  // a repeated request, whose first answer was lost
  expect((await written(text('a', 'sub/b'), first?.etag ?? ''))?.text).toBe(text('a', 'sub/b'));
  const bare = await server.page.send('PUT', EDIT_API.PACK, { text: text('a'), client: 'me' });
  expect(bare.status).toBe(428);
  expect((await server.page.send('PUT', EDIT_API.PACK, { text: 3, client: 'me' }, { 'If-None-Match': '*' })).status).toBe(400);
});

it('a foreign page changes nothing', async () => {
  const headers = { Origin: 'https://example.com', 'Sec-Fetch-Site': 'cross-site', 'If-None-Match': '*' };
  const answer = await server.page.send('PUT', EDIT_API.PACK, { text: text('a'), client: 'me' }, headers);
  expect([answer.status, onDisk()]).toEqual([403, null]);
});

it('a link is listed and not followed, a folder of that name is none, and what is not valid is listed as it is', async () => {
  const outside = makeFolder({ 'pack.json': text('a') });
  symlinkSync(join(outside.folder, 'pack.json'), join(made.folder, 'pack.json'));
  const { pack } = await list();
  expect(pack).toMatchObject({ etag: null, text: null, readOnly: expect.stringContaining('symbolic link') });
  expect((await refused(text('sub/b'), `"${'0'.repeat(64)}"`))[0]).toBe(412);
  expect(readFileSync(join(outside.folder, 'pack.json'), 'utf8')).toBe(text('a'));
  outside.remove();
  rmSync(join(made.folder, 'pack.json'));
  put(made.folder, 'pack.json', '{ not json');
  expect((await list()).pack?.text).toBe('{ not json');
  rmSync(join(made.folder, 'pack.json'));
  put(made.folder, 'pack.json/inside.txt', '');
  expect(await list()).not.toHaveProperty('pack');
});
