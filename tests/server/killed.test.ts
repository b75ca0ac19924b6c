import { spawn, spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync, rmSync, utimesSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { setTimeout } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { openLevelFolder } from '../../cli/edit/level-folder.ts';
import { readLevel } from '../../schema/index.ts';
import { gqEdit } from './command.ts';
import { everythingIn, levelPath, levelText, makeFolder, pageOf } from './running.ts';

// kill -9 at any moment: every file is whole, what was acknowledged is there, and the next run goes on.

/** A text of a few pages, so that writing it takes a while. */
const long = (name: string): string => JSON.stringify({ ...JSON.parse(levelText(name)), 'x-note': 'x'.repeat(200_000) });

const built = fileURLToPath(new URL('../../dist/cli/edit/level-folder.js', import.meta.url));

/** Overwrites, moves, orders, deletes and restores without end, and says each change once it is acknowledged. */
const WORKER = `
  import { writeSync } from 'node:fs';
  const { openLevelFolder } = await import(process.env.BUILT);
  const levels = openLevelFolder(process.env.FOLDER, 'levels');
  const say = (text) => writeSync(1, text + '\\n');
  const tag = (id) => levels.read(id).etag;
  for (let n = Number(process.env.FROM); ; n++) {
    const text = process.env.TEXT.replace('NAME', 'n' + n) + ' '.repeat(200000);
    say('writing ' + n);
    await levels.write('kept', text, { etag: tag('kept') }, 'c');
    say('written ' + n);
    await levels.order('ring', ['ring/02', 'ring/03', 'ring/01'], 'c');
    await levels.rename('moved', 'moved-2', tag('moved'), 'c');
    await levels.rename('moved-2', 'moved', tag('moved-2'), 'c');
    const { trashed } = await levels.remove('gone', tag('gone'), 'c');
    await levels.restore(trashed.trash, undefined, 'c');
  }`;

const TEXT = levelText('NAME');
const original: Record<string, string> = {
  moved: levelText('moved'),
  gone: levelText('gone'),
  'ring/01': levelText('1'),
  'ring/02': levelText('2'),
  'ring/03': levelText('3'),
};
const files = Object.fromEntries(Object.entries(original).map(([id, text]) => [`${id}.level.json`, text]));
const fresh = () => makeFolder({ 'kept.level.json': TEXT.replace('NAME', 'between'), ...files });

/** Starts the worker, kills it, and looks at what it leaves. @returns whether it was writing at that moment */
async function killOnce(folder: string, from: number): Promise<boolean> {
  const child = spawn(process.execPath, ['--input-type=module', '-e', WORKER], {
    env: { ...process.env, BUILT: built, FOLDER: folder, FROM: String(from), TEXT },
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  let said = '';
  child.stdout.on('data', (data: Buffer) => {
    said += data.toString();
  });
  const ended = new Promise((resolve) => child.on('close', resolve));
  while (!said.includes('writing') && child.exitCode === null) await setTimeout(1);
  await setTimeout(Math.random() * 25);
  child.kill('SIGKILL');
  await ended;
  expect(child.signalCode).toBe('SIGKILL');

  const [what, number] = said.trim().split('\n').at(-1)?.split(' ') ?? [];
  const n = Number(number);
  const kept = readLevel(readFileSync(join(folder, 'kept.level.json')));
  const before = n === from ? 'between' : `n${n - 1}`;
  expect(what === 'written' ? [`n${n}`] : [`n${n}`, before]).toContain(kept.ok ? kept.level.name : kept.problems);
  const contents = Object.entries(everythingIn(folder)).filter(([file]) => file.endsWith('.level.json'));
  for (const [id, text] of Object.entries(original))
    expect(
      contents.map(([, content]) => content),
      id,
    ).toContain(text);
  for (const [file, content] of contents) expect(readLevel(content).ok, file).toBe(true);

  // the next run goes on, though the lock may be left
  const levels = openLevelFolder(folder, 'levels');
  const between = TEXT.replace('NAME', 'between');
  expect((await levels.write('kept', between, { etag: levels.read('kept').etag ?? '' }, 'c')).entry.name).toBe('between');
  return what === 'writing';
}

it('leaves every file whole, old or new, and nothing lost', async () => {
  const lane = async (): Promise<number> => {
    let made = fresh();
    let whileWriting = 0;
    for (let round = 0; round < 25; round++) {
      if (await killOnce(made.folder, round * 1000)) whileWriting++;
      // a file left under two names keeps the worker from moving it again
      made.remove();
      made = fresh();
    }
    made.remove();
    return whileWriting;
  };
  const whileWriting = await Promise.all([lane(), lane(), lane(), lane()]);
  // or this test has tested little
  expect(whileWriting.reduce((sum, n) => sum + n)).toBeGreaterThan(5);
});

it('what was not finished is kept for a person to see, unless it is being written just now', () => {
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

describe('the lock of a run that was killed', () => {
  const lockWith = (content: string) => makeFolder({ 'a.level.json': levelText('a'), '.gq-edit.lock': content });
  const writeTo = (folder: string): Promise<unknown> => {
    const levels = openLevelFolder(folder, 'levels');
    return levels.write('a', levelText('new'), { etag: levels.read('a').etag ?? '' }, 'c');
  };
  const names = (folder: string): string[] => readdirSync(folder);

  it('is passed over when its process is gone, or when it is old', async () => {
    const { pid } = spawnSync(process.execPath, ['-e', '']);
    const dead = lockWith(`${pid} ${hostname()} x`);
    await writeTo(dead.folder);
    const old = lockWith(`${process.pid} elsewhere x`);
    utimesSync(join(old.folder, '.gq-edit.lock'), 0, 0);
    await writeTo(old.folder);
    for (const { folder, remove } of [dead, old]) {
      expect(names(folder)).toEqual(['a.level.json']);
      remove();
    }
  });

  it('is waited for when its process lives', async () => {
    const made = lockWith(`${process.pid} ${hostname()} x`);
    const writing = writeTo(made.folder);
    for (let i = 0; i < 5; i++) await setTimeout(10);
    expect(readFileSync(join(made.folder, 'a.level.json'), 'utf8')).toBe(levelText('a'));
    rmSync(join(made.folder, '.gq-edit.lock'));
    await writing;
    expect(readFileSync(join(made.folder, 'a.level.json'), 'utf8')).toBe(levelText('new'));
    made.remove();
  });
});

it('keeps what a server has acknowledged', async () => {
  const made = makeFolder({ 'a.level.json': long('start') });
  for (let round = 0; round < 8; round++) {
    const edit = await gqEdit(['.', '--port', '0'], { cwd: made.folder });
    const page = pageOf(edit);
    let { etag, text } = (await page.get(levelPath('a'))).json() as { etag: string; text: string };
    let next = text;
    const writing = (async () => {
      for (let n = 0; ; n++) {
        next = long(`${round}.${n}`);
        const answer = await page.send('PUT', levelPath('a'), { text: next, client: 'c' }, { 'If-Match': etag });
        expect(answer.status).toBe(200);
        text = next;
        etag = String(answer.headers.etag);
      }
    })().catch((error) => expect(error.code).toMatch(/^ECONN/));
    await setTimeout(20 + Math.random() * 60);
    await edit.end('SIGKILL');
    await writing;
    expect([text, next]).toContain(readFileSync(join(made.folder, 'a.level.json'), 'utf8'));
  }
  made.remove();
});
