import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { dirname, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { BrowserContext, Page } from 'playwright-core';
import { build } from 'vite';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { declareMissing } from '../missing.ts';
import { CHROMIUM, sharedChromium } from './chromium.ts';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const TYPES: Record<string, string> = { '.html': 'text/html', '.js': 'text/javascript' };

/** The interface of the page under test: parts of the editor with the browser's real database, locks and workers. */
const ENTRY = `
import { createEditedLevel, moveObjects } from '${root}/editor/core/document/index.ts';
import { createJournal, openIndexedDbStore } from '${root}/editor/core/journal/index.ts';
import { claimLevel } from '${root}/editor/core/files/writer-lock.ts';
import { pageTimers } from '${root}/editor/core/files/index.ts';
import { createWorkers, jobs, spawnPageWorker } from '${root}/editor/workers/index.ts';
import { DEFAULT_TERMS } from '${root}/engine/index.ts';
import { resolveLevel } from '${root}/schema/index.ts';

const FILE = { version: 1, name: 'base', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 }, asteroids: [{ id: 'aa', x: 150, y: 60, radius: 16 }] };
const workers = createWorkers({ spawn: spawnPageWorker, after: pageTimers.after });
Object.assign(window, {
  async edit(times) {
    const journal = createJournal(await openIndexedDbStore(indexedDB, pageTimers.after), Date.now);
    const level = createEditedLevel(FILE);
    const kept = journal.follow('07', level, { file: level.file(), etag: '"1"' });
    for (let i = 0; i < times; i++) level.change('Move', moveObjects(['aa'], 1, 0));
    await kept.settled();
    return journal.state.getState().kind;
  },
  // follows a level; each step then moves it
  async follow() {
    const journal = createJournal(await openIndexedDbStore(indexedDB, pageTimers.after), Date.now);
    const level = createEditedLevel(FILE);
    const kept = journal.follow('07', level, { file: level.file(), etag: '"1"' });
    await kept.settled();
    window.step = () => { level.change('Move', moveObjects(['aa'], 1, 0)); };
    window.whenKept = () => new Promise((resolve) => kept.keeping.subscribe((now) => { if (now === 'kept') resolve(); }));
  },
  async recover() {
    const recovery = await createJournal(await openIndexedDbStore(indexedDB, pageTimers.after), Date.now).recover('07');
    return recovery === null ? null : { x: recovery.file.asteroids[0].x, labels: recovery.labels.length, lost: recovery.lost };
  },
  claim() {
    const name = 'level';
    window.lock = claimLevel({ locks: navigator.locks, channel: new BroadcastChannel(name), timers: pageTimers, name,
      beforeHandOver: async () => { window.handedOver = true; }, onShown: ({ text }) => { window.shown = text; }, shown: () => ({ text: 'from the writer', base: { text: '', etag: null } }) });
  },
  role: () => window.lock.store.getState(),
  async cancelSearch() {
    const level = resolveLevel({ ...FILE, blackHole: { x: 5000, y: 0 } });
    let job;
    // once it reports progress, the job is running
    await new Promise((resolve) => {
      const asked = { level, terms: DEFAULT_TERMS, goal: { minerals: 'any' }, known: [], seed: 1, lane: 0, budget: null };
      job = workers.start(jobs.solve, { ...asked, objective: 'robust', count: 1 }, resolve);
    });
    job.cancel();
    const { kind } = await job.end;
    const next = await workers.start(jobs.proofs, { level, terms: DEFAULT_TERMS, collected: [] }).end;
    return { kind, next: next.kind, proved: next.result?.impossible?.code ?? next.message };
  },
});
`;

async function buildPage(folder: string): Promise<void> {
  writeFileSync(
    join(folder, 'index.html'),
    '<!doctype html><title>parts</title><script type="module" src="./entry.js"></script>',
  );
  writeFileSync(join(folder, 'entry.js'), ENTRY);
  await build({
    root: folder,
    base: './',
    configFile: false,
    logLevel: 'error',
    worker: { format: 'es' },
    resolve: { alias: [] },
    build: { outDir: join(folder, 'out'), target: 'es2023', minify: false },
  });
}

function serve(folder: string): Promise<Server> {
  const server = createServer((request, response) => {
    const path = join(folder, new URL(request.url ?? '/', 'http://localhost').pathname.replace(/\/$/, '/index.html'));
    if (!existsSync(path)) return void response.writeHead(404).end();
    response.writeHead(200, { 'Content-Type': TYPES[extname(path)] ?? 'text/plain' }).end(readFileSync(path));
  });
  return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(server)));
}

// biome-ignore lint/suspicious/noExplicitAny: what the entry leaves on its window
const inPage = <T>(page: Page, call: (window: any) => T): Promise<Awaited<T>> => page.evaluate(`(${call})(window)`);

if (!existsSync(CHROMIUM)) {
  declareMissing('parts of the editor in Chromium', `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
} else {
  describe('in a real browser', () => {
    let folder = '';
    let server: Server;
    let context: BrowserContext;
    let address = '';

    const open = async (): Promise<Page> => {
      const page = await context.newPage();
      await page.goto(address);
      await page.waitForFunction('window.edit !== undefined');
      return page;
    };

    beforeAll(async () => {
      folder = mkdtempSync(join(tmpdir(), 'gq-parts-'));
      await buildPage(folder);
      server = await serve(join(folder, 'out'));
      address = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
      context = await (await sharedChromium()).newContext();
    });
    afterAll(async () => {
      await context?.close();
      server?.close();
      rmSync(folder, { recursive: true, force: true });
    });

    it('the journal outlives the page', async () => {
      const first = await open();
      expect(await inPage(first, (window) => window.edit(250))).toBe('working');
      await first.close();
      const second = await open();
      expect(await inPage(second, (window) => window.recover())).toMatchObject({ x: 400, lost: 0 });
      await second.close();
    });

    /** Makes the page crash as soon as `before` has resolved in it. @returns what the next page recovers */
    const crash = async (before: string) => {
      const page = await open();
      await inPage(page, (window) => window.follow());
      const session = await page.context().newCDPSession(page);
      const crashed = page.waitForEvent('crash');
      await page.evaluate(before);
      session.send('Page.crash').catch(() => undefined);
      await crashed;
      await page.close();
      const next = await open();
      const recovered = await inPage(next, (window) => window.recover());
      await next.close();
      return recovered;
    };

    it('a page that crashes as soon as its steps are kept recovers them all', async () => {
      for (let round = 0; round < 3; round++)
        expect(await crash('step(), step(), step(), whenKept()')).toMatchObject({ x: 153, lost: 0 });
    });

    it('a page that crashes right after its steps recovers the first of them, as many as the browser had written', async () => {
      for (let round = 0; round < 3; round++) {
        const { x, labels, lost } = (await crash('step(), step(), step()')) ?? { x: 150, labels: 0, lost: 0 };
        expect([150, 151, 152, 153]).toContain(x);
        expect({ labels, lost }).toEqual({ labels: x - 150, lost: 0 });
      }
    });

    it('one page is the writer; it hands over on request and when it is closed', async () => {
      const [a, b] = [await open(), await open()];
      await inPage(a, (window) => window.claim());
      await a.waitForFunction(`role() === 'writer'`);
      await inPage(b, (window) => window.claim());
      await b.waitForFunction(`role() === 'reader' && window.shown === 'from the writer'`);
      await inPage(b, (window) => window.lock.takeOver());
      await b.waitForFunction(`role() === 'writer'`);
      await a.waitForFunction(`role() === 'reader' && window.handedOver`);
      await b.close();
      await a.waitForFunction(`role() === 'writer'`);
      await a.close();
    });

    it('a job is cancelled in the middle of its work, and another worker does the next job', async () => {
      const page = await open();
      const ends = await inPage(page, (window) => window.cancelSearch());
      expect(ends).toEqual({ kind: 'cancelled', next: 'done', proved: 'out-of-range' });
      await page.close();
    });
  });
}
