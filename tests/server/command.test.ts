import { chmodSync, existsSync, readdirSync, readFileSync } from 'node:fs';
import { connect, createServer, type Server } from 'node:net';
import { networkInterfaces } from 'node:os';
import { delimiter, join } from 'node:path';
import process from 'node:process';
import { afterAll, describe, expect } from 'vitest';
import { readPage } from '../../cli/serve/app.ts';
import { EDIT_API } from '../../schema/index.ts';
import { gq } from '../cli/gq.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { interruptAt } from '../interrupted/step.ts';
import { until } from '../until.ts';
import { gqEdit } from './command.ts';
import { levelPath, levelText, makeFolder, pageOf, put } from './running.ts';

const made = makeFolder({ 'levels/a.level.json': levelText('a'), 'file.txt': '', 'empty/x.txt': '' });
const cwd = made.folder;
afterAll(made.remove);

const refusal = (args: readonly string[]): Promise<{ code: number; stdout: string; stderr: string }> =>
  gqEdit(args, { cwd }).then(
    () => Promise.reject(new Error('it has started')),
    (error) => error,
  );

const listenOn = (port: number): Promise<Server> =>
  new Promise((resolve, reject) => {
    const server = createServer();
    server.on('error', reject);
    server.listen(port, '127.0.0.1', () => resolve(server));
  });

const connects = (host: string, port: number): Promise<boolean> =>
  new Promise((resolve) => {
    const socket = connect(port, host);
    socket.on('connect', () => resolve(true));
    socket.on('error', () => resolve(false));
    socket.on('close', () => resolve(false));
    socket.on('connect', () => socket.destroy());
  });

describe('gq edit', () => {
  it('serves the built page and the levels of ./levels, on 127.0.0.1 only', async () => {
    const edit = await gqEdit(['--port', '0'], { cwd });
    const page = pageOf(edit);
    const html = (await page.get('/')).text;
    const script = /src="\.(\/assets\/[^"]+\.js)"/.exec(html)?.[1] ?? '';
    expect((await page.get(script)).headers['content-type']).toBe('text/javascript; charset=utf-8');
    expect((await page.get(EDIT_API.LEVELS)).json()).toMatchObject({
      folder: { path: 'levels' },
      levels: [{ id: 'a', file: join('levels', 'a.level.json') }],
    });
    expect(edit.said().stdout).toMatch(
      /^Editing levels at\n {2}http:\/\/127\.0\.0\.1:\d+\/#token=[\w-]{43}\nCtrl-C ends it\.\n$/,
    );
    expect(edit.said().stderr).toBe('');
    const others = Object.values(networkInterfaces()).flatMap((all) => (all ?? []).map(({ address }) => address));
    for (const address of others.filter((a) => a !== '127.0.0.1' && !a.startsWith('fe80'))) {
      expect(await connects(address, edit.port)).toBe(false);
    }
    expect(await connects('127.0.0.1', edit.port)).toBe(true);
    await edit.end('SIGTERM');
  });

  itDeep.runIf(process.platform !== 'win32')(
    'ends with 130 on Ctrl-C and 143 on SIGTERM while pages listen, and leaves no partial file',
    async () => {
      for (const [signal, code, step] of [
        ['SIGINT', 130, 'openSync'],
        ['SIGTERM', 143, 'renameSync'],
      ] as const) {
        // the signal arrives right before one of the steps of writing a file
        const env = interruptAt({ of: step, number: step === 'openSync' ? 4 : 1, after: 'output', signals: [signal] });
        const edit = await gqEdit(['levels', '--port', '0'], { cwd, env });
        const page = pageOf(edit);
        const { etag, text } = (await page.get(levelPath('a'))).json() as { etag: string; text: string };
        const listening = page.get(EDIT_API.EVENTS).catch(() => 'let go');
        const next = levelText(`after ${signal}`, 1);
        const writing = page.send('PUT', levelPath('a'), { text: next, client: 'c' }, { 'If-Match': etag }).catch(() => null);
        expect(await edit.ended).toEqual({ code, signal: null });
        expect(await listening).toBe('let go');
        const done = await writing;
        const now = readFileSync(join(cwd, 'levels/a.level.json'), 'utf8');
        expect(done === null ? [text, next] : [next]).toContain(now);
        expect(readdirSync(join(cwd, 'levels'))).toEqual(['a.level.json']);
      }
    },
  );

  it('reports what is wrong with a folder', async () => {
    expect(await gq(['edit', 'nowhere'], { cwd })).toMatchObject({
      code: 2,
      stdout: '',
      stderr: expect.stringMatching(/^error: nowhere: .*no such file.*mkdir nowhere\n$/),
    });
    expect(await gq(['edit', 'file.txt'], { cwd })).toMatchObject({
      code: 2,
      stderr: expect.stringMatching(/^error: file\.txt: is a file; .*gq edit \.\n$/),
    });
    const empty = await gqEdit(['empty', '--port', '0'], { cwd });
    expect((await pageOf(empty).get(EDIT_API.LEVELS)).json()).toMatchObject({ levels: [] });
    await empty.end('SIGTERM');
  });

  itDeep('reports that a port is taken; without --port, it takes the next one, and can serve the same folder', async () => {
    const first = await gqEdit([], { cwd });
    const second = await gqEdit([], { cwd });
    expect(second.port).not.toBe(first.port);
    expect(second.said().stdout).toMatch(new RegExp(`^Port ${first.port} is taken, .*\\nEditing`));
    const third = await gqEdit(['--open', 'levels/a.level.json:3'], { cwd, env: { PATH: '' } });
    expect(third.said().stdout).toContain('goes to the same place with #level=a.level.json&tick=3 at the end of its address.');
    await third.end('SIGTERM');
    const busy = await refusal(['--port', String(first.port)]);
    expect(busy).toMatchObject({
      code: 2,
      stdout: '',
      stderr: expect.stringMatching(/^error: --port \d+: .*perhaps by another gq edit; give another port/),
    });
    for (const wrong of ['x', '-1', '65536', '1.5']) {
      expect(await gq(['edit', '--port', wrong], { cwd })).toMatchObject({ code: 2 });
    }
    // both serve the same folder: each sees the changes of the other
    const { etag } = (await pageOf(first).get(levelPath('a'))).json() as { etag: string };
    const write = (edit: typeof first, name: string) =>
      pageOf(edit).send('PUT', levelPath('a'), { text: levelText(name), client: 'c' }, { 'If-Match': etag });
    expect((await write(first, 'first')).status).toBe(200);
    expect((await write(second, 'second')).status).toBe(412);
    await Promise.all([first.end('SIGTERM'), second.end('SIGTERM')]);
    (await listenOn(first.port)).close();
  });

  itDeep.runIf(process.platform === 'linux')('opens the browser without a shell, and reports a failure', async () => {
    const opened = join(cwd, 'opened');
    put(cwd, 'bin/xdg-open', `#!/bin/sh\nprintf '%s\\n' "$#" "$@" > '${opened}'\n`);
    chmodSync(join(cwd, 'bin/xdg-open'), 0o755);
    const env = { PATH: `${join(cwd, 'bin')}${delimiter}${process.env.PATH}` };
    const edit = await gqEdit(['levels', '--port', '0', '--open'], { cwd, env });
    await until(() => existsSync(opened) && readFileSync(opened, 'utf8').endsWith('\n'));
    expect(readFileSync(opened, 'utf8')).toBe(`1\n${edit.address}\n`);
    await edit.end('SIGTERM');
    const there = await gqEdit(['--port', '0', '--open', 'levels/a.level.json:12', '--run', 'r & r'], { cwd, env });
    expect(there.address).toMatch(/#token=[\w-]{43}&level=a\.level\.json&tick=12&run=r%20%26%20r$/);
    await until(() => readFileSync(opened, 'utf8') === `1\n${there.address}\n`);
    await there.end('SIGTERM');
    const lost = await gqEdit(['levels', '--port', '0', '--open'], { cwd, env: { PATH: join(cwd, 'empty') } });
    await until(() => lost.said().stderr !== '');
    expect(lost.said().stderr).toMatch(
      /^the browser could not be opened \(xdg-open: no such file or directory\): open the address above in a browser\n$/,
    );
    await lost.end('SIGTERM');
  });
});

describeQuick('a page that is not built', () => {
  it('is reported as missing', () => {
    expect(() => readPage(join(cwd, 'nowhere'))).toThrow(/nowhere: no such file or directory; npm run build/);
    expect(() => readPage(join(cwd, 'levels'))).toThrow(/expected .*index\.html; npm run build/);
  });
});
