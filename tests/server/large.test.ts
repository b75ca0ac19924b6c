import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { expect } from 'vitest';
import { createEventStreams } from '../../cli/serve/event-stream.ts';
import type { KnownLevels } from '../../cli/serve/known-levels.ts';
import { openLevelFolder } from '../../cli/serve/level-folder.ts';
import { NO_FOLDER_TERMS } from '../../editor/core/files/folder-list.ts';
import { EDIT_API, type EditEvent, type LevelEntry, type ListResponse } from '../../schema/index.ts';
import { itQuick as it, itDeep } from '../depth.ts';
import { levelPath, levelText, makeFolder, put, serve } from './running.ts';

const entry = (id: string): LevelEntry => ({
  id,
  file: `${id}.level.json`,
  etag: null,
  status: 'unreadable',
  name: null,
  problems: [],
  readOnly: null,
});

const listOf = (levels: LevelEntry[]): ListResponse => ({
  folder: { id: 'f', path: 'levels', $schema: null },
  folders: [''],
  levels,
  terms: NO_FOLDER_TERMS,
  troubles: [],
  unread: 0,
});

/** Reads events from a stream until one passes. */
async function readUntil(stream: ReadableStream<Uint8Array>, passes: (event: EditEvent) => boolean): Promise<EditEvent[]> {
  const heard: EditEvent[] = [];
  const reader = stream.pipeThrough(new TextDecoderStream() as ReadableWritablePair<string, Uint8Array>).getReader();
  let rest = '';
  for (;;) {
    const { value, done } = await reader.read();
    if (done) return heard;
    // a list comes in hundreds of chunks: only those that can end an event are searched together with what came before
    const ends = value.includes('\n\n') || (value.startsWith('\n') && rest.endsWith('\n'));
    rest += value;
    if (!ends) continue;
    const parts = rest.split('\n\n');
    rest = parts.pop() ?? '';
    for (const part of parts) if (part.startsWith('data: ')) heard.push(JSON.parse(part.slice('data: '.length)));
    if (heard.length > 0 && passes(heard[heard.length - 1])) {
      await reader.cancel();
      return heard;
    }
  }
}

it('a page that reads nothing is disconnected in the end, and others get everything', async () => {
  const listeners = new Set<(event: EditEvent) => void>();
  const known = {
    list: () => listOf([entry('a')]),
    listen(listener: (event: EditEvent) => void) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  } as unknown as KnownLevels;
  const streams = createEventStreams(known);
  const asleep = streams.open();
  const awake = readUntil(streams.open(), (event) => event.type === 'changed' && event.entry.id === 'last');
  const long = { ...entry('x'), file: 'x'.repeat(2000) };
  for (let i = 0; i < 12_000; i++) {
    for (const listener of [...listeners]) listener({ type: 'changed', entry: long, by: null });
    if (i % 100 === 0) await new Promise(setImmediate);
  }
  expect(listeners.size).toBe(1);
  for (const listener of [...listeners]) listener({ type: 'changed', entry: entry('last'), by: null });
  expect(await awake).toHaveLength(12_002);
  // it ends without an error
  const rest = await readUntil(asleep, () => false);
  expect(rest[0]).toEqual({ type: 'list', list: listOf([entry('a')]) });
  expect(rest.length).toBeLessThan(12_002);
});

itDeep('a list of more than 16 MiB is sent to all, and later saves are answered and reported', async () => {
  // each with 20 long problems
  const broken = JSON.stringify({
    ...JSON.parse(levelText('x')),
    novae: Array(25).fill({ x: 'x'.repeat(50), y: 0, radius: 1 }),
  });
  const files = Object.fromEntries(Array.from({ length: 3800 }, (_, i) => [`${i}.level.json`, broken]));
  const made = makeFolder({ ...files, 'a.level.json': levelText('a') });
  const server = await serve(made.folder);
  const headers = { [EDIT_API.TOKEN_HEADER]: server.page.token, 'Sec-Fetch-Site': 'same-origin' };
  const events = async (): Promise<ReadableStream<Uint8Array>> =>
    (await fetch(`http://127.0.0.1:${server.port}${EDIT_API.EVENTS}`, { headers })).body as ReadableStream<Uint8Array>;
  const isWhole = (event: EditEvent): boolean =>
    (event.type === 'list' && event.list.unread === 0) || (event.type === 'read' && event.unread === 0);

  const heard = await readUntil(await events(), isWhole);
  const ids = heard.flatMap((event) => (event.type === 'list' ? event.list.levels : event.type === 'read' ? event.levels : []));
  expect(new Set(ids.map(({ id }) => id)).size).toBe(3801);
  const list = await server.page.get(EDIT_API.LEVELS);
  expect(list.text.length).toBeGreaterThan(16 * 1024 * 1024);
  expect(list.json()).toMatchObject({ unread: 0 });

  const listening = readUntil(await events(), (event) => event.type === 'changed' && event.entry.id === 'b');
  const { etag } = (await server.page.get(levelPath('a'))).json() as { etag: string };
  const answer = await server.page.send('PUT', levelPath('a'), { text: levelText('new'), client: 'c' }, { 'If-Match': etag });
  expect(answer.status).toBe(200);
  put(made.folder, 'b.level.json', levelText('b'));
  const later = (await listening).filter(({ type }) => type === 'changed');
  expect(later).toMatchObject([
    { entry: { id: 'a', name: 'new' }, by: 'c' },
    { entry: { id: 'b' }, by: null },
  ]);
  expect(server.crashes).toEqual([]);
  await server.close();
  made.remove();
});

it('a level that changes during the first reading is reported in its new state, and each level once', async () => {
  const made = makeFolder(Object.fromEntries(Array.from({ length: 3000 }, (_, i) => [`${i}.level.json`, levelText(`${i}`)])));
  const levels = openLevelFolder(made.folder, 'levels');
  const page = new Map<string, string | null>();
  const hear = (all: readonly LevelEntry[]): void => {
    for (const { id, name } of all) {
      expect(page.has(id), id).toBe(false);
      page.set(id, name);
    }
  };
  const { levels: begun, unread } = levels.known.list();
  expect([begun.length, unread]).toEqual([500, 2500]);
  hear(begun);
  const whole = new Promise<void>((resolve) => {
    levels.known.listen((event) => {
      if (event.type === 'read') {
        hear(event.levels);
        if (event.unread === 0) resolve();
      }
      if (event.type === 'changed') page.set(event.entry.id, event.entry.name);
      if (event.type === 'removed') page.delete(event.id);
    });
  });
  const change = async (id: string): Promise<unknown> =>
    levels.write(id, levelText('changed'), { etag: levels.read(id).etag ?? '' }, 'c');
  await Promise.all([change('7'), change('2990'), levels.write('new', levelText('new'), 'no-file', 'c')]);
  rmSync(join(made.folder, '2991.level.json'));
  levels.known.announce(['2991'], null);
  await whole;
  const now = await levels.known.refresh();
  expect(now.unread).toBe(0);
  expect(now.levels.map(({ id }) => id)).toEqual([
    ...Array.from({ length: 3000 }, (_, i) => `${i}`).filter((id) => id !== '2991'),
    'new',
  ]);
  expect([...page.keys()].sort()).toEqual(now.levels.map(({ id }) => id).sort());
  for (const id of ['7', '2990']) expect(page.get(id)).toBe('changed');
  levels.end();
  made.remove();
});
