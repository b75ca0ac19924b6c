import { chmodSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import type { BrowserContext, BrowserContextOptions, Page } from 'playwright-core';
import { startServer } from '../../cli/serve/index.ts';
import { gqEdit } from '../server/command.ts';
import { makeFolder } from '../server/running.ts';
import { type Canvas, canvasOf } from './canvas.ts';
import { sharedChromium } from './chromium.ts';
import { paceFrames } from './frames.ts';
import { PATIENCE } from './until.ts';

export type Files = Readonly<Record<string, string>>;

export interface PlaceOptions {
  readonly context?: BrowserContextOptions;
  /** Runs in a page before its own scripts. */
  readonly before?: () => void;
  /** Whether this user opens the editor for the first time. */
  readonly firstTime?: boolean;
  /** Whether the level files are read-only. */
  readonly readOnly?: boolean;
  /** Whether the server is a process of its own, which can be killed; otherwise it runs in the process of the test. */
  readonly ownProcess?: boolean;
  /** The query of the page's address, such as `renderer=webgl`. */
  readonly query?: string;
  /** The fragment of the page's address besides the token, such as `level=01&tick=12`. */
  readonly fragment?: string;
}

export interface PlaceServer {
  readonly port: number;
  /** Contains the token of this run. */
  readonly address: string;
  /** Its errors: stderr of the process, or the errors that were caught in this process. */
  complaints(): string;
  end(signal: 'SIGTERM' | 'SIGKILL'): Promise<unknown>;
}

/** A folder of levels, a server on it, and a page in a browser context. */
export interface Place {
  readonly folder: string;
  readonly context: BrowserContext;
  readonly page: Page;
  readonly canvas: Canvas;
  /** What the pages complained of. */
  readonly complaints: string[];
  /** The current server. */
  server(): PlaceServer;
  /** Opens another page of the same browser and server. */
  open(): Promise<{ page: Page; canvas: Canvas }>;
  /** Starts the server again on the same folder, where it ran before. */
  startServer(port?: number): Promise<void>;
  /** Ends all. @param isGood whether the next test may use the browser context */
  leave(isGood: boolean): Promise<void>;
}

/** A browser context and its page. The next test loads another page of its own in it. */
interface Seat {
  readonly context: BrowserContext;
  readonly page: Page;
  /** Of its last server. The scripts of the same origin are still compiled, which saves more than half of the time to load. */
  port: number;
  readonly complaints: string[];
  /** Whether a test has crashed its page. */
  hasCrashed: boolean;
}

/** Runs in a page before its own scripts: a test can't answer the dialogs of the system, only those of the older ways. */
function withoutPickers(): void {
  for (const name of ['showOpenFilePicker', 'showSaveFilePicker']) delete (window as unknown as Record<string, unknown>)[name];
}

/** Runs in a page before its own scripts; existing settings stay. */
const KNOWN = `localStorage['gravity-quest-editor-settings'] ??= '{"tourSeen":true}'`;

/** An empty page of the server's origin, from which what is stored there can be taken away. */
const BETWEEN = '/between';
/** With the isolation of the editor's page: otherwise the browser would go on in another process. */
const ISOLATION = { 'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp' };

const DESK = { width: 1280, height: 800 };

/** The id of the user `nobody`. */
const NOBODY = 65534;

const BUILT_PAGE = fileURLToPath(new URL('../../dist/editor', import.meta.url));
const BUILT_GAME = fileURLToPath(new URL('../../dist/site', import.meta.url));

/** Serves a folder from this process, which is much cheaper than another process. */
async function serveHere(folder: string, port: number): Promise<PlaceServer> {
  let complaints = '';
  const onCrash = (error: unknown) => {
    complaints += `${error instanceof Error ? error.stack : error}\n`;
  };
  const server = await startServer({ folder, port, configFrom: folder, page: BUILT_PAGE, game: BUILT_GAME, onCrash });
  return { port: server.port, address: server.address, complaints: () => complaints, end: server.close };
}

/** Serves the folder from a process of its own. */
async function serveThere(folder: string, port: number, user: number | undefined): Promise<PlaceServer> {
  const { said, ...server } = await gqEdit(['.', '--port', String(port)], { cwd: folder, user });
  return { ...server, complaints: () => said().stderr };
}

/** Prints the accessibility trees of the pages, as a failure on another machine can't be inspected. */
export async function tellPages(context: BrowserContext, complaints: readonly string[]): Promise<void> {
  for (const page of context.pages()) {
    try {
      console.error(await page.locator('body').ariaSnapshot({ timeout: 10_000 }));
    } catch (error) {
      console.error('the page does not answer:', error);
    }
  }
  if (complaints.length > 0) console.error('complaints of the pages:', complaints);
}

async function newPage(context: BrowserContext, complaints: string[]): Promise<Page> {
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  page.on('pageerror', (error) => complaints.push(error.stack ?? error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  return page;
}

async function newSeat({ context: wanted = {}, firstTime = false, before }: PlaceOptions): Promise<Seat> {
  const browser = await sharedChromium();
  // decorations stand still: to draw them thirty times a second takes more processor time than most tests
  const context = await browser.newContext({ viewport: DESK, reducedMotion: 'reduce', ...wanted });
  await context.addInitScript(paceFrames);
  await context.addInitScript(withoutPickers);
  if (before !== undefined) await context.addInitScript(before);
  // the tour would cover the page
  if (!firstTime) await context.addInitScript(KNOWN);
  await context.route(`http://127.0.0.1:*${BETWEEN}`, (route) =>
    route.fulfill({ contentType: 'text/html', body: '', headers: ISOLATION }),
  );
  const complaints: string[] = [];
  const seat = { context, page: await newPage(context, complaints), port: 0, complaints, hasCrashed: false };
  seat.page.on('crash', () => {
    seat.hasCrashed = true;
  });
  return seat;
}

/** Leaves the page of a test, and takes away what it and the ones before it have stored at an origin. */
async function clear({ context, page, complaints }: Seat, origin: string): Promise<void> {
  await page.mouse.move(0, 0);
  await page.goto(new URL(BETWEEN, origin).href);
  await page.evaluate(() => sessionStorage.clear());
  const browser = await context.newCDPSession(page);
  await browser.send('Storage.clearDataForOrigin', { origin, storageTypes: 'all' });
  await browser.detach();
  complaints.length = 0;
}

/** The seat of the last test, if it is as good as new. */
let kept: Seat | null = null;

/** Options of a context that a page can change. */
const CHANGEABLE = ['colorScheme', 'reducedMotion', 'forcedColors', 'viewport'];

/** Whether a test can work in a context that others have used. */
const canShare = ({ context = {}, before, firstTime = false }: PlaceOptions): boolean =>
  before === undefined && !firstTime && Object.keys(context).every((name) => CHANGEABLE.includes(name));

/** A seat for a test: that of the last one if possible. */
async function seatFor(options: PlaceOptions): Promise<Seat> {
  if (!canShare(options)) return newSeat(options);
  const seat = kept ?? (await newSeat({}));
  kept = null;
  const { viewport, colorScheme = 'light', reducedMotion = 'reduce', forcedColors = 'none' } = options.context ?? {};
  await seat.page.setViewportSize(viewport ?? DESK);
  await seat.page.emulateMedia({ colorScheme, reducedMotion, forcedColors });
  return seat;
}

/** Opens a page on a folder of its own. */
export async function openPlace(files: Files, options: PlaceOptions): Promise<Place> {
  const { readOnly = false, ownProcess = readOnly, query = '', fragment = '' } = options;
  const { folder, remove } = makeFolder(files);
  if (readOnly) for (const name of Object.keys(files)) if (name.endsWith('.level.json')) chmodSync(join(folder, name), 0o444);
  // root may write everything, so the server runs as another user
  const user = readOnly && process.getuid?.() === 0 ? NOBODY : undefined;
  if (user !== undefined) chmodSync(folder, 0o755);

  const seat = await seatFor(options);
  const { context, page, complaints } = seat;
  const serve = (port: number) => (ownProcess ? serveThere(folder, port, user) : serveHere(folder, port));
  // somebody may have taken the port since the last test: only the time to compile is lost then
  let server = await serve(seat.port).catch((error) => {
    if (seat.port === 0) throw error;
    return serve(0);
  });
  seat.port = server.port;
  const { origin } = new URL(server.address);

  const enter = async (entered: Page): Promise<{ page: Page; canvas: Canvas }> => {
    const asked = new URL(server.address);
    asked.search = query;
    if (fragment !== '') asked.hash += `&${fragment}`;
    await entered.goto(asked.href);
    await entered.getByRole('application', { name: 'Level canvas' }).waitFor();
    return { page: entered, canvas: canvasOf(entered) };
  };
  const leave = async (isGood: boolean): Promise<void> => {
    const stays = isGood && canShare(options) && !page.isClosed() && !seat.hasCrashed;
    if (stays) {
      for (const other of context.pages()) if (other !== page) await other.close();
      await page.unrouteAll();
      // the page must not miss its server
      await clear(seat, origin);
      kept = seat;
    } else await context.close();
    await server.end('SIGTERM');
    remove();
  };
  try {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'], { origin });
    return {
      ...(await enter(page)),
      folder,
      context,
      complaints,
      server: () => server,
      open: async () => enter(await newPage(context, complaints)),
      async startServer(port = server.port) {
        server = await serve(port);
      },
      leave,
    };
  } catch (error) {
    await tellPages(context, complaints);
    await leave(false);
    throw error;
  }
}
