import { setTimeout } from 'node:timers/promises';
import { afterEach, expect, it, vi } from 'vitest';
import type { Editor } from '../../editor/core/context/index.ts';
import { pictureOf, thumbnailsOf, verdictOf } from '../../editor/core/levels/index.ts';
import { DEFAULT_TERMS } from '../../engine/index.ts';
import type { LevelEntry } from '../../schema/index.ts';
import { fakeDesk } from './fake-desk.ts';

const entryOf = (id: string, etag: string) => ({ id, etag, status: 'valid' }) as LevelEntry;

afterEach(() => vi.unstubAllGlobals());

it('keeps the picture of a level until a new one is there, also if it was drawn for another file', async () => {
  const files: Record<string, string> = { a: 'one', b: 'one' };
  const { desk, workers } = fakeDesk();
  const storage = { read: async (id: string) => ({ ok: true, value: { etag: files[id], text: files[id] } }) };
  const thumbnails = thumbnailsOf({ workspace: { storage }, desk } as unknown as Editor);
  vi.stubGlobal('URL', { createObjectURL: () => `picture ${workers.jobs.length}`, revokeObjectURL() {} });
  const shown = (id: string) => pictureOf(thumbnails.store.getState(), entryOf(id, files[id]), 'dark', DEFAULT_TERMS);
  const want = async (id: string) => {
    thumbnails.want(entryOf(id, files[id]), 'dark', DEFAULT_TERMS);
    await setTimeout();
    workers.jobs.at(-1)?.end({ kind: 'done', result: { svg: 'drawn', verdict: 'completable', facts: null } });
    await setTimeout();
  };
  await want('a');
  // the same content: nothing is drawn again
  await want('b');
  expect([workers.jobs.length, shown('a'), shown('b')]).toEqual([1, 'picture 1', 'picture 1']);
  files.b = 'two';
  expect(shown('b')).toBe('picture 1');
  expect(verdictOf(thumbnails.store.getState(), entryOf('b', files.b), DEFAULT_TERMS)).toBeNull();
  await want('b');
  expect([workers.jobs.length, shown('a'), shown('b')]).toEqual([2, 'picture 1', 'picture 2']);
  // back to what it was: the picture is known, and stays as the file changes once more
  files.b = 'one';
  await want('b');
  files.b = 'three';
  expect([workers.jobs.length, shown('b')]).toEqual([2, 'picture 1']);
});
