import { setTimeout } from 'node:timers/promises';
import { expect, it, vi } from 'vitest';
import type { Editor } from '../../editor/core/context/index.ts';
import { pictureOf, thumbnailsOf, verdictOf } from '../../editor/core/levels/index.ts';
import type { JobEnd } from '../../editor/workers/workers.ts';
import { DEFAULT_TERMS } from '../../engine/index.ts';
import type { LevelEntry } from '../../schema/index.ts';

const entryOf = (id: string, etag: string) => ({ id, etag, status: 'valid' }) as LevelEntry;

const atOnce = (_: number, call: () => void) => {
  call();
  return () => {};
};

/** An editor on files by id, whose worker draws the content of a file as that content; URLs of pictures are counted on. */
function stageOf(files: Record<string, string>) {
  let drawn = 0;
  const editor = {
    workspace: { storage: { read: async (id: string) => ({ ok: true, value: { etag: files[id], text: files[id] } }) } },
    desk: {
      workers: {
        start(_: unknown, { text }: { text: string }) {
          drawn++;
          const result = { svg: text, verdict: 'completable', facts: null };
          return { end: Promise.resolve({ kind: 'done', result } as unknown as JobEnd<never>), cancel() {} };
        },
      },
      afterRest: atOnce,
      after: atOnce,
    },
  } as unknown as Editor;
  vi.stubGlobal('URL', { createObjectURL: () => `picture ${drawn}`, revokeObjectURL() {} });
  return { thumbnails: thumbnailsOf(editor), drawn: () => drawn };
}

it('keeps the picture of a level until a new one is there, also if it was drawn for another file', async () => {
  const files: Record<string, string> = { a: 'one', b: 'one' };
  const { thumbnails, drawn } = stageOf(files);
  const shown = (id: string) => pictureOf(thumbnails.store.getState(), entryOf(id, files[id]), 'dark', DEFAULT_TERMS);
  const want = async (id: string) => {
    thumbnails.want(entryOf(id, files[id]), 'dark', DEFAULT_TERMS);
    await setTimeout();
  };
  await want('a');
  // the same content: nothing is drawn again
  await want('b');
  expect([drawn(), shown('a'), shown('b')]).toEqual([1, 'picture 1', 'picture 1']);
  files.b = 'two';
  expect(shown('b')).toBe('picture 1');
  expect(verdictOf(thumbnails.store.getState(), entryOf('b', files.b), DEFAULT_TERMS)).toBeNull();
  await want('b');
  expect([drawn(), shown('a'), shown('b')]).toEqual([2, 'picture 1', 'picture 2']);
  // back to what it was: the picture is known, and stays as the file changes once more
  files.b = 'one';
  await want('b');
  files.b = 'three';
  expect([drawn(), shown('b')]).toEqual([2, 'picture 1']);
  vi.unstubAllGlobals();
});
