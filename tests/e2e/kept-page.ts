import { readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import type { BrowserContext, Page } from 'playwright-core';
import { createSettings } from '../../editor/core/settings/index.ts';
import { put } from '../server/running.ts';
import { type Canvas, canvasOf } from './canvas.ts';
import { until } from './until.ts';

// One page for test after test: another level costs it half of what a new page costs. Between two tests only the level
// "Between" is there, and the page must look exactly as it did when it was new; otherwise the next test gets a new page.

const ID = 'between';
/** Where the page keeps which level is open. */
const OPENED = 'gravity-quest-last-level';
const SETTINGS = 'gravity-quest-editor-settings';
/** When a level was opened, and by which tab: no two times are the same. */
const PASSING = ['gravity-quest-editor-opening', 'gravity-quest-editor-tab', OPENED];

const levelNamed = (name: string): string =>
  `${JSON.stringify({
    version: 1,
    name,
    astronaut: { x: 200, y: 304 },
    blackHole: { x: 704, y: 304 },
    asteroids: [{ id: 'rock', x: 448, y: 304, radius: 16 }],
    runs: [{ name: 'solution', holds: [[0, 600]] }],
  })}\n`;

/** The level between two tests. */
export const BETWEEN: Readonly<Record<string, string>> = { [`${ID}.level.json`]: levelNamed('Between') };

/** How often a page that does not look like a new one is looked at again. */
const MOST = 8;
/** ms that it may take to look like a new one. A page that takes longer is closed: that costs time, and no test fails by it. */
const PATIENCE = 20_000;

/** @returns false as well if nothing comes in time */
async function inTime(comes: Promise<boolean>): Promise<boolean> {
  let timer: NodeJS.Timeout | undefined;
  const late = new Promise<boolean>((resolve) => {
    timer = setTimeout(resolve, PATIENCE, false);
  });
  const answer = await Promise.race([comes.catch(() => false), late]);
  clearTimeout(timer);
  return answer;
}

export interface KeptPage {
  readonly context: BrowserContext;
  readonly page: Page;
  readonly canvas: Canvas;
  readonly folder: string;
  /** Shows these files, and opens the first of them. */
  show(files: Readonly<Record<string, string>>): Promise<void>;
  /** Closes everything and takes the files away. @returns whether the page looks like a new one */
  clear(): Promise<boolean>;
}

const levels = (page: Page) => page.getByRole('tree', { name: 'Levels' }).getByRole('treeitem');
const isOpen = (page: Page, name: string) => page.getByRole('heading', { level: 1, name, exact: true }).waitFor();
const isListed = (page: Page, count: number) =>
  until(async () => {
    if ((await levels(page).count()) !== count) throw new Error(`not ${count} levels`);
  });

/** All that a person meets on the page, and what it has stored. */
async function looksOf(page: Page): Promise<string> {
  const stored = await page.evaluate(() => [Object.entries(localStorage), Object.keys(sessionStorage)] as const);
  const [local, session] = stored;
  const kept = local.filter(([key]) => key !== SETTINGS && !PASSING.includes(key)).map(([key, text]) => `${key}: ${text}`);
  const text = local.find(([key]) => key === SETTINGS)?.[1] ?? null;
  const settings = createSettings({ getItem: () => text, setItem: () => {} }).getState();
  const keys = session.filter((key) => !PASSING.includes(key)).sort();
  // how long the last simulation took is another time each time
  const seen = (await page.locator('body').ariaSnapshot()).replace(/[\d.,]+ ms/, 'ms');
  return [JSON.stringify(settings), ...kept.sort(), ...keys, seen].join('\n');
}

/** Forgets what the browser keeps of levels, as a user may at any time. */
const forgetLevels = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const forget = (name: string) =>
      new Promise<void>((resolve, reject) => {
        const request = indexedDB.deleteDatabase(name);
        request.onsuccess = () => resolve();
        request.onerror = () => reject(request.error);
      });
    for (const { name } of await indexedDB.databases()) if (name !== undefined) await forget(name);
  });

/** Waits until the page that has just been opened in a folder with nothing but `BETWEEN` has come to rest. */
export async function keepPage(context: BrowserContext, page: Page, folder: string): Promise<KeptPage> {
  const rest = async () => {
    await page.getByRole('status', { name: 'Verdict: completable' }).waitFor();
    await page
      .getByRole('status', { name: 'Saving' })
      .filter({ hasText: /^saved$/ })
      .waitFor();
    await levels(page).locator('img').waitFor();
    await page
      .getByRole('status', { name: 'Slack' })
      .filter({ hasText: /^slack \d/ })
      .waitFor();
    await page
      .getByRole('contentinfo')
      .getByText(/would differ by/)
      .waitFor();
  };
  await rest();
  const whenNew = await looksOf(page);
  const rid = page.getByRole('list', { name: 'Messages' }).getByRole('button', { name: 'Dismiss' });
  const remove = (which: (name: string) => boolean) => {
    for (const name of readdirSync(folder)) if (which(name)) rmSync(join(folder, name), { recursive: true, force: true });
  };
  const clear = async (): Promise<boolean> => {
    if (page.isClosed()) return false;
    const isCovered = () =>
      page.evaluate(
        () => document.querySelector('[role=dialog], [role=menu], [role=application][aria-label^=Playtest]') !== null,
      );
    for (let i = 0; i < 4 && (await isCovered()); i++) await page.keyboard.press('Escape');
    if (await isCovered()) return false;
    const status = page.getByRole('status', { name: 'Saving' });
    await status.filter({ hasNotText: /saving|unsaved|keeping/ }).waitFor();
    if ((await status.textContent()) !== 'saved') return false;
    // the steps of a level go on if it is opened again and has not changed meanwhile
    const opened = await page.evaluate((key) => sessionStorage.getItem(key), OPENED);
    put(folder, `${opened}.level.json`, levelNamed('Left'));
    await isOpen(page, 'Left');
    for (const [name, content] of Object.entries(BETWEEN)) put(folder, name, content);
    await levels(page).filter({ hasText: 'Between' }).click();
    await isOpen(page, 'Between');
    for (const name of ['Outline', 'Inspector']) {
      const tab = page.getByRole('tab', { name, exact: true });
      if ((await tab.getAttribute('aria-selected')) !== 'true') await tab.click();
    }
    await page.mouse.move(0, 0);
    while ((await rid.count()) > 0) await rid.first().dispatchEvent('click');
    remove((name) => name !== `${ID}.level.json`);
    await isListed(page, 1);
    await forgetLevels(page);
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await rest();
    for (let i = 0; i < MOST; i++) {
      if ((await looksOf(page)) === whenNew) return true;
      await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestIdleCallback(resolve))));
    }
    return false;
  };
  return {
    context,
    page,
    canvas: canvasOf(page),
    folder,
    async show(files) {
      const names = Object.keys(files).filter((name) => name.endsWith('.level.json'));
      for (const [name, content] of Object.entries(files)) put(folder, name, content);
      await isListed(page, names.length + 1);
      await levels(page).filter({ hasNotText: 'Between' }).first().click();
      await page.getByRole('heading', { level: 1 }).filter({ hasNotText: 'Between' }).waitFor();
      remove((name) => name === `${ID}.level.json`);
      await isListed(page, names.length);
      // not in the list, which has keys of its own
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
      await page.mouse.move(0, 0);
    },
    clear: () => inTime(clear()),
  };
}
