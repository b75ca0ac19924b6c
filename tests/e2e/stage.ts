import { chmodSync, existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import type { BrowserContext, BrowserContextOptions, Page } from 'playwright-core';
import { describe, expect } from 'vitest';
import { startServer } from '../../cli/serve/index.ts';
import { type LevelFile, readLevel } from '../../schema/index.ts';
import { declareMissing } from '../missing.ts';
import { gqEdit } from '../server/command.ts';
import { makeFolder, put } from '../server/running.ts';
import { type Canvas, canvasOf } from './canvas.ts';
import { CHROMIUM, sharedChromium } from './chromium.ts';
import { BETWEEN, type KeptPage, keepPage } from './kept-page.ts';
import { PATIENCE } from './until.ts';

export interface StageOptions {
  readonly context?: BrowserContextOptions;
  /** Runs in a page before its own scripts. */
  readonly before?: () => void;
  /** Whether the test needs a page that no other has used: it changes what can't be seen on it. */
  readonly ownPage?: boolean;
  /** Whether this user opens the editor for the first time. */
  readonly firstTime?: boolean;
  /** Whether the level files are read-only. */
  readonly readOnly?: boolean;
  /** Whether the server is a process of its own, which can be killed; otherwise it runs in the process of the test. */
  readonly ownProcess?: boolean;
  /** Other files in the folder, by name. */
  readonly others?: Readonly<Record<string, string>>;
  /** Messages that the browser may log. */
  readonly complaints?: RegExp;
  /** The query of the page's address, such as `renderer=webgl`. */
  readonly query?: string;
  /** The fragment of the page's address besides the token, such as `level=01&tick=12`. */
  readonly fragment?: string;
}

interface StageServer {
  readonly port: number;
  /** Contains the token of this run. */
  readonly address: string;
  /** Its errors: stderr of the process, or the errors that were caught in this process. */
  complaints(): string;
  end(signal: 'SIGTERM' | 'SIGKILL'): Promise<unknown>;
}

/** A folder of levels, a server on it, and its page in a browser. */
export interface Stage {
  readonly folder: string;
  readonly context: BrowserContext;
  readonly page: Page;
  readonly canvas: Canvas;
  /** The current server. */
  server(): StageServer;
  /** Opens another page of the same browser and server. */
  open(): Promise<{ page: Page; canvas: Canvas }>;
  /** Reads the text of a level file. */
  text(id: string): string;
  /** Reads a level file. */
  file(id: string): LevelFile;
  /** Writes a file like another program. */
  write(id: string, content: unknown): void;
  /** Waits until the page reports that everything is on disk. */
  saved(): Promise<void>;
  /** Kills the server, which must be a process of its own. */
  killServer(): Promise<void>;
  /** Starts it again on the same folder, and on the same port if possible. */
  startServer(port?: number): Promise<void>;
}

export interface Browsers {
  /** Runs a test on a stage that is as new. */
  on(
    levels: Readonly<Record<string, unknown>>,
    play: (stage: Stage) => Promise<void>,
    options?: StageOptions,
  ): () => Promise<void>;
}

/** Runs in a page before its own scripts: a test can't answer the dialogs of the system, only those of the older ways. */
function withoutPickers(): void {
  for (const name of ['showOpenFilePicker', 'showSaveFilePicker']) delete (window as unknown as Record<string, unknown>)[name];
}

/** Runs in a page before its own scripts; existing settings stay. */
const KNOWN = `localStorage['gravity-quest-editor-settings'] ??= '{"tourSeen":true}'`;

/**
 * Runs in a page before its own scripts.
 * Draws about 20 frames per second, not 60, which would use half a processor.
 * The clock of frames and `performance.now` can run faster or stand still: see `hurry` and `pass`. Timers and dates do not
 * change.
 */
export function paceFrames(): void {
  const now = performance.now.bind(performance);
  const clock = { rate: 1, real: 0, shown: 0 };
  const shownAt = (real: number) => clock.shown + (real - clock.real) * clock.rate;
  performance.now = () => shownAt(now());
  const setRate = (rate: number) => {
    const real = now();
    Object.assign(clock, { rate, real, shown: shownAt(real) });
  };
  const pass = (ms: number) => {
    clock.shown += ms;
  };
  Object.assign(window, { setRate, pass });

  const ask = window.requestAnimationFrame.bind(window);
  const cancel = window.cancelAnimationFrame.bind(window);
  const cancels = new Map<number, () => void>();
  let last = 0;
  window.requestAnimationFrame = (callback) => {
    const id = ++last;
    const timer = setTimeout(() => {
      const frame = ask((real) => {
        cancels.delete(id);
        callback(shownAt(real));
      });
      cancels.set(id, () => cancel(frame));
    }, 34);
    cancels.set(id, () => clearTimeout(timer));
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    cancels.get(id)?.();
    cancels.delete(id);
  };
}

/**
 * Sets the pace of frames until the page is reloaded.
 * @param rate seconds of the frames' clock per second; 0: the clock stands still. A playtest advances at most 0.25 s per frame.
 */
export const hurry = (page: Page, rate: number): Promise<void> => page.evaluate(`setRate(${rate})`);

/** Advances the clock of the frames at once. */
export const pass = (page: Page, ms: number): Promise<void> => page.evaluate(`pass(${ms})`);

/** Waits for two frames, after which all changes are drawn. */
export const nextFrames = (page: Page): Promise<unknown> =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

/** Opens the page of a level and waits until it is ready. */
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

const isLevel = (name: string): boolean => name.endsWith('.level.json');

const DESK = { width: 1280, height: 800 };
/** Decorations stand still: to draw them thirty times a second takes more processor time than most tests. */
const CALM = { reducedMotion: 'reduce' } as const;

/** The id of the user `nobody`. */
const NOBODY = 65534;

const BUILT_PAGE = fileURLToPath(new URL('../../dist/editor', import.meta.url));
const BUILT_GAME = fileURLToPath(new URL('../../dist/site', import.meta.url));

/** Serves a folder from this process, which is much cheaper than another process. */
async function serveHere(folder: string): Promise<StageServer> {
  let complaints = '';
  const onCrash = (error: unknown) => {
    complaints += `${error instanceof Error ? error.stack : error}\n`;
  };
  const { port, address, close } = await startServer({
    folder,
    port: 0,
    configFrom: folder,
    page: BUILT_PAGE,
    game: BUILT_GAME,
    onCrash,
  });
  return { port, address, complaints: () => complaints, end: close };
}

/** Serves the folder from a process of its own. */
async function serveThere(folder: string, port: number, user: number | undefined): Promise<StageServer> {
  const { said, ...server } = await gqEdit(['.', '--port', String(port)], { cwd: folder, user });
  return { ...server, complaints: () => said().stderr };
}

/** Prints the accessibility trees of the pages, as a failure on another machine can't be inspected. */
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

/** A folder of levels, a server on it, and a page in a browser context. */
interface Place {
  readonly folder: string;
  readonly context: BrowserContext;
  readonly page: Page;
  readonly canvas: Canvas;
  readonly complaints: string[];
  server(): StageServer;
  open(): Promise<{ page: Page; canvas: Canvas }>;
  startServer(port?: number): Promise<void>;
  close(): Promise<void>;
}

type Files = Readonly<Record<string, string>>;

/** Opens a page on a folder of its own. */
async function openPlace(files: Files, options: StageOptions): Promise<Place> {
  const {
    context: wanted = {},
    firstTime = false,
    readOnly = false,
    ownProcess = readOnly,
    query = '',
    fragment = '',
    before,
  } = options;
  const { folder, remove } = makeFolder(files);
  if (readOnly) for (const name of Object.keys(files)) if (isLevel(name)) chmodSync(join(folder, name), 0o444);
  // root may write everything, so the server runs as another user
  const user = readOnly && process.getuid?.() === 0 ? NOBODY : undefined;
  if (user !== undefined) chmodSync(folder, 0o755);
  let server = ownProcess ? await serveThere(folder, 0, user) : await serveHere(folder);
  const browser = await sharedChromium();
  const context = await browser.newContext({ viewport: DESK, ...CALM, ...wanted });
  await context.addInitScript(paceFrames);
  await context.addInitScript(withoutPickers);
  if (before !== undefined) await context.addInitScript(before);
  // the tour would cover the page
  if (!firstTime) await context.addInitScript(KNOWN);
  const complaints: string[] = [];
  const open = () => {
    const asked = new URL(server.address);
    asked.search = query;
    if (fragment !== '') asked.hash += `&${fragment}`;
    return enter(context, asked.href, complaints);
  };
  const close = async () => {
    await context.close();
    await server.end('SIGTERM');
    remove();
  };
  try {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'], { origin: new URL(server.address).origin });
    const opened = await open();
    return {
      ...opened,
      folder,
      context,
      complaints,
      server: () => server,
      open,
      async startServer(port = server.port) {
        server = await serveThere(folder, port, user);
      },
      close,
    };
  } catch (error) {
    await tellPages(context, complaints);
    await close();
    throw error;
  }
}

let kept: (KeptPage & { readonly place: Place }) | null = null;

/** Options that a page can change while it is open. */
const CHANGEABLE = ['colorScheme', 'reducedMotion', 'forcedColors'];

/** Whether the page can open the first level of a list by a click. */
function isFirstValid(files: Files): boolean {
  const [first] = Object.keys(files).filter(isLevel).sort();
  return first !== undefined && readLevel(Buffer.from(files[first])).ok;
}

/** Whether a test can work in the page that others have used. */
const canShare = (files: Files, { context = {}, ...options }: StageOptions): boolean =>
  !options.ownPage &&
  Object.keys(options).every((name) => name === 'others' || name === 'complaints') &&
  Object.keys(context).every((name) => CHANGEABLE.includes(name)) &&
  // the page tells of a configuration that appears
  !('gq.config.json' in files) &&
  isFirstValid(files);

/** The place of a test: that of the last one if possible. */
async function placeFor(files: Files, options: StageOptions): Promise<Place> {
  if (!canShare(files, options)) return openPlace(files, options);
  if (kept === null) {
    const place = await openPlace(BETWEEN, {});
    kept = { ...(await keepPage(place.context, place.page, place.folder)), place };
  }
  const { place, page } = kept;
  const { colorScheme = 'light', reducedMotion = 'reduce', forcedColors = 'none' } = options.context ?? {};
  try {
    await page.emulateMedia({ colorScheme, reducedMotion, forcedColors });
    await hurry(page, 1);
    await kept.show(files);
  } catch (error) {
    await tellPages(place.context, place.complaints);
    kept = null;
    await place.close();
    throw error;
  }
  place.complaints.length = 0;
  return place;
}

/** @param isGood whether the test has passed, and left the page usable */
async function leave(place: Place, isGood: boolean): Promise<void> {
  if (place !== kept?.place) return place.close();
  const { page, context, complaints } = place;
  try {
    for (const other of context.pages()) if (other !== page) await other.close();
    if (isGood && !page.isClosed()) {
      await page.unrouteAll();
      await page.setViewportSize(DESK);
      await page.emulateMedia({ colorScheme: 'light', ...CALM, forcedColors: 'none' });
      await hurry(page, 1);
      if (await kept.clear()) {
        complaints.length = 0;
        return;
      }
    }
    kept = null;
    await place.close();
  } catch (error) {
    kept = null;
    await tellPages(context, complaints);
    await place.close();
    throw error;
  }
}

/**
 * Declares a suite in the Chromium of the worker. Each test has a folder, a server and a page: new ones, or those that another
 * test has left as new.
 */
export function inChromium(suite: string, declare: (browsers: Browsers) => void): void {
  if (!existsSync(CHROMIUM)) {
    declareMissing(suite, `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
    return;
  }
  describe(suite, () => {
    declare({
      on:
        (levels, play, options = {}) =>
        async () => {
          const { complaints: expected, readOnly = false, ownProcess = readOnly, others = {} } = options;
          const texts = Object.entries(levels).map(([id, content]) => [`${id}.level.json`, textOf(content)] as const);
          const place = await placeFor({ ...others, ...Object.fromEntries(texts) }, options);
          const { folder, page, canvas, complaints, server } = place;
          const text = (id: string) => readFileSync(join(folder, `${id}.level.json`), 'utf8');
          let isGood = false;
          let isTouched = false;
          try {
            await play({
              folder,
              page,
              canvas,
              server,
              get context() {
                // nobody knows what a test does with it
                isTouched = true;
                return place.context;
              },
              open: place.open,
              text,
              file: (id) => JSON.parse(text(id)) as LevelFile,
              write: (id, content) => put(folder, `${id}.level.json`, textOf(content)),
              saved: () =>
                page
                  .getByRole('status', { name: 'Saving' })
                  .filter({ hasText: /^saved$/ })
                  .waitFor(),
              async killServer() {
                expect(ownProcess, 'only a server that is a process can be killed').toBe(true);
                await server().end('SIGKILL');
              },
              startServer: place.startServer,
            });
            expect(complaints.filter((complaint) => expected?.test(complaint) !== true)).toEqual([]);
            expect(server().complaints(), 'complaints of the server').toBe('');
            isGood = !isTouched;
          } catch (error) {
            await tellPages(place.context, complaints);
            throw error;
          } finally {
            await leave(place, isGood);
          }
        },
    });
  });
}
