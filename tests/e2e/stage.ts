import { chmodSync, existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { type Browser, type BrowserContext, type BrowserContextOptions, chromium, type Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect } from 'vitest';
import type { LevelFile } from '../../schema/index.ts';
import { declareMissing } from '../missing.ts';
import { gqEdit, type RunningEdit } from '../server/command.ts';
import { makeFolder, put } from '../server/running.ts';
import { type Canvas, canvasOf } from './canvas.ts';
import { PATIENCE } from './until.ts';

export const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
export const CHROMIUM_ARGS = [
  ...['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking'],
  ...['--disable-component-update', '--disable-sync', '--mute-audio'],
  // Chromium would load pages of its own for the address bar of every window: more work for the processor than a page of ours
  '--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup,SpareRendererForSitePerProcess',
  // without a graphics card the processor draws what WebGL is asked for
  '--enable-unsafe-swiftshader',
];

export interface StageOptions {
  readonly context?: BrowserContextOptions;
  /** Whether it is the first time that this person sees the editor. */
  readonly firstTime?: boolean;
  /** The level files may not be written. */
  readonly readOnly?: boolean;
  /** Other files in the folder, by name. */
  readonly others?: Readonly<Record<string, string>>;
  /** What the browser may complain of on its console. */
  readonly complaints?: RegExp;
  /** What is asked for in the page's address: `renderer=webgl`. */
  readonly query?: string;
}

/** A folder of levels, a server on it, and a person in front of its page. */
export interface Stage {
  readonly folder: string;
  readonly context: BrowserContext;
  readonly page: Page;
  readonly canvas: Canvas;
  /** The server that runs now. */
  server(): RunningEdit;
  /** Another page of the same person, on the same server. */
  open(): Promise<{ page: Page; canvas: Canvas }>;
  /** The text of a level's file. */
  text(id: string): string;
  /** A level's file. */
  file(id: string): LevelFile;
  /** Writes into the folder as another program does. */
  write(id: string, content: unknown): void;
  /** Waits until the page says that all is on the disk. */
  saved(): Promise<void>;
  /** Ends the server as a crash does. */
  killServer(): Promise<void>;
  /** Starts it again on the same folder, port and token, as far as it can. */
  startServer(port?: number): Promise<void>;
}

export interface Browsers {
  /** Plays a scene on a stage of its own. */
  on(
    levels: Readonly<Record<string, unknown>>,
    play: (stage: Stage) => Promise<void>,
    options?: StageOptions,
  ): () => Promise<void>;
}

/** Runs in a page before its own scripts: settings that are there already stay. */
const KNOWN = `localStorage['gravity-quest-editor-settings'] ??= '{"tourSeen":true}'`;

/** Opens a level's page and waits until it can be used. */
async function enter(context: BrowserContext, address: string, complaints: string[]): Promise<{ page: Page; canvas: Canvas }> {
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  page.on('pageerror', (error) => complaints.push(error.stack ?? error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  await page.goto(address);
  await page.getByRole('application', { name: 'Level canvas' }).waitFor();
  return { page, canvas: canvasOf(page) };
}

const textOf = (content: unknown): string => (typeof content === 'string' ? content : `${JSON.stringify(content, null, 2)}\n`);

/** Number of the user who owns nothing. */
const NOBODY = 65534;

/** Prints what the pages show as assistive technology reads it: a failure on another machine can't be looked at. */
async function tellPages(context: BrowserContext, complaints: readonly string[]): Promise<void> {
  for (const page of context.pages()) {
    try {
      console.error(await page.locator('body').ariaSnapshot({ timeout: 10_000 }));
    } catch (error) {
      console.error('the page does not answer:', error);
    }
  }
  if (complaints.length > 0) console.error('complaints of the pages:', complaints);
}

/** Suites in one Chromium that all tests of the file share; each test has a folder, a server and a profile of its own. */
export function inChromium(suite: string, declare: (browsers: Browsers) => void): void {
  if (!existsSync(CHROMIUM)) {
    declareMissing(suite, `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
    return;
  }
  describe(suite, () => {
    let browser: Browser;
    beforeAll(async () => {
      browser = await chromium.launch({ executablePath: CHROMIUM, headless: true, args: CHROMIUM_ARGS });
    });
    afterAll(() => browser.close());

    declare({
      on:
        (
          levels,
          play,
          { context: wanted = {}, firstTime = false, complaints: expected, readOnly = false, query = '', others = {} } = {},
        ) =>
        async () => {
          const files = Object.entries(levels).map(([id, content]) => [`${id}.level.json`, textOf(content)] as const);
          const { folder, remove } = makeFolder({ ...others, ...Object.fromEntries(files) });
          if (readOnly) for (const [name] of files) chmodSync(join(folder, name), 0o444);
          // root may write everything: then the server is somebody who may not
          const user = readOnly && process.getuid?.() === 0 ? NOBODY : undefined;
          if (user !== undefined) chmodSync(folder, 0o755);
          let server = await gqEdit(['.', '--port', '0'], { cwd: folder, user });
          const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...wanted });
          // the tour would lie over the page
          if (!firstTime) await context.addInitScript(KNOWN);
          const complaints: string[] = [];
          const address = () => {
            const asked = new URL(server.address);
            asked.search = query;
            return asked.href;
          };
          try {
            await context.grantPermissions(['clipboard-read', 'clipboard-write'], { origin: new URL(server.address).origin });
            const { page, canvas } = await enter(context, address(), complaints);
            const text = (id: string) => readFileSync(join(folder, `${id}.level.json`), 'utf8');
            await play({
              folder,
              context,
              page,
              canvas,
              server: () => server,
              open: () => enter(context, address(), complaints),
              text,
              file: (id) => JSON.parse(text(id)) as LevelFile,
              write: (id, content) => put(folder, `${id}.level.json`, textOf(content)),
              saved: () =>
                page
                  .getByRole('status', { name: 'Saving' })
                  .filter({ hasText: /^saved$/ })
                  .waitFor(),
              async killServer() {
                await server.end('SIGKILL');
              },
              async startServer(port = server.port) {
                server = await gqEdit(['.', '--port', String(port)], { cwd: folder });
              },
            });
            expect(complaints.filter((complaint) => expected?.test(complaint) !== true)).toEqual([]);
          } catch (error) {
            await tellPages(context, complaints);
            throw error;
          } finally {
            await context.close();
            await server.end('SIGTERM');
            remove();
          }
        },
    });
  });
}
