import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { keepPort, lastPort } from '../../cli/serve/access.ts';
import { startServer } from '../../cli/serve/index.ts';
import { levelText, makeFolder, PAGE_FILES } from './running.ts';

const before = process.env.XDG_STATE_HOME;
let state: string;
const ports = () => join(state, 'gravity-quest-toolkit', 'edit-ports');
beforeEach(() => {
  state = mkdtempSync(join(tmpdir(), 'gq-state-'));
  process.env.XDG_STATE_HOME = state;
});
afterEach(() => {
  process.env.XDG_STATE_HOME = before;
  rmSync(state, { recursive: true, force: true });
});

describe.runIf(process.platform !== 'win32')('the port of a folder', () => {
  it('is the last one kept, separately for each folder', () => {
    expect(lastPort('one')).toBeNull();
    keepPort('one', 4747);
    keepPort('two', 1);
    keepPort('one', 65_535);
    expect([lastPort('one'), lastPort('two'), lastPort('three')]).toEqual([65_535, 1, null]);
    expect(readdirSync(ports()).sort()).toEqual(['one', 'two']);
    expect(readFileSync(join(ports(), 'one'), 'utf8')).toBe('65535\n');
  });

  it('is not known if its file contains anything else', () => {
    keepPort('one', 4747);
    for (const text of ['', '4747', '0\n', '65536\n', '99999\n', '-1\n', '4747\n\n', 'x\n', '123456\n', ' 1\n', '1e3\n']) {
      writeFileSync(join(ports(), 'one'), text);
      expect([text, lastPort('one')]).toEqual([text, null]);
    }
    rmSync(join(ports(), 'one'));
    mkdirSync(join(ports(), 'one'));
    expect(lastPort('one')).toBeNull();
  });

  it('is kept only where possible, never below a relative path', () => {
    rmSync(state, { recursive: true });
    writeFileSync(state, 'a file');
    keepPort('one', 4747);
    expect(lastPort('one')).toBeNull();
  });

  it.runIf(process.platform === 'linux')('is kept below the home directory without a usable XDG_STATE_HOME', () => {
    const home = process.env.HOME;
    const at = join(state, '.local', 'state', 'gravity-quest-toolkit', 'edit-ports');
    try {
      process.env.HOME = state;
      for (const named of [undefined, '', 'relative']) {
        if (named === undefined) delete process.env.XDG_STATE_HOME;
        else process.env.XDG_STATE_HOME = named;
        keepPort(`named ${named}`, 4747);
        expect([readdirSync(at).includes(`named ${named}`), lastPort(`named ${named}`)]).toEqual([true, 4747]);
      }
    } finally {
      process.env.HOME = home;
    }
  });

  it.runIf(process.platform === 'linux')('is kept in the usual place of Windows on Windows', () => {
    const { platform } = process;
    const local = process.env.LOCALAPPDATA;
    try {
      Object.defineProperty(process, 'platform', { value: 'win32' });
      process.env.LOCALAPPDATA = join(state, 'local');
      keepPort('one', 4747);
      expect(readdirSync(join(state, 'local', 'gravity-quest-toolkit', 'edit-ports'))).toEqual(['one']);
      expect(lastPort('one')).toBe(4747);
    } finally {
      Object.defineProperty(process, 'platform', { value: platform });
      if (local === undefined) delete process.env.LOCALAPPDATA;
      else process.env.LOCALAPPDATA = local;
    }
  });

  it('is remembered for the last 1000 folders', () => {
    keepPort('first', 1);
    for (let i = 0; i < 1002; i++) {
      const path = join(ports(), `folder-${i}`);
      writeFileSync(path, `${i + 2}\n`);
      utimesSync(path, 1000 + i, 1000 + i);
    }
    utimesSync(join(ports(), 'first'), 5000, 5000);
    keepPort('last', 3);
    expect(readdirSync(ports())).toHaveLength(1000);
    expect([lastPort('first'), lastPort('last'), lastPort('folder-3'), lastPort('folder-4')]).toEqual([1, 3, null, 6]);
    keepPort('last', 4);
    expect([readdirSync(ports()).length, lastPort('folder-4')]).toEqual([1000, 6]);
  });
});

describe.runIf(process.platform !== 'win32')('a server', () => {
  const folders: { remove(): void }[] = [];
  afterEach(() => {
    for (const folder of folders.splice(0)) folder.remove();
  });
  const made = () => {
    const [levels, page] = [makeFolder({ 'a.level.json': levelText('a') }), makeFolder(PAGE_FILES)];
    folders.push(levels, page);
    return { levels: levels.folder, page: page.folder };
  };
  const start = (at: ReturnType<typeof made>, port: number | null) =>
    startServer({ folder: at.levels, port, configFrom: at.levels, page: at.page, game: at.page, onCrash: () => {} });
  const listener = async (port = 0) => {
    const server = createServer();
    await new Promise<void>((resolve) => server.listen(port, '127.0.0.1', resolve));
    return { port: (server.address() as { port: number }).port, close: () => new Promise((done) => server.close(done)) };
  };

  it('takes the requested port or fails, and reports the last one', async () => {
    const at = made();
    const other = await listener();
    await expect(start(at, other.port)).rejects.toThrow(`--port ${other.port}: can't listen on it: the port is in use`);
    await other.close();
    const server = await start(at, other.port);
    expect([server.port, server.portBefore]).toEqual([other.port, null]);
    expect(server.address).toMatch(new RegExp(`^http://127\\.0\\.0\\.1:${other.port}/#token=[\\w-]{43}$`));
    await server.close();
    const next = await start(at, null);
    expect([next.port, next.portBefore]).toEqual([other.port, other.port]);
    await next.close();
    // another requested port becomes the remembered one
    const third = await listener();
    await third.close();
    await (await start(at, third.port)).close();
    const last = await start(at, null);
    expect([last.port, last.portBefore]).toEqual([third.port, third.port]);
    await last.close();
  });

  it('reuses the port of --port 0; while that is taken it uses another, which becomes the remembered one', async () => {
    const at = made();
    const first = await start(at, 0);
    expect(first.portBefore).toBeNull();
    await first.close();
    const again = await start(at, 0);
    expect([again.port, again.portBefore]).toEqual([first.port, first.port]);
    await again.close();
    const other = await listener(first.port);
    const elsewhere = await start(at, 0);
    expect([elsewhere.port === first.port, elsewhere.portBefore]).toEqual([false, first.port]);
    await elsewhere.close();
    await other.close();
  });

  it('reports what is wrong with the folder and with the page', async () => {
    const at = made();
    await expect(start({ ...at, levels: join(at.levels, 'nowhere') }, 0)).rejects.toThrow('nowhere');
    await expect(start({ ...at, levels: join(at.levels, 'a.level.json') }, 0)).rejects.toThrow(/a\.level\.json/);
    await expect(start({ ...at, page: at.levels }, 0)).rejects.toThrow(/page is missing: expected .*index\.html/);
    await expect(start({ ...at, page: join(dirname(at.page), 'nowhere') }, 0)).rejects.toThrow(/page can't be read/);
  });
});
