import type { CDPSession, Page } from 'playwright-core';
import { NO_TOUR } from '../harness/index.ts';
import type { KillableBrowser } from './browser.ts';

/** Time after which something expected does not come any more, ms. */
const TOO_LONG = 40_000;

const saving = (page: Page) => page.getByRole('status', { name: 'Saving' });
const says = (page: Page, text: RegExp) => saving(page).filter({ hasText: text });

/** Opens the editor and waits until it shows the level. */
export async function openPage(browser: KillableBrowser, address: string): Promise<Page> {
  const page = await browser.context.newPage();
  page.setDefaultTimeout(TOO_LONG);
  await page.addInitScript(NO_TOUR);
  await page.goto(address);
  const canvas = page.getByRole('application', { name: 'Level canvas' });
  // the page before was killed while it opened the level
  const anyway = page.getByRole('button', { name: 'Open anyway' });
  await canvas.or(anyway).first().waitFor();
  if (await anyway.isVisible()) await anyway.click();
  await canvas.waitFor();
  return page;
}

/** What the page says about where the work is: `saved`, `read-only`, ... */
export const savingState = async (page: Page): Promise<string> => (await saving(page).textContent())?.trim() ?? '';

export const looksOn = (page: Page): Promise<void> => says(page, /^read-only$/).waitFor();

/**
 * Waits until the work is saved.
 * @throws {Error} if it is not saved in time, with what the page says instead
 */
export async function becomesSaved(page: Page): Promise<void> {
  try {
    await says(page, /^saved$/).waitFor();
  } catch {
    const notices = await page.getByRole('list', { name: 'Messages' }).textContent();
    throw new Error(`is not saved in ${TOO_LONG / 1000} s but "${await savingState(page)}"; notices: ${notices}`);
  }
}

/** Makes this tab the one that writes, once it says that another one is. */
export async function takeOver(page: Page): Promise<void> {
  await page.bringToFront();
  await page.getByRole('button', { name: 'Take over' }).click();
}

/** Selects everything, so that keys move it. */
export async function selectAll(page: Page): Promise<void> {
  await page.bringToFront();
  await page.getByRole('application', { name: 'Level canvas' }).focus();
  await page.keyboard.press('Control+a');
}

/** Ends the page's process as a crash does. */
export async function crash(page: Page): Promise<void> {
  const session: CDPSession = await page.context().newCDPSession(page);
  const crashed = page.waitForEvent('crash');
  // a crashed page does not answer
  session.send('Page.crash').catch(() => undefined);
  await crashed;
}
