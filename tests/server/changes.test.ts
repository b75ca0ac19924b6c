import fc from 'fast-check';
import { expect, it } from 'vitest';
import { changesBetween } from '../../cli/serve/changes.ts';
import { NO_FOLDER_TERMS } from '../../editor/core/files/folder-list.ts';
import type { EditEvent, LevelEntry, ListResponse } from '../../schema/index.ts';

const entry = (id: string, content: number): LevelEntry => ({
  id,
  file: `${id}.level.json`,
  etag: content === 0 ? null : `"${String(content).repeat(64)}"`,
  status: content === 0 ? 'unreadable' : 'valid',
  name: null,
  problems: [],
  readOnly: null,
});

/** A folder of a few files with a few contents, so that two files often have the same content. */
const folder = fc
  .record({ contents: fc.dictionary(fc.constantFrom('a', 'b', 'c', 'd', 'e'), fc.nat(3)), troubles: fc.subarray(['t']) })
  .map(
    ({ contents, troubles }): ListResponse => ({
      folder: { id: 'f', path: 'levels', $schema: null },
      folders: [''],
      levels: Object.entries(contents).map(([id, content]) => entry(id, content)),
      terms: NO_FOLDER_TERMS,
      troubles,
      unread: 0,
    }),
  );

/** The state that a page knows after an event. */
function hear(known: Map<string, LevelEntry>, event: EditEvent): Map<string, LevelEntry> {
  const next = new Map(known);
  if (event.type === 'list') return new Map(event.list.levels.map((level) => [level.id, level]));
  if (event.type === 'read' || event.type === 'terms' || event.type === 'pack')
    throw new Error('of a folder all is read by then, and neither its terms nor its order are a level');
  if (event.type === 'removed') {
    expect(next.delete(event.id)).toBe(true);
    return next;
  }
  if (event.type === 'renamed') {
    expect(next.get(event.from)?.etag).toBe(event.entry.etag);
    expect(next.has(event.entry.id)).toBe(false);
    next.delete(event.from);
  }
  return next.set(event.entry.id, event.entry);
}

it('a page that gets every event knows the current state', () => {
  fc.assert(
    fc.property(folder, folder, (before, after) => {
      const events = changesBetween(before, after, null);
      const known = events.reduce(hear, new Map(before.levels.map((level) => [level.id, level])));
      const sorted = (levels: Iterable<LevelEntry>) => [...levels].sort((a, b) => (a.id < b.id ? -1 : 1));
      expect(sorted(known.values())).toEqual(sorted(after.levels));
      if (before.troubles.length !== after.troubles.length) expect(events.at(-1)).toEqual({ type: 'list', list: after });
    }),
    { numRuns: 2000 },
  );
});

it('no change gives no event', () => {
  fc.assert(
    fc.property(folder, (same) => {
      expect(changesBetween(same, structuredClone(same), 'me')).toEqual([]);
    }),
  );
});
