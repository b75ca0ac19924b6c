import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { verdict } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

/** The name of the focused element. */
const focused = (page: Page): Promise<string> =>
  page.evaluate(() => {
    const element = document.activeElement;
    return element === null || element === document.body ? 'nothing' : (element.ariaLabel ?? element.textContent).trim();
  });

const hasFocus = (page: Page, name: string) => until(async () => expect(await focused(page)).toBe(name));

const CANVAS = 'Level canvas';

inChromium('focus in Chromium', ({ on }) => {
  it(
    'a level from a search is opened and gets the keyboard: Space plays it',
    on({ '01': straight(), '02': garden() }, async ({ page }) => {
      await verdict(page, 'completable');
      await page.keyboard.press('Control+p');
      const find = page.getByRole('searchbox', { name: 'Find a level' });
      await page.keyboard.type('gard');
      await page.keyboard.press('Enter');
      await page.getByRole('heading', { name: 'Garden', level: 1 }).waitFor();
      expect(await find.inputValue()).toBe('');
      await hasFocus(page, CANVAS);
      await page.keyboard.press('Space');
      await page.getByRole('application', { name: /^Playtest/ }).waitFor();
      await page.keyboard.press('Escape');
      await hasFocus(page, CANVAS);
      // the level that is already open, and leaving the field without text
      await page.keyboard.press('Control+p');
      await page.keyboard.type('gard');
      await page.keyboard.press('Enter');
      await hasFocus(page, CANVAS);
      await page.keyboard.press('Control+p');
      await page.keyboard.type('x');
      await page.keyboard.press('Escape');
      expect(await find.inputValue()).toBe('');
      await page.keyboard.press('Escape');
      await hasFocus(page, CANVAS);
    }),
  );

  it(
    'the focus never falls to the page when its element disappears: dialogs, the palette, a search, rows, messages',
    on({ '01': straight(), '02': garden({ runs: [] }) }, async ({ page }) => {
      await verdict(page, 'completable');
      const palette = page.getByRole('dialog', { name: 'Commands' });
      // no element had the focus before: the canvas gets it afterwards
      await page.keyboard.press('Control+k');
      await page.keyboard.press('Escape');
      await palette.waitFor({ state: 'hidden' });
      await hasFocus(page, CANVAS);

      // the focus returns
      const runs = page.getByRole('tab', { name: 'Runs' });
      await runs.focus();
      await page.keyboard.press('Enter');
      await page.keyboard.press('Control+k');
      await page.keyboard.type('light and dark');
      await page.keyboard.press('Enter');
      await palette.waitFor({ state: 'hidden' });
      await hasFocus(page, 'Runs');
      for (const [key, dialog] of [
        ['?', 'Shortcuts and gestures'],
        ['Control+Comma', 'Settings'],
        ['Alt+n', 'New level'],
      ]) {
        await page.keyboard.press(key);
        await page.getByRole('dialog', { name: dialog }).waitFor();
        await page.keyboard.press('Escape');
        await page.getByRole('dialog', { name: dialog }).waitFor({ state: 'hidden' });
        await hasFocus(page, 'Runs');
      }
      // if a command of the palette sets the focus, it stays there
      await page.keyboard.press('Control+k');
      await page.keyboard.type('find a level');
      await page.keyboard.press('Enter');
      await palette.waitFor({ state: 'hidden' });
      await hasFocus(page, 'Find a level');

      // a new level has its own canvas
      await page.getByRole('application', { name: CANVAS }).focus();
      await page.keyboard.press('Alt+n');
      await page.getByRole('textbox', { name: 'Level name' }).fill('Fresh');
      await page.keyboard.press('Enter');
      await page.getByRole('heading', { name: 'Fresh', level: 1 }).waitFor();
      await hasFocus(page, CANVAS);

      // the field that the solver's panel replaces
      await page.getByRole('textbox', { name: 'range' }).focus();
      await page.keyboard.press('Control+Enter');
      const [cancel, discard] = ['Cancel', 'Discard'].map((name) => page.getByRole('button', { name }));
      await cancel.or(discard).first().waitFor();
      await until(async () => expect(await focused(page)).not.toBe('nothing'));

      // the last run of a level, and the list with it
      const list = page.getByRole('tree', { name: 'Runs of the level' });
      await page.getByRole('button', { name: 'New empty run' }).click();
      await list.focus();
      while (await list.isVisible()) await page.keyboard.press('Delete');
      await until(async () => expect(await focused(page)).not.toBe('nothing'));

      // undo until nothing is left
      const undo = page.getByRole('button', { name: /^Undo/ });
      await undo.focus();
      while (await undo.isVisible()) await page.keyboard.press('Enter');
      await until(async () => expect(await focused(page)).not.toBe('nothing'));

      // a dismissed message
      await page.keyboard.press('u');
      const dismiss = page.getByRole('button', { name: 'Dismiss' }).first();
      await dismiss.focus();
      await page.keyboard.press('Enter');
      await until(async () => expect(await focused(page)).not.toBe('nothing'));
    }),
  );
});
