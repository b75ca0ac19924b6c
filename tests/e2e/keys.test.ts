import type { Locator, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { appearanceOf, PLACEABLES } from '../../schema/index.ts';
import { verdict } from './commands.ts';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const tab = (page: Page, name: string): Locator => page.getByRole('tab', { name });
const isChosen = async (page: Page, name: string) => (await tab(page, name).getAttribute('aria-selected')) === 'true';

inChromium('keys in Chromium', ({ on }) => {
  it(
    'each letter selects one tool or does one thing, including the letters of the kinds',
    on({ '01': straight() }, async ({ page }) => {
      await verdict(page, 'completable');
      await page.keyboard.press('?');
      const sheet = page.getByRole('dialog', { name: 'Shortcuts and gestures' });
      await sheet.waitFor();
      const keys = (await sheet.locator('kbd').allTextContents()).map((key) => key.toLowerCase());
      const letters = keys.filter((key) => /^[a-z]$/.test(key));
      expect(letters.filter((letter, i) => letters.indexOf(letter) !== i)).toEqual([]);
      expect(letters).toEqual(expect.arrayContaining(PLACEABLES.map((placeable) => appearanceOf(placeable).letter)));
      // tools and commands
      expect(letters.length).toBeGreaterThan(PLACEABLES.length + 5);
    }),
  );

  it(
    'keys with Ctrl or Alt do the same whatever has the focus, except text editing',
    on({ '01': straight(), '02': straight({ name: 'Second' }) }, async ({ page, file }) => {
      await verdict(page, 'completable');
      const places: Readonly<Record<string, Locator>> = {
        'a tab on the right': tab(page, 'Inspector'),
        'a tab on the left': tab(page, 'Outline'),
        'one of a few choices': page.getByRole('radio', { name: 'off' }),
        'a button': page.getByRole('button', { name: 'Settings' }),
        'the list of levels': page.getByRole('tree', { name: 'Levels' }),
        'the outline': page.getByRole('tree', { name: 'Objects of the level' }),
        'a number': page.getByRole('textbox', { name: 'range' }),
        'a text': page.getByRole('textbox', { name: 'name', exact: true }),
        'the choice of a run': page.getByRole('combobox', { name: 'Run' }),
        'the time': page.getByRole('slider', { name: 'Time' }),
        'an end of a hold': page.getByRole('slider', { name: 'Release of hold 1' }),
      };
      const find = page.getByRole('searchbox', { name: 'Find a level' });
      const isFinding = () => find.evaluate((field) => field === document.activeElement);
      for (const [place, locator] of Object.entries(places)) {
        await locator.focus();
        await page.keyboard.press('Control+p');
        await until(async () => expect([place, await isFinding()]).toEqual([place, true]));
      }
      // Enter alone does something there; one of each sort, since each begins a search
      for (const place of ['a tab on the left', 'a button', 'the outline', 'a number', 'an end of a hold']) {
        await places[place].focus();
        await page.keyboard.press('Control+Enter');
        await until(async () => expect([place, await isChosen(page, 'Solver')]).toEqual([place, true]));
        await tab(page, 'Inspector').click();
      }

      // undo works in a select element, which has no undo of its own
      await places['an end of a hold'].focus();
      await page.keyboard.press('ArrowLeft');
      await until(() => expect(file('01').runs?.[0].holds).toEqual([[0, 599]]));
      await places['the choice of a run'].focus();
      await page.keyboard.press('Control+z');
      await until(() => expect(file('01').runs?.[0].holds).toEqual([[0, 600]]));

      // the next level can be opened from the search field
      await places['a number'].focus();
      await page.keyboard.press('Control+p');
      await until(async () => expect(await isFinding()).toBe(true));
      await page.keyboard.press('Alt+PageDown');
      await page.getByRole('heading', { name: 'Second', level: 1 }).waitFor();

      // a dialog over the page receives all other keys
      await page.getByRole('button', { name: 'Settings' }).click();
      await page.getByRole('dialog', { name: 'Settings' }).waitFor();
      await page.keyboard.press('Alt+PageUp');
      await page.keyboard.press('Control+Enter');
      await page.keyboard.press('Escape');
      await page.getByRole('dialog', { name: 'Settings' }).waitFor({ state: 'hidden' });
      await page.getByRole('heading', { name: 'Second', level: 1 }).waitFor();
      expect(await isChosen(page, 'Inspector')).toBe(true);
    }),
  );
});
