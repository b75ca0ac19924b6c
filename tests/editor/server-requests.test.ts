import fc from 'fast-check';
import { beforeEach, describe, expect, it } from 'vitest';
import { type Answer, createServerStorage, type LevelStorage } from '../../editor/core/files/index.ts';
import type { EditEvent, LevelEntry } from '../../schema/index.ts';
import { breathe, TurnedClock } from './stage.ts';

const ETAG = `"${'0'.repeat(64)}"`;
const entry = (id: string): LevelEntry => ({
  ...{ id, file: `${id}.level.json`, etag: ETAG, status: 'valid', name: id, problems: [], readOnly: null },
});

interface Request {
  readonly address: string;
  readonly method: string | undefined;
  readonly headers: Record<string, string>;
  readonly body: unknown;
  readonly cache: string | undefined;
}

let requests: Request[];
let answer: (signal?: AbortSignal | null) => Response | Promise<Response>;
let clock: TurnedClock;
const json = (value: unknown, status = 200) => new Response(JSON.stringify(value), { status });

const storageWith = (token = 'secret'): LevelStorage =>
  createServerStorage({
    origin: 'http://127.0.0.1:4747',
    token,
    key: { learn: async () => {}, renew: async () => null },
    client: 'page-1',
    timers: clock,
    fetch: async (address, init) => {
      requests.push({
        address: String(address),
        method: init?.method,
        headers: init?.headers as Record<string, string>,
        body: init?.body === undefined ? undefined : JSON.parse(String(init.body)),
        cache: init?.cache,
      });
      return answer(init?.signal);
    },
  });

beforeEach(() => {
  requests = [];
  clock = new TurnedClock();
});

describe('requests', () => {
  const list = {
    folder: { id: 'f', path: 'levels', $schema: null },
    folders: [''],
    levels: [entry('a')],
    terms: { file: null, accuracy: 'precise', maxTime: 60, maxWork: 400_000, rules: {}, problems: [] },
    troubles: [],
    unread: 0,
  };
  const trashed = { trash: 't/a', id: 'a', deleted: '2026-01-01T00:00:00.000Z' };
  const base = { 'If-Match': ETAG };

  it.each<
    [name: string, ask: (storage: LevelStorage) => Promise<Answer<unknown>>, said: unknown, value: unknown, request: object]
  >([
    ['list', (s) => s.list(), list, list, { method: 'GET', address: 'levels' }],
    [
      'read',
      (s) => s.read('w/ü?'),
      { ...entry('a'), text: 'x' },
      { ...entry('a'), text: 'x' },
      { method: 'GET', address: 'level?id=w%2F%C3%BC%3F' },
    ],
    [
      'write',
      (s) => s.write('a', 'x', ETAG),
      { entry: entry('a') },
      entry('a'),
      { method: 'PUT', address: 'level?id=a', more: base, body: { text: 'x', client: 'page-1' } },
    ],
    [
      'make',
      (s) => s.write('a', 'x', null),
      { entry: entry('a') },
      entry('a'),
      { method: 'PUT', address: 'level?id=a', more: { 'If-None-Match': '*' }, body: { text: 'x', client: 'page-1' } },
    ],
    [
      'rename',
      (s) => s.rename('a', 'b', ETAG),
      { entry: entry('b') },
      entry('b'),
      { method: 'POST', address: 'rename', more: base, body: { id: 'a', to: 'b', client: 'page-1' } },
    ],
    [
      'duplicate',
      (s) => s.duplicate('a', 'b', ETAG),
      { entry: entry('b') },
      entry('b'),
      { method: 'POST', address: 'duplicate', more: base, body: { id: 'a', to: 'b', client: 'page-1' } },
    ],
    [
      'remove',
      (s) => s.remove('a', ETAG),
      { trashed },
      { trashed },
      { method: 'POST', address: 'delete', more: base, body: { id: 'a', client: 'page-1' } },
    ],
    ['trash', (s) => s.trash(), { trash: [trashed] }, [trashed], { method: 'GET', address: 'trash' }],
    [
      'restore',
      (s) => s.restore('t/a'),
      { entry: entry('a') },
      entry('a'),
      { method: 'POST', address: 'restore', more: {}, body: { trash: 't/a', client: 'page-1' } },
    ],
    [
      'restore elsewhere',
      (s) => s.restore('t/a', 'b'),
      { entry: entry('b') },
      entry('b'),
      { method: 'POST', address: 'restore', more: {}, body: { trash: 't/a', to: 'b', client: 'page-1' } },
    ],
    [
      'order',
      (s) => s.order('w', ['b', 'a']),
      { renamed: [], levels: [] },
      { renamed: [], levels: [] },
      { method: 'POST', address: 'order', more: {}, body: { folder: 'w', ids: ['b', 'a'], client: 'page-1' } },
    ],
  ])(
    '%s',
    async (_, ask, said, value, {
      method,
      address,
      more,
      body,
    }: { method?: string; address?: string; more?: object; body?: unknown }) => {
      answer = () => json(said);
      expect(await ask(storageWith())).toEqual({ ok: true, value });
      const type = body === undefined ? {} : { 'Content-Type': 'application/json' };
      expect(requests).toEqual([
        {
          address: `http://127.0.0.1:4747/api/${address}`,
          method,
          headers: { 'x-gq-token': 'secret', ...type, ...more },
          body,
          cache: 'no-store',
        },
      ]);
      // refusals
      const error = { code: 'conflict', message: 'why', hint: 'do' };
      answer = () => json({ error: { ...error, problems: [], current: null } }, 412);
      expect(await ask(storageWith())).toEqual({ ok: false, error: { ...error, problems: [], current: null } });
      answer = () => json({ error }, 412);
      expect(await ask(storageWith())).toEqual({ ok: false, error: { ...error, problems: [], current: null } });
      // answers that are not understood
      for (const [status, odd] of [
        [200, { error }],
        [200, 7],
        [412, said],
        [500, { error: 'no' }],
      ] as const) {
        answer = () => json(odd, status);
        expect(await ask(storageWith())).toMatchObject({
          ok: false,
          error: {
            code: 'unexpected',
            message: expect.stringContaining(`(${status})`),
            hint: expect.stringContaining('version'),
          },
        });
      }
      for (const silent of [() => Promise.reject(new TypeError('failed')), () => new Response('<html>')]) {
        answer = silent;
        expect(await ask(storageWith())).toMatchObject({ ok: false, error: { code: 'unreachable' } });
      }
    },
  );

  it('without the right token say which address to open', async () => {
    const error = { code: 'wrong-token', message: 'another run', hint: 'as the server has it' };
    answer = () => json({ error }, 401);
    const hint = expect.stringContaining('Open the address that gq edit printed last');
    expect(await storageWith().list()).toMatchObject({ ok: false, error: { code: 'wrong-token', message: 'another run', hint } });
    expect(await storageWith('').list()).toMatchObject({
      ok: false,
      error: { code: 'wrong-token', message: expect.stringContaining('lacks the key'), hint },
    });
  });
});

describe('the stream of events', () => {
  /** A server whose streams a test feeds; each request gets its own stream. */
  function stream() {
    const streams: ReadableStreamDefaultController<Uint8Array>[] = [];
    answer = (signal) =>
      new Response(
        new ReadableStream<Uint8Array>({
          start(controller) {
            streams.push(controller);
            signal?.addEventListener('abort', () => controller.error(new DOMException('aborted', 'AbortError')));
          },
        }),
      );
    const events: EditEvent[] = [];
    const links: string[] = [];
    const stop = storageWith().watch(
      (event) => events.push(event),
      (link) => links.push(link),
    );
    const send = async (bytes: Uint8Array | string) => {
      streams.at(-1)?.enqueue(typeof bytes === 'string' ? new TextEncoder().encode(bytes) : bytes);
      await breathe();
    };
    return { streams, events, links, stop, send };
  }
  const changed = (id: string, by: string | null = null): EditEvent => ({ type: 'changed', entry: entry(id), by });
  const block = (event: EditEvent) => `data: ${JSON.stringify(event)}\n\n`;

  it('is reported in order, however it is cut; unknown events and those of the page itself are skipped', async () => {
    const part = fc.oneof(
      fc.constantFrom('a', 'bü🚀').map((id) => ({ text: block(changed(id)), told: [id] })),
      fc.constant({ text: `event: x\nid: 7\n${block(changed('named'))}`, told: ['named'] }),
      fc.constant({
        text: `data:${JSON.stringify(changed('c', 'page-2'), null, 1).replaceAll('\n', '\ndata: ')}\n\n`,
        told: ['c'],
      }),
      fc
        .constantFrom(
          ': still here\n\n',
          'event: x\n\n',
          'data: {"type":"other"}\n\n',
          'data: {\n\n',
          'data:\n\n',
          '\n\n',
          block(changed('mine', 'page-1')),
        )
        .map((text) => ({ text, told: [] as string[] })),
    );
    await fc.assert(
      fc.asyncProperty(fc.array(part, { maxLength: 6 }), fc.array(fc.nat(400), { maxLength: 5 }), async (parts, cuts) => {
        requests = [];
        const { events, links, stop, send } = stream();
        await breathe();
        const bytes = new TextEncoder().encode(parts.map(({ text }) => text).join(''));
        const places = [0, ...cuts.map((cut) => cut % (bytes.length + 1)).sort((a, b) => a - b), bytes.length];
        for (const [i, place] of places.slice(1).entries()) await send(bytes.slice(places[i], place));
        expect(events.map((event) => event.type === 'changed' && event.entry.id)).toEqual(parts.flatMap(({ told }) => told));
        expect(links).toEqual(['up']);
        expect(requests).toEqual([
          expect.objectContaining({
            address: 'http://127.0.0.1:4747/api/events',
            headers: { 'x-gq-token': 'secret' },
            cache: 'no-store',
          }),
        ]);
        stop();
      }),
      { numRuns: 60 },
    );
  });

  it('is opened again after 0.25, 0.5, 1, 2 and 5 s, and then every 5 s without an answer', async () => {
    const times: number[] = [];
    answer = () => {
      times.push(clock.now());
      return Promise.reject(new TypeError('failed'));
    };
    const links: string[] = [];
    const stop = storageWith().watch(
      () => {},
      (link) => links.push(link),
    );
    await clock.pass(20_000);
    expect(times).toEqual([0, 250, 750, 1750, 3750, 8750, 13_750, 18_750]);
    expect(links).toEqual(['gone']);
    stop();
    await clock.pass(20_000);
    expect(times).toHaveLength(8);
  });

  it('is opened again when it ends; the first data reset the intervals', async () => {
    const { streams, events, links, send, stop } = stream();
    await breathe();
    for (let i = 0; i < 4; i++) {
      await send(block(changed(`${i}`)));
      streams.at(-1)?.close();
      await clock.pass(249);
      expect(streams).toHaveLength(i + 1);
      await clock.pass(1);
      expect(streams).toHaveLength(i + 2);
    }
    expect(events).toHaveLength(4);
    expect(links).toEqual(['up', 'gone', 'up', 'gone', 'up', 'gone', 'up', 'gone', 'up']);
    stop();
  });

  it('is given up after 25 s of silence, but not if it sends heartbeats', async () => {
    const { streams, links, send, stop } = stream();
    await breathe();
    for (let i = 0; i < 5; i++) {
      await clock.pass(24_000);
      await send(': still here\n\n');
    }
    expect([streams.length, links]).toEqual([1, ['up']]);
    await clock.pass(24_999);
    expect(streams).toHaveLength(1);
    await clock.pass(1 + 250);
    expect([streams.length, links]).toEqual([2, ['up', 'gone', 'up']]);
    stop();
  });

  it('has no effect on a later stream once it has ended', async () => {
    const { streams, send, stop } = stream();
    await breathe();
    await send(': still here\n\n');
    streams.at(-1)?.close();
    for (let i = 0; i < 4; i++) {
      await clock.pass(10_000);
      await send(': still here\n\n');
    }
    expect(streams).toHaveLength(2);
    stop();
  });

  it('is still requested from a server of another run, and the state stays reported', async () => {
    answer = () => json({ error: { code: 'wrong-token', message: '', hint: '' } }, 401);
    const links: string[] = [];
    const stop = storageWith().watch(
      () => {},
      (link) => links.push(link),
    );
    await clock.pass(10_000);
    expect(links).toEqual(['otherRun']);
    expect(requests.length).toBeGreaterThan(3);
    answer = () => json({}, 503);
    await clock.pass(10_000);
    expect(links).toEqual(['otherRun']);
    stop();
    expect(
      storageWith('').watch(
        () => {},
        (link) => links.push(link),
      ),
    ).toBeTypeOf('function');
    const before = requests.length;
    await clock.pass(10_000);
    expect([links, requests.length]).toEqual([['otherRun'], before]);
  });

  it('reports nothing after it is stopped', async () => {
    const { streams, events, links, send, stop } = stream();
    await breathe();
    await send(block(changed('a')));
    stop();
    await breathe();
    await clock.pass(60_000);
    expect([streams.length, events.length, links]).toEqual([1, 1, ['up']]);
  });
});
