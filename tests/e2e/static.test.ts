import { existsSync, readFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { readLevel } from '../../schema/index.ts';
import { declareMissing } from '../missing.ts';
import { CHROMIUM, sharedChromium } from './chromium.ts';
import { command, verdict } from './commands.ts';
import { paceFrames } from './frames.ts';
import { straight } from './levels.ts';
import { PATIENCE, until } from './until.ts';

// The built page in a subfolder of a host that serves only files: levels are stored in the browser.

const BUILT = fileURLToPath(new URL('../../dist/editor', import.meta.url));
const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
};

/** A level as in a link. */
const packed = (level: unknown): string => deflateRawSync(JSON.stringify(level)).toString('base64url');

/** Starts a host of files. @returns it with the address of the page */
function host(): Promise<{ server: Server; address: string; asked: string[] }> {
  const asked: string[] = [];
  const server = createServer(({ url = '' }, answer) => {
    asked.push(url);
    const { pathname } = new URL(url, 'http://host');
    const path = join(BUILT, pathname.replace(/^\/game\//, '').replace(/^$/, 'index.html'));
    if (!pathname.startsWith('/game/') || !existsSync(path)) answer.writeHead(404).end();
    else answer.writeHead(200, { 'Content-Type': TYPES[extname(path)] ?? 'application/octet-stream' }).end(readFileSync(path));
  });
  return new Promise((resolve) => {
    server.listen(0, '127.0.0.1', () => {
      resolve({ server, address: `http://127.0.0.1:${(server.address() as AddressInfo).port}/game/`, asked });
    });
  });
}

const suite = 'the built page on a host of files, in Chromium';
if (!existsSync(CHROMIUM)) declareMissing(suite, `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
else {
  describe(suite, () => {
    let browser: Browser;
    let hosted: Awaited<ReturnType<typeof host>>;
    beforeAll(async () => {
      [browser, hosted] = await Promise.all([sharedChromium(), host()]);
    });
    afterAll(() => {
      hosted.server.close();
    });

    /** A user with their own browser. */
    const person = async (
      complaints: string[],
    ): Promise<{ context: BrowserContext; open: (address: string) => Promise<Page> }> => {
      const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
      await context.addInitScript(paceFrames);
      await context.addInitScript(() => {
        localStorage['gravity-quest-editor-settings'] ??= '{"tourSeen":true}';
        for (const name of ['showOpenFilePicker', 'showSaveFilePicker'])
          delete (window as unknown as Record<string, unknown>)[name];
      });
      const open = async (address: string) => {
        const page = await context.newPage();
        page.setDefaultTimeout(PATIENCE);
        page.on('pageerror', (error) => complaints.push(error.message));
        page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
        await page.goto(address);
        return page;
      };
      return { context, open };
    };
    const saved = (page: Page) =>
      page
        .getByRole('status', { name: 'Saving' })
        .filter({ hasText: /^saved$/ })
        .waitFor();
    const isOpen = (page: Page, name: string) => page.getByRole('heading', { level: 1, name, exact: true }).waitFor();

    it('publishes all levels as one file, since there are no folders, and names a level without a run', async () => {
      const complaints: string[] = [];
      const one = await person(complaints);
      const page = await one.open(`${hosted.address}#level=${packed(straight({ name: 'Linked', runs: [] }))}`);
      await page.getByRole('dialog', { name: 'Add the level from the link?' }).getByRole('button', { name: 'Add level' }).click();
      await isOpen(page, 'Linked');
      await saved(page);
      await command(page, 'Publish as a page to play');
      const dialog = page.getByRole('dialog', { name: 'Publish' });
      expect(await dialog.getByRole('radio').count()).toBe(2);
      await dialog.getByRole('button', { name: 'Publish', exact: true }).click();
      await dialog
        .getByRole('alert')
        .getByText(/unproven.*Linked/)
        .waitFor();
      const [download] = await Promise.all([
        page.waitForEvent('download'),
        dialog.getByRole('button', { name: 'Publish all the same' }).click(),
      ]);
      expect(download.suggestedFilename()).toBe('gravity-quest.html');
      const text = readFileSync(await download.path(), 'utf8');
      expect(text).toContain('"name":"Linked"');
      expect(text).not.toMatch(/<script[^>]* src=/);
      expect(complaints).toEqual([]);
      await one.context.close();
    });

    it('creates a level, edits it, keeps it after a reload, shares it by link, and downloads it', async () => {
      const complaints: string[] = [];
      const before = hosted.asked.length;
      const one = await person(complaints);
      const page = await one.open(hosted.address);
      await page.getByText('No levels here yet.').waitFor();
      await page.getByRole('main').getByRole('button', { name: 'New level' }).click();
      const dialog = page.getByRole('dialog', { name: 'New level' });
      await dialog.getByText('A first swing').click();
      await dialog.getByLabel('Level name').fill('Mine');
      await dialog.getByRole('button', { name: 'Create' }).click();
      await isOpen(page, 'Mine');
      await page.getByRole('textbox', { name: 'range' }).fill('260');
      await page.keyboard.press('Enter');
      await saved(page);
      await page.reload();
      await isOpen(page, 'Mine');
      await saved(page);
      await until(async () => expect(await page.getByRole('textbox', { name: 'range' }).inputValue()).toBe('260'));

      await page.getByRole('button', { name: 'Import, export, link' }).click();
      const share = page.getByRole('dialog', { name: 'Import, export, link' });
      const [download] = await Promise.all([
        page.waitForEvent('download'),
        share.getByRole('button', { name: /\.level\.json$/ }).click(),
      ]);
      const reading = readLevel(readFileSync(await download.path()));
      expect(reading).toMatchObject({ ok: true, level: { name: 'Mine', range: 260 } });
      await share.getByRole('tab', { name: 'Link' }).click();
      const link = await share.getByRole('textbox', { name: 'Link with the level' }).inputValue();
      expect(link.startsWith(`${hosted.address}#`)).toBe(true);

      // another user, who has no levels yet
      const other = await person(complaints);
      const theirs = await other.open(link);
      const asked = theirs.getByRole('dialog', { name: 'Add the level from the link?' });
      await asked.getByText('Mine', { exact: true }).waitFor();
      // nothing is stored before the user confirms
      expect(new URL(theirs.url()).hash).toBe('');
      await theirs.reload();
      await theirs.getByText('No levels here yet.').waitFor();
      await theirs.goto(link);
      await asked.getByRole('button', { name: 'Add level' }).click();
      await isOpen(theirs, 'Mine');
      await saved(theirs);
      await until(async () => expect(await theirs.getByRole('textbox', { name: 'range' }).inputValue()).toBe('260'));
      const run = reading.ok && reading.level.runs.length > 0;
      await verdict(theirs, run ? 'completable' : 'unproven');
      await theirs.reload();
      await isOpen(theirs, 'Mine');
      expect(await theirs.getByRole('tree', { name: 'Levels' }).getByRole('treeitem').count()).toBe(1);
      await Promise.all([one.context.close(), other.context.close()]);
      // only files were requested from the host
      const requests = hosted.asked.slice(before);
      expect(requests.filter((url) => !/^\/game\/($|assets\/[\w.-]+$|icon\.svg$)/.test(url))).toEqual([]);
      expect(complaints).toEqual([]);
    });

    it('offers the sample levels, which are loaded on request', async () => {
      const complaints: string[] = [];
      const one = await person(complaints);
      const page = await one.open(hosted.address);
      const samples = () => hosted.asked.filter((url) => url.includes('samples'));
      const add = page.getByRole('main').getByRole('button', { name: 'Add sample levels' });
      await add.waitFor();
      expect(samples()).toEqual([]);
      await add.click();
      await isOpen(page, 'First Pull');
      await verdict(page, 'completable');
      await saved(page);
      await until(async () =>
        expect(await page.getByRole('searchbox', { name: 'Find a level' }).getAttribute('placeholder')).toBe('Find in 22 levels'),
      );
      expect(samples()).toHaveLength(1);
      await page.reload();
      await isOpen(page, 'First Pull');
      await one.context.close();
      expect(complaints).toEqual([]);
    });

    it('describes the level of a link and adds nothing unasked; the page stays usable after a link to thousands of aliens', async () => {
      const complaints: string[] = [];
      const one = await person(complaints);
      const aliens = Array.from({ length: 4000 }, (_, i) => ({ x: 9 * (i % 100), y: 400 + 9 * Math.floor(i / 100), radius: 4 }));
      const page = await one.open(`${hosted.address}#level=${packed({ ...straight({ name: 'Swarm' }), aliens })}`);
      const asked = page.getByRole('dialog', { name: 'Add the level from the link?' });
      await asked.getByText('4,000 aliens', { exact: false }).waitFor();
      await asked.getByRole('list', { name: 'Warnings' }).getByText('very many objects').waitFor();
      await asked.getByRole('button', { name: "Don't add" }).click();
      expect(await page.getByRole('treeitem').count()).toBe(0);
      // another link in the same tab, as the opener of the page can send
      await page.evaluate(
        (hash) => {
          location.hash = hash;
        },
        `#level=${packed({ ...straight({ name: 'Swarm' }), aliens })}`,
      );
      await asked.getByRole('button', { name: 'Add level' }).click();
      await isOpen(page, 'Swarm');
      await page.getByText('work limit').first().waitFor();
      await page.reload();
      await isOpen(page, 'Swarm');
      await page.getByText('work limit').first().waitFor();
      // it can be edited like any other level
      await page.getByRole('textbox', { name: 'range' }).fill('333');
      await page.keyboard.press('Enter');
      await saved(page);
      await one.context.close();
      expect(complaints).toEqual([]);
    });

    it('does not automatically open a level that made the last page hang, and can open it without simulating it', async () => {
      const complaints: string[] = [];
      const one = await person(complaints);
      const page = await one.open(`${hosted.address}#level=${packed(straight({ name: 'Fatal' }))}`);
      await page.getByRole('button', { name: 'Add level' }).click();
      await isOpen(page, 'Fatal');
      await verdict(page, 'completable');
      await until(async () => expect(await page.evaluate("localStorage['gravity-quest-editor-opening']")).toBe('[]'));
      // the mark of a page that hangs while it opens the level
      await page.evaluate(`localStorage['gravity-quest-editor-opening'] = '["this-browser/fatal"]'`);
      await page.reload();
      const asked = page.getByRole('dialog', { name: 'This level was not opened' });
      await asked.getByRole('button', { name: 'Open without checks' }).click();
      await isOpen(page, 'Fatal');
      await page.getByText(/Checks are off/).waitFor();
      await verdict(page, 'unproven');
      await page.getByRole('button', { name: 'Turn checks on' }).click();
      await verdict(page, 'completable');
      await until(async () => expect(await page.evaluate("localStorage['gravity-quest-editor-opening']")).toBe('[]'));
      await page.evaluate(`localStorage['gravity-quest-editor-opening'] = '["this-browser/fatal"]'`);
      await page.reload();
      await asked.getByRole('button', { name: 'Delete' }).click();
      await page.getByText('No levels here yet.').waitFor();
      await one.context.close();
      expect(complaints).toEqual([]);
    });

    it('works without an answer from the database, reports that nothing is kept, and uses the database if it answers later', async () => {
      const complaints: string[] = [];
      const one = await person(complaints);
      const first = await one.open(`${hosted.address}#level=${packed(straight({ name: 'Before' }))}`);
      await first.getByRole('button', { name: 'Add level' }).click();
      await saved(first);
      await first.close();
      await one.context.addInitScript(() => {
        const { open } = IDBFactory.prototype;
        const held: (() => void)[] = [];
        Object.assign(window, {
          answer() {
            for (const go of held.splice(0)) go();
          },
        });
        IDBFactory.prototype.open = function (this: IDBFactory, name: string, version?: number) {
          if (sessionStorage.getItem('answers') !== null) return open.call(this, name, version);
          // a request without an answer until the test allows it
          const request = {} as Record<string, unknown>;
          held.push(() => {
            const real = open.call(this, name, version);
            for (const event of ['onsuccess', 'onerror', 'onupgradeneeded'] as const) {
              real[event] = (...given: unknown[]) => {
                Object.defineProperty(request, 'result', { get: () => real.result, configurable: true });
                (request[event] as ((...given: unknown[]) => void) | undefined)?.(...given);
              };
            }
          });
          return request as unknown as IDBOpenDBRequest;
        };
      });
      const page = await one.open(hosted.address);
      await page.getByText('No levels here yet.').waitFor();
      await page.getByText(/unsaved changes are lost/).waitFor();
      await page.getByRole('main').getByRole('button', { name: 'New level' }).click();
      await page.getByRole('dialog', { name: 'New level' }).getByRole('button', { name: 'Create' }).click();
      await page
        .getByRole('status', { name: 'Saving' })
        .filter({ hasText: /^in this tab only$/ })
        .waitFor();
      await page.evaluate("sessionStorage.setItem('answers', 'yes'); answer()");
      await page.getByRole('button', { name: 'Add them and reload' }).click();
      await until(async () => expect(await page.getByRole('tree', { name: 'Levels' }).getByRole('treeitem').count()).toBe(2));
      await saved(page);
      await one.context.close();
      expect(complaints).toEqual([]);
    });
  });
}
