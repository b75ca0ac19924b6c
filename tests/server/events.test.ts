import { execFileSync } from 'node:child_process';
import { mkdirSync, renameSync, rmSync } from 'node:fs';
import { get } from 'node:http';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { EDIT_API, type EditEvent, editEventSchema, type ReadResponse } from '../../schema/index.ts';
import { levelPath, levelText, makeFolder, put, serve } from './running.ts';

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

interface Listener {
  /** The next event that passes; skips earlier ones. */
  until(passes: (event: EditEvent) => boolean): Promise<EditEvent>;
  /** All events so far. */
  readonly heard: readonly EditEvent[];
  end(): void;
}

function listen(): Promise<Listener> {
  return new Promise((resolve, reject) => {
    const headers = { [EDIT_API.TOKEN_HEADER]: server.page.token, 'Sec-Fetch-Site': 'same-origin' };
    const request = get({ host: '127.0.0.1', port: server.port, path: EDIT_API.EVENTS, headers, agent: false }, (answer) => {
      expect(answer.headers['content-type']).toBe('text/event-stream');
      const heard: EditEvent[] = [];
      const waiting = new Set<() => void>();
      let rest = '';
      answer.setEncoding('utf8');
      answer.on('error', () => {});
      answer.on('data', (data: string) => {
        const parts = (rest + data).split('\n\n');
        rest = parts.pop() ?? '';
        for (const part of parts)
          if (!part.startsWith(':')) heard.push(editEventSchema.parse(JSON.parse(part.slice('data: '.length))));
        for (const look of waiting) look();
      });
      let from = 0;
      const until: Listener['until'] = (passes) =>
        new Promise((found) => {
          const look = (): void => {
            const at = heard.findIndex((event, i) => i >= from && passes(event));
            if (at < 0) return;
            from = at + 1;
            waiting.delete(look);
            found(heard[at]);
          };
          waiting.add(look);
          look();
        });
      resolve({ until, heard, end: () => request.destroy() });
    });
    request.on('error', reject);
  });
}

const read = async (id: string): Promise<ReadResponse> => (await server.page.get(levelPath(id))).json();

it('the list comes first, then the changes by others: change, create, rename, delete', async () => {
  const listener = await listen();
  expect(await listener.until(() => true)).toMatchObject({ type: 'list', list: { levels: [{ id: 'a' }, { id: 'sub/b' }] } });

  put(made.folder, 'a.level.json', levelText('A2'));
  const changed = await listener.until((e) => e.type === 'changed' && e.entry.name === 'A2');
  expect(changed).toMatchObject({ entry: { id: 'a', etag: (await read('a')).etag }, by: null });

  put(made.folder, 'sub/deeper/c.level.json', levelText('C'));
  expect(await listener.until((e) => e.type === 'changed')).toMatchObject({ entry: { id: 'sub/deeper/c', name: 'C' }, by: null });
  expect(await listener.until((e) => e.type === 'list')).toMatchObject({ list: { folders: ['', 'sub', 'sub/deeper'] } });

  renameSync(join(made.folder, 'a.level.json'), join(made.folder, 'z.level.json'));
  expect(await listener.until((e) => e.type === 'renamed')).toMatchObject({
    from: 'a',
    entry: { id: 'z', name: 'A2' },
    by: null,
  });

  put(made.folder, 'z.level.json', '{ "version"');
  expect(await listener.until((e) => e.type === 'changed' && e.entry.id === 'z')).toMatchObject({
    entry: { status: 'invalid', name: null },
  });

  rmSync(join(made.folder, 'sub'), { recursive: true });
  await listener.until((e) => e.type === 'removed' && e.id === 'sub/b');
  listener.end();
});

it("a page's own changes carry its name, and are reported once to every page", async () => {
  const [one, two] = await Promise.all([listen(), listen()]);
  const { etag } = await read('a');
  const answer = await server.page.send(
    'PUT',
    levelPath('a'),
    { text: levelText('mine'), client: 'page-1' },
    { 'If-Match': etag ?? '' },
  );
  const tag = String(answer.headers.etag);
  await server.page.send('POST', EDIT_API.RENAME, { id: 'a', to: 'c', client: 'page-1' }, { 'If-Match': tag });
  await server.page.send('POST', EDIT_API.DELETE, { id: 'c', client: 'page-2' }, { 'If-Match': tag });
  // when this event arrives, the watcher has seen the earlier changes, too
  put(made.folder, 'last.level.json', levelText('last'));
  for (const listener of [one, two]) {
    await listener.until((e) => e.type === 'changed' && e.entry.id === 'last');
    expect(listener.heard.slice(1)).toMatchObject([
      { type: 'changed', entry: { id: 'a', etag: tag }, by: 'page-1' },
      { type: 'renamed', from: 'a', entry: { id: 'c' }, by: 'page-1' },
      { type: 'removed', id: 'c', by: 'page-2' },
      { type: 'changed', entry: { id: 'last' }, by: null },
    ]);
    listener.end();
  }
});

it('the changes of a checkout are reported', async () => {
  const git = (...args: string[]) =>
    execFileSync('git', ['-c', 'user.name=t', '-c', 'user.email=t@example.org', '-c', 'commit.gpgsign=false', ...args], {
      cwd: made.folder,
      stdio: 'ignore',
    });
  git('init');
  git('add', '.');
  git('commit', '-m', 'one');
  git('checkout', '-b', 'other');
  for (let i = 0; i < 20; i++) put(made.folder, `many-${i}.level.json`, levelText(`${i}`));
  put(made.folder, 'a.level.json', levelText('other'));
  git('add', '.');
  git('commit', '-m', 'two');
  // git blocks this process, including the server, which never sees changes that are undone before git ends
  const lookNow = () => server.page.get(EDIT_API.LEVELS);
  await lookNow();
  const listener = await listen();
  git('checkout', '-');
  await listener.until((e) => e.type === 'changed' && e.entry.id === 'a' && e.entry.name === 'A');
  await lookNow();
  git('checkout', 'other');
  await listener.until((e) => e.type === 'changed' && e.entry.id === 'many-19');
  listener.end();
});

it('a folder that vanishes and comes back is reported', async () => {
  const listener = await listen();
  const away = `${made.folder}-away`;
  renameSync(made.folder, away);
  expect((await server.page.get(EDIT_API.LEVELS)).json()).toMatchObject({
    levels: [],
    troubles: [expect.stringMatching(/no such file/)],
  });
  await listener.until((e) => e.type === 'list' && e.list.troubles.length > 0);
  const answer = await server.page.send('PUT', levelPath('new'), { text: levelText('x'), client: 'c' }, { 'If-None-Match': '*' });
  expect(answer.status).toBe(404);
  mkdirSync(made.folder);
  rmSync(made.folder, { recursive: true });
  renameSync(away, made.folder);
  await server.page.get(EDIT_API.LEVELS);
  await listener.until((e) => e.type === 'list' && e.list.troubles.length === 0);
  listener.end();
});

it('closed pages are forgotten: many may connect one after the other, but not too many at once', async () => {
  for (let i = 0; i < 40; i++) {
    const listener = await listen();
    await listener.until(() => true);
    listener.end();
    // the place is free once the server has noticed the end
    while ((await server.page.get(EDIT_API.TRASH)).status !== 200);
  }
  const listeners = await Promise.all(Array.from({ length: 20 }, listen));
  for (const listener of listeners) listener.end();
});

it('pack.json: by a page, by another program, and when it is gone', async () => {
  const events = await listen();
  await events.until(({ type }) => type === 'list');
  const text = (...levels: string[]) => JSON.stringify({ version: 1, name: 'Test', levels });
  const of = (wanted: string | null) => (event: EditEvent) => event.type === 'pack' && (event.pack?.text ?? null) === wanted;
  await server.page.send('PUT', EDIT_API.PACK, { text: text('a'), client: 'me' }, { 'If-None-Match': '*' });
  expect(await events.until(of(text('a')))).toMatchObject({ by: 'me' });
  put(made.folder, 'pack.json', text('sub/b', 'a'));
  expect(await events.until(of(text('sub/b', 'a')))).toMatchObject({ by: null });
  rmSync(join(made.folder, 'pack.json'));
  expect(await events.until(of(null))).toMatchObject({ by: null });
  events.end();
});
