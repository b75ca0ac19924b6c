import { existsSync, readFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Browser, type BrowserContext, chromium, type Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { readLevel } from '../../schema/index.ts';
import { declareMissing } from '../missing.ts';
import { verdict } from './commands.ts';
import { CHROMIUM, CHROMIUM_ARGS } from './stage.ts';
import { PATIENCE, until } from './until.ts';

// The built page on a host that serves files and nothing else, below a folder of its own: levels are kept in the browser.

const BUILT = fileURLToPath(new URL('../../dist/editor', import.meta.url));
const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
};

/** A host of files. @returns with the address of the page */
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
      [browser, hosted] = await Promise.all([
        chromium.launch({ executablePath: CHROMIUM, headless: true, args: CHROMIUM_ARGS }),
        host(),
      ]);
    });
    afterAll(async () => {
      await browser.close();
      hosted.server.close();
    });

    /** A person with a browser of their own. */
    const person = async (
      complaints: string[],
    ): Promise<{ context: BrowserContext; open: (address: string) => Promise<Page> }> => {
      const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
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

    it('makes a level, edits it, has it after a reload, sends it by link, downloads it', async () => {
      const complaints: string[] = [];
      const one = await person(complaints);
      const page = await one.open(hosted.address);
      await page.getByText('No levels here yet.').waitFor();
      await page.getByRole('main').getByRole('button', { name: 'New level' }).click();
      const dialog = page.getByRole('dialog', { name: 'New level' });
      await dialog.getByText('A first swing').click();
      await dialog.getByLabel('Name of the level').fill('Mine');
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

      // another person, who has nothing yet
      const other = await person(complaints);
      const theirs = await other.open(link);
      await isOpen(theirs, 'Mine');
      await saved(theirs);
      await until(async () => expect(await theirs.getByRole('textbox', { name: 'range' }).inputValue()).toBe('260'));
      const run = reading.ok && reading.level.runs.length > 0;
      await verdict(theirs, run ? 'completable' : 'unproven');
      await theirs.reload();
      await isOpen(theirs, 'Mine');
      expect(await theirs.getByRole('tree', { name: 'Levels' }).getByRole('treeitem').count()).toBe(1);
      await Promise.all([one.context.close(), other.context.close()]);
      // nothing was asked of the host but its files
      expect(hosted.asked.filter((url) => !/^\/game\/($|assets\/[\w.-]+$|icon\.svg$)/.test(url))).toEqual([]);
      expect(complaints).toEqual([]);
    });
  });
}
