import type { Locator, Page } from 'playwright-core';

/** Runs a command by its name in the palette. */
export async function command(page: Page, title: string): Promise<void> {
  await page.keyboard.press('Control+k');
  const palette = page.getByRole('dialog', { name: 'Commands' });
  await palette.getByRole('combobox').fill(title);
  await palette.getByRole('option', { name: title }).first().click();
  await palette.waitFor({ state: 'hidden' });
}

export const tool = (page: Page, name: string): Locator =>
  page.getByRole('toolbar', { name: 'Tools' }).getByRole('button', { name, exact: true });

/** Waits until the badge shows this verdict. */
export const verdict = (page: Page, text: 'completable' | 'broken' | 'unproven' | 'impossible'): Promise<void> =>
  page.getByRole('status', { name: `Verdict: ${text}` }).waitFor();
