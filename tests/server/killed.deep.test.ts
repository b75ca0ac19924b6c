import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, utimesSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { openLevelFolder } from '../../cli/serve/level-folder.ts';
import { killWriterAt } from '../interrupted/killed-writer.ts';
import { interruptAt } from '../interrupted/step.ts';
import { gqEdit } from './command.ts';
import { levelPath, levelText, makeFolder, pageOf } from './running.ts';

// kill -9 at any step: every file is whole, what was acknowledged is there, and the next run goes on. A few steps are tried here;
// `npm run bench -- soak --attack writers` tries all of them.

it('a writer that nobody kills leaves every file whole', async () => {
  expect((await killWriterAt(0)).wrong).toEqual([]);
});

it.each([
  // of the lock
  ['writeSync', 1],
  // of the level: the file is open and empty, then it has its content
  ['fchmodSync', 1],
  ['writeFileSync', 1],
  ['fsyncSync', 1],
  ['renameSync', 1],
])('leaves every file whole, old or new, and nothing lost before %s %i', async (of, number) => {
  expect(await killWriterAt(number, of)).toEqual({ steps: null, wrong: [] });
});

it('leaves every file whole, and nothing lost while files are moved, deleted and restored', async () => {
  // half of a move: the file has two names, one, or the old name is just gone; the writer has 8 links and 14 removals
  const step = fc.constantFrom(...['linkSync', 'unlinkSync'].flatMap((of) => [2, 3, 4, 5, 6, 7, 8].map((n) => [of, n] as const)));
  await fc.assert(
    fc.asyncProperty(fc.noBias(step), async ([of, number]) => {
      expect(await killWriterAt(number, of), `before ${of} ${number}`).toEqual({ steps: null, wrong: [] });
    }),
    { numRuns: 2, endOnFailure: true },
  );
});

it('unfinished files are kept in the trash, unless they are still being written', () => {
  const names = ['.gq-edit-0123456789abcdef.tmp', 'ring/.gq-edit-00112233445566aa.tmp', '.gq-edit-fedcba9876543210.tmp'];
  const made = makeFolder({
    'ring/01.level.json': levelText('1'),
    ...Object.fromEntries(names.map((name) => [name, levelText(name)])),
  });
  for (const name of names.slice(0, 2)) utimesSync(join(made.folder, name), 0, 0);
  const levels = openLevelFolder(made.folder, 'levels');
  expect(names.map((name) => existsSync(join(made.folder, name)))).toEqual([false, false, true]);
  const kept = levels.trash().trash.map(({ id }) => id);
  expect(kept.sort()).toEqual(['unfinished-00112233445566aa', 'unfinished-0123456789abcdef']);
  made.remove();
});

it('the lock of a killed run is ignored if its process is gone, or if it is old', async () => {
  const lockWith = (content: string) => makeFolder({ 'a.level.json': levelText('a'), '.gq-edit.lock': content });
  const { pid } = spawnSync(process.execPath, ['-e', '']);
  const dead = lockWith(`${pid} ${hostname()} x`);
  const old = lockWith(`${process.pid} elsewhere x`);
  utimesSync(join(old.folder, '.gq-edit.lock'), 0, 0);
  for (const { folder, remove } of [dead, old]) {
    const levels = openLevelFolder(folder, 'levels');
    await levels.write('a', levelText('new'), { etag: levels.read('a').etag ?? '' }, 'c');
    expect(readdirSync(folder)).toEqual(['a.level.json']);
    remove();
  }
});

it('acknowledged changes are kept', async () => {
  await fc.assert(
    // during the first write that is requested, or one of the next
    fc.asyncProperty(fc.noBias(fc.integer({ min: 1, max: 60 })), async (number) => {
      const made = makeFolder({ 'a.level.json': levelText('start') });
      const env = interruptAt({ of: 'change', number, after: 'output', signals: ['SIGKILL'] });
      const edit = await gqEdit(['.', '--port', '0'], { cwd: made.folder, env });
      const page = pageOf(edit);
      let acknowledged = levelText('start');
      let sent = acknowledged;
      const writeOn = async (): Promise<void> => {
        let { etag } = (await page.get(levelPath('a'))).json() as { etag: string };
        for (let n = 0; ; n++) {
          sent = levelText(`n${n}`);
          const answer = await page.send('PUT', levelPath('a'), { text: sent, client: 'c' }, { 'If-Match': etag });
          expect(answer.status).toBe(200);
          acknowledged = sent;
          etag = String(answer.headers.etag);
        }
      };
      await expect(writeOn()).rejects.toMatchObject({ code: expect.stringMatching(/^ECONN/) });
      expect(await edit.ended).toEqual({ code: null, signal: 'SIGKILL' });
      expect([acknowledged, sent]).toContain(readFileSync(join(made.folder, 'a.level.json'), 'utf8'));
      made.remove();
    }),
    { numRuns: 2, endOnFailure: true },
  );
});
