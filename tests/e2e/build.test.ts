import { existsSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { basename, dirname, extname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { gq, makeFiles } from '../cli/gq.ts';
import { complaintsAbout } from './axe.ts';
import { sharedChromium } from './chromium.ts';
import { command, verdict } from './commands.ts';
import { hurry, nextFrames, paceFrames } from './frames.ts';
import { near, straight } from './levels.ts';
import { inChromium, type Stage } from './stage.ts';
import { PATIENCE, until } from './until.ts';

// What `gq build` and the editor publish, as players open it: from a file and from a web server that knows only files.

const TYPES: Readonly<Record<string, string>> = { '.html': 'text/html', '.js': 'text/javascript' };

/** Serves a folder below a path, as a project's page is served. */
function host(folder: string): Promise<{ address: string; end: () => void }> {
  const server = createServer(({ url = '' }, answer) => {
    const path = join(folder, new URL(url, 'http://host').pathname.replace(/^\/me\/levels\//, '') || 'index.html');
    if (!url.startsWith('/me/levels/') || !existsSync(path)) answer.writeHead(404).end();
    else answer.writeHead(200, { 'Content-Type': TYPES[extname(path)] ?? 'text/plain' }).end(readFileSync(path));
  });
  return new Promise((resolve) => {
    server.listen(0, '127.0.0.1', () => {
      const { port } = server.address() as AddressInfo;
      resolve({ address: `http://127.0.0.1:${port}/me/levels/`, end: () => void server.close() });
    });
  });
}

/** Opens a published page as a player, and lets her play. The page may ask only for what is below its address, and log nothing. */
async function asPlayer(address: string, play: (page: Page) => Promise<void>): Promise<void> {
  const browser = await sharedChromium();
  const context = await browser.newContext({ viewport: { width: 1024, height: 768 } });
  await context.addInitScript(paceFrames);
  const complaints: string[] = [];
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  page.on('pageerror', (error) => complaints.push(error.stack ?? error.message));
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
  const base = new URL('.', address).href;
  page.on(
    'request',
    (request) => /^(?:data|blob):/.test(request.url()) || request.url().startsWith(base) || complaints.push(request.url()),
  );
  try {
    await page.goto(address);
    await play(page);
    expect(complaints.filter((text) => !/GPU stall|swiftshader/i.test(text))).toEqual([]);
  } finally {
    await context.close();
  }
}

/** Plays the level `near` by hand, from the menu. */
async function completeFirst(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Play · Near' }).click();
  await page.getByRole('heading', { level: 1, name: /Near/ }).waitFor();
  await hurry(page, 8);
  await page.keyboard.down('Space');
  await page.getByRole('dialog', { name: 'Completed' }).waitFor();
  await page.keyboard.up('Space');
}

/** The dialog in which levels are published. */
async function openDialog(page: Page) {
  await command(page, 'Publish as a page to play');
  return page.getByRole('dialog', { name: 'Publish' });
}

inChromium('published pages in Chromium', ({ on }) => {
  let files: ReturnType<typeof makeFiles>;
  beforeAll(async () => {
    files = makeFiles({
      'levels/1.level.json': JSON.stringify(near({ name: 'Near' })),
      'levels/2.level.json': JSON.stringify(near({ name: 'Near </script> on' })),
    });
    const built = await gq(['build', 'levels', '--out', 'site', '--title', 'My <levels>'], { cwd: files.directory });
    expect(built).toMatchObject({ code: 0, stderr: '' });
  });
  afterAll(() => files.remove());

  it('gq build: is played from a file', async () => {
    await asPlayer(pathToFileURL(join(files.directory, 'site/index.html')).href, async (page) => {
      await page.getByRole('heading', { level: 1, name: 'My <levels>' }).waitFor();
      expect(await page.title()).toContain('My <levels>');
      expect(await page.getByRole('listitem').count()).toBe(2);
      await completeFirst(page);
      await page.getByRole('dialog').getByRole('button', { name: 'Levels', exact: true }).click();
      await page.getByText(/^1 of 2 levels/).waitFor();
      await page.getByRole('button', { name: 'Near </script> on' }).first().waitFor();
    });
  });

  it('gq build: is played from any path of a web server', async () => {
    const { address, end } = await host(join(files.directory, 'site'));
    try {
      await asPlayer(address, completeFirst);
    } finally {
      end();
    }
  });

  const inFolder = ({ folder }: Stage) => {
    const name = `${basename(folder)}-site`;
    const path = join(dirname(folder), name);
    return { name, path, remove: () => rmSync(path, { recursive: true, force: true }) };
  };

  it(
    'the editor publishes a folder, and asks before it publishes what nobody has completed, on a wide screen and a phone',
    on(
      { '01': straight(), '02': straight({ name: 'Unproven', runs: [] }) },
      async (stage) => {
        const { page } = stage;
        const site = inFolder(stage);
        try {
          await verdict(page, 'completable');
          const dialog = await openDialog(page);
          await dialog.getByRole('textbox', { name: 'Title' }).fill('Ours');
          await dialog.getByRole('textbox', { name: 'Folder' }).fill('../away');
          await dialog.getByText('The folder needs a name').waitFor();
          expect(await dialog.getByRole('button', { name: 'Publish', exact: true }).isDisabled()).toBe(true);
          await dialog.getByRole('textbox', { name: 'Folder' }).fill(site.name);
          await dialog.getByRole('button', { name: 'Publish', exact: true }).click();
          await dialog
            .getByRole('alert')
            .getByText(/unproven.*Unproven \(02\): the level has no run/)
            .waitFor();
          for (const width of [390, 1280]) {
            await page.setViewportSize({ width, height: 800 });
            await nextFrames(page);
            expect(await complaintsAbout(page, `publish, ${width} px`, '[role=dialog]')).toEqual([]);
            expect(await page.evaluate('document.documentElement.scrollWidth')).toBe(width);
          }
          expect(existsSync(site.path)).toBe(false);
          await dialog.getByRole('button', { name: 'Publish all the same' }).click();
          await dialog
            .getByRole('status')
            .getByText(/^Published 2 levels in /)
            .waitFor();
          await asPlayer(pathToFileURL(join(site.path, 'index.html')).href, async (game) => {
            await game.getByRole('heading', { level: 1, name: 'Ours' }).waitFor();
            expect(await game.getByRole('listitem').count()).toBe(2);
          });
          // someone else's folder
          rmSync(join(site.path, '.gq-build.json'));
          await dialog.getByRole('button', { name: 'Publish all the same' }).waitFor({ state: 'hidden' });
          await dialog.getByRole('radio', { name: 'This level alone, as a folder' }).check();
          await dialog.getByRole('button', { name: 'Publish', exact: true }).click();
          await dialog
            .getByRole('alert')
            .getByText(/has not made this folder.*choose another name/i)
            .waitFor();
        } finally {
          site.remove();
        }
      },
      // how Chromium logs that the server refuses
      { complaints: /status of 409/ },
    ),
  );

  it(
    'the editor makes one file of the open level, which needs nothing else',
    on({ '01': near({ name: 'Near' }), '02': straight({ name: 'Unproven', runs: [] }) }, async ({ page, folder }) => {
      await verdict(page, 'completable');
      const dialog = await openDialog(page);
      await dialog.getByRole('radio', { name: 'This level alone, as one HTML file' }).check();
      const [download] = await Promise.all([
        page.waitForEvent('download'),
        dialog.getByRole('button', { name: 'Publish', exact: true }).click(),
      ]);
      expect(download.suggestedFilename()).toBe('near.html');
      await dialog
        .getByRole('status')
        .getByText(/^Downloaded near\.html: 1 level, /)
        .waitFor();
      const path = join(folder, 'alone.html');
      writeFileSync(path, readFileSync(await download.path()));
      await asPlayer(pathToFileURL(path).href, completeFirst);
    }),
  );

  it(
    'a play-only link opens the level in a published page, whose address the editor remembers',
    on({ '01': straight({ name: 'Shared' }) }, async ({ page }) => {
      await verdict(page, 'completable');
      await command(page, 'Import, export, link');
      const dialog = page.getByRole('dialog', { name: 'Import, export, link' });
      await dialog.getByRole('tab', { name: 'Link' }).click();
      await dialog.getByRole('radio', { name: /^play only/ }).check();
      await dialog.getByText('publish one, put it on a web server').waitFor();
      const link = dialog.getByRole('textbox', { name: 'Link with the level' });
      expect(await link.count()).toBe(0);
      await dialog.getByRole('textbox', { name: 'Address of the page' }).fill('javascript:alert(1)');
      await dialog.getByText('expected an address that begins with https://').waitFor();
      const { address, end } = await host(join(files.directory, 'site'));
      try {
        await dialog.getByRole('textbox', { name: 'Address of the page' }).fill(`${address}#old`);
        await until(async () => expect(await link.inputValue()).toMatch(/#level=[\w-]+&accuracy=precise&max-time=60$/));
        const url = await link.inputValue();
        expect(url.startsWith(`${address}#level=`)).toBe(true);
        await asPlayer(url, async (game) => {
          await game.getByRole('heading', { level: 1, name: 'Shared' }).waitFor();
        });
      } finally {
        end();
      }
      await page.reload();
      await verdict(page, 'completable');
      await command(page, 'Import, export, link');
      await dialog.getByRole('tab', { name: 'Link' }).click();
      await dialog.getByRole('radio', { name: /^play only/ }).check();
      expect(await dialog.getByRole('textbox', { name: 'Address of the page' }).inputValue()).toBe(`${address}#old`);
    }),
  );
});
