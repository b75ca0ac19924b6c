import fc from 'fast-check';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { createEventStreams, inParts } from '../../cli/serve/event-stream.ts';
import type { KnownLevels } from '../../cli/serve/known-levels.ts';
import { Refusal } from '../../cli/serve/refusal.ts';
import { NO_FOLDER_TERMS } from '../../editor/core/files/folder-list.ts';
import { EDIT_API, type EditEvent, type LevelEntry, type ListResponse } from '../../schema/index.ts';

const listOf = (...ids: string[]): ListResponse => ({
  folder: { id: 'f', path: 'levels', $schema: null },
  folders: [''],
  levels: ids.map(
    (id): LevelEntry => ({
      ...{ id, file: `${id}.level.json`, etag: null, status: 'unreadable', name: null, problems: [], readOnly: null },
    }),
  ),
  terms: NO_FOLDER_TERMS,
  troubles: [],
  unread: 0,
});
const removed = (id: string): EditEvent => ({ type: 'removed', id, by: null });

let listeners: Set<(event: EditEvent) => void>;
let streams: ReturnType<typeof createEventStreams>;
const tell = (event: EditEvent) => {
  for (const listener of [...listeners]) listener(event);
};

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setInterval', 'clearInterval'] });
  listeners = new Set();
  streams = createEventStreams({
    list: () => listOf('a'),
    listen(listener: (event: EditEvent) => void) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  } as unknown as KnownLevels);
});
afterEach(() => {
  vi.useRealTimers();
});

const decode = (bytes: Uint8Array | undefined) => new TextDecoder().decode(bytes);
/** Everything that can be read from a stream without waiting. */
async function said(reader: ReadableStreamDefaultReader<Uint8Array>): Promise<string[]> {
  const all: string[] = [];
  for (;;) {
    const turn = new Promise<null>((resolve) => setImmediate(() => setImmediate(() => resolve(null))));
    const read = pending.get(reader) ?? reader.read();
    pending.set(reader, read);
    const got = await Promise.race([read, turn]);
    if (got === null || got.done) return all;
    pending.delete(reader);
    all.push(decode(got.value));
  }
}
const pending = new WeakMap<object, Promise<ReadableStreamReadResult<Uint8Array>>>();
const line = (event: EditEvent) => `data: ${JSON.stringify(event)}\n\n`;

it('a list of any length is sent in parts, with each level once and in order, and the last part is marked', () => {
  fc.assert(
    fc.property(fc.nat(5000), fc.nat(3), (count, unread) => {
      const list = { ...listOf(...Array.from({ length: count }, (_, i) => `${i}`)), unread };
      const { levels } = list;
      const parts = [...inParts({ type: 'list', list })];
      const told = parts.map((part) => (part.type === 'list' ? part.list : part)) as { levels: LevelEntry[]; unread: number }[];
      expect(parts.map(({ type }) => type)).toEqual(['list', ...parts.slice(1).map(() => 'read')]);
      expect(told.flatMap((part) => part.levels)).toEqual(levels);
      for (const [i, part] of told.entries()) {
        const after = told.slice(i + 1).reduce((sum, { levels: more }) => sum + more.length, 0);
        expect(part.unread).toBe(unread + after);
      }
    }),
    { numRuns: 30 },
  );
});

describe('a stream of events', () => {
  it('begins with the list, and continues with events', async () => {
    const reader = streams.open().getReader();
    tell(removed('x'));
    tell(removed('y'));
    expect(await said(reader)).toEqual([line({ type: 'list', list: listOf('a') }), line(removed('x')), line(removed('y'))]);
    tell(removed('z'));
    expect(await said(reader)).toEqual([line(removed('z'))]);
  });

  it('sends a heartbeat every 10 s until it ends', async () => {
    const reader = streams.open().getReader();
    await said(reader);
    vi.advanceTimersByTime(EDIT_API.HEARTBEAT * 1000 - 1);
    expect(await said(reader)).toEqual([]);
    vi.advanceTimersByTime(1);
    expect(await said(reader)).toEqual([': still here\n\n']);
    vi.advanceTimersByTime(2 * EDIT_API.HEARTBEAT * 1000);
    expect((await said(reader)).join('')).toBe(': still here\n\n'.repeat(2));
    await reader.cancel();
    expect([vi.getTimerCount(), listeners.size]).toEqual([0, 0]);
    tell(removed('x'));
    vi.advanceTimersByTime(60_000);
  });

  it('sends at most 1 MiB ahead to a page that reads nothing, and a new list replaces waiting events', async () => {
    const reader = streams.open().getReader();
    const long = removed('x'.repeat(100_000));
    for (let i = 0; i < 20; i++) tell(long);
    vi.advanceTimersByTime(60_000);
    tell({ type: 'list', list: listOf('b') });
    tell(removed('last'));
    const all = await said(reader);
    const count = (text: string) => all.filter((one) => one === text).length;
    // the first list, the events that fit into 1 MiB, and one more
    expect(count(line(long))).toBe(11);
    expect(all.slice(-2)).toEqual([line({ type: 'list', list: listOf('b') }), line(removed('last'))]);
    expect(all).toHaveLength(14);
  });

  it('is open for 32 pages at a time, and a page that leaves makes room for one other, however often it leaves', async () => {
    const open = Array.from({ length: 32 }, () => streams.open());
    const refused = () => {
      try {
        streams.open();
        return null;
      } catch (error) {
        return error;
      }
    };
    expect(refused()).toBeInstanceOf(Refusal);
    expect(refused()).toMatchObject({ code: 'busy', message: expect.stringContaining('32') });
    await open[0].cancel();
    await open[0].cancel();
    expect(refused()).toBeNull();
    expect(refused()).toMatchObject({ code: 'busy' });
    expect(listeners.size).toBe(32);
  });

  it('ends if more than 10,000 events wait, and makes room for another page', async () => {
    const all = Array.from({ length: 32 }, () => streams.open());
    const asleep = all[0].getReader();
    tell(removed('x'.repeat(2 ** 20)));
    const awake = all.slice(1).map((stream) => stream.getReader());
    for (const reader of awake) await reader.cancel();
    for (let i = 0; i < 10_000; i++) tell(removed('y'));
    expect(listeners.size).toBe(1);
    tell(removed('z'));
    expect([listeners.size, vi.getTimerCount()]).toEqual([0, 0]);
    // what was already sent arrives, and then the stream ends
    expect((await said(asleep)).length).toBe(2);
    expect(await asleep.read()).toEqual({ done: true, value: undefined });
    expect(() => Array.from({ length: 32 }, () => streams.open())).not.toThrow();
  });
});
