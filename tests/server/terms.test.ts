// What the page learns about the terms that a folder's configuration sets.

import { mkdirSync, renameSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { NO_CONFIG, termsOnDisk } from '../../cli/serve/terms-on-disk.ts';
import { EDIT_API, type FolderTerms, type ListResponse } from '../../schema/index.ts';
import { levelText, makeFolder, put, serve } from './running.ts';

const CONFIG = 'gq.config.json';
let made: ReturnType<typeof makeFolder>;
let server: Awaited<ReturnType<typeof serve>>;

beforeEach(async () => {
  // the levels are in a subfolder, as usual
  made = makeFolder({ 'levels/a.level.json': levelText('A'), [CONFIG]: '{ "rules": { "pull": 45 } }' });
  // configurations above the repository do not matter
  mkdirSync(join(made.folder, '.git'));
  server = await serve(join(made.folder, 'levels'));
});
afterEach(async () => {
  await server.close();
  made.remove();
  expect(server.crashes).toEqual([]);
});

const listed = async (): Promise<FolderTerms> => ((await server.page.get(EDIT_API.LEVELS)).json() as ListResponse).terms;

it('a list contains the current terms and their file', async () => {
  expect(await listed()).toEqual({ ...NO_CONFIG, file: expect.stringMatching(/gq\.config\.json$/), rules: { pull: 45 } });
  put(made.folder, CONFIG, '{ "rules": { "push": 3, "x-why": 1 }, "accuracy": "arcade" }');
  expect(await listed()).toMatchObject({ rules: { push: 3 }, accuracy: 'arcade', problems: [] });
  rmSync(join(made.folder, CONFIG));
  expect(await listed()).toEqual(NO_CONFIG);
});

it('an error is reported with its place; the previous rules apply until it is fixed or the file is gone', async () => {
  put(made.folder, CONFIG, '{\n  "rules": { "pul": 3 }\n}');
  const wrong = await listed();
  expect(wrong.rules).toEqual({ pull: 45 });
  expect(wrong.problems).toMatchObject([{ line: 2, column: 14, message: expect.stringContaining('did you mean "pull"?') }]);
  put(made.folder, CONFIG, '{ "rules": ');
  expect(await listed()).toMatchObject({ rules: { pull: 45 }, problems: [{ line: 1 }] });
  put(made.folder, CONFIG, '{}');
  expect(await listed()).toMatchObject({ rules: {}, problems: [] });
});

it('a configuration that can not be read is reported, too', () => {
  if (process.platform === 'win32') return;
  const look = termsOnDisk(made.folder);
  expect(look().rules).toEqual({ pull: 45 });
  rmSync(join(made.folder, CONFIG));
  mkdirSync(join(made.folder, CONFIG));
  expect(look()).toMatchObject({
    rules: { pull: 45 },
    problems: [{ message: expect.stringMatching(/can't be read: .*directory/) }],
  });
});

/** The events of a page after the list. */
async function listen(): Promise<{ next: () => Promise<FolderTerms>; end: () => Promise<void> }> {
  const { port, token } = server.page;
  const abort = new AbortController();
  const answer = await fetch(`http://127.0.0.1:${port}${EDIT_API.EVENTS}`, {
    headers: { [EDIT_API.TOKEN_HEADER]: token },
    signal: abort.signal,
  });
  const reader = (answer.body as ReadableStream<Uint8Array>).getReader();
  const decoder = new TextDecoder();
  let rest = '';
  const next = async (): Promise<FolderTerms> => {
    for (;;) {
      const blocks = rest.split('\n\n');
      rest = blocks.pop() ?? '';
      for (const [i, block] of blocks.entries()) {
        if (!block.startsWith('data: ')) continue;
        const event = JSON.parse(block.slice(6));
        if (event.type !== 'terms') continue;
        rest = [...blocks.slice(i + 1), rest].join('\n\n');
        return event.terms;
      }
      const { value, done } = await reader.read();
      if (done) throw new Error('the stream has ended');
      rest += decoder.decode(value, { stream: true });
    }
  };
  return {
    next,
    async end() {
      abort.abort();
      await reader.cancel().catch(() => undefined);
    },
  };
}

it('listeners get every change once: written, replaced, deleted, created again', async () => {
  const { next, end } = await listen();
  put(made.folder, CONFIG, '{ "rules": { "pull": 50 } }');
  expect(await next()).toMatchObject({ rules: { pull: 50 } });
  put(made.folder, 'other.json', '{ "rules": { "pull": 60 } }');
  renameSync(join(made.folder, 'other.json'), join(made.folder, CONFIG));
  expect(await next()).toMatchObject({ rules: { pull: 60 } });
  // the same rules in another layout give no event: the next event is that of the next change
  put(made.folder, CONFIG, '{ "rules": {"pull":60} }');
  await listed();
  rmSync(join(made.folder, CONFIG));
  expect(await next()).toEqual(NO_CONFIG);
  put(made.folder, CONFIG, '{ "rules": { "pull": 70, }');
  expect(await next()).toMatchObject({ rules: {}, problems: [expect.objectContaining({ line: 1 })] });
  await end();
});
