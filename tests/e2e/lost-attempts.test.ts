import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { verdict } from './commands.ts';
import { hurry } from './frames.ts';
import { near } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const firewalk = () => readFileSync(join(import.meta.dirname, '..', '..', 'levels', '16-firewalk.level.json'), 'utf8');

const playtest = (page: Page) => page.getByRole('application', { name: /^Playtest/ });
const theEnd = (page: Page) => playtest(page).getByRole('status');

inChromium('attempts that do not complete the level, in Chromium', ({ on }) => {
  it(
    'become the last run, by key or button, even if they were left before their end',
    on({ '16': firewalk() }, async ({ page, file }) => {
      await verdict(page, 'completable');
      const names = () => file('16').runs?.map(({ name }) => name);
      await hurry(page, 8);
      await page.getByRole('button', { name: 'Play', exact: true }).click();
      // without a press she drifts into a nova
      await theEnd(page).getByText('Not completed').waitFor();
      await playtest(page).getByRole('button', { name: 'Keep as a run' }).waitFor();
      await page.getByRole('button', { name: 'Search all commands' }).click();
      const palette = page.getByRole('dialog', { name: 'Commands' });
      await palette.getByRole('option', { name: 'Keep this attempt as a run' }).waitFor();
      await page.keyboard.press('Escape');
      await palette.waitFor({ state: 'hidden' });
      await playtest(page).focus();
      await page.keyboard.press('Enter');
      await playtest(page).waitFor({ state: 'hidden' });
      await until(() => expect(names()).toEqual(['solution', 'all-minerals', 'attempt 1']));
      await page.getByText('Attempt 1 is kept as the last run, “attempt 1”.').waitFor();
      await verdict(page, 'completable');
      await page.getByRole('combobox', { name: 'Run' }).selectOption('solution');

      // an attempt that is left before its end, at a slow pace
      await hurry(page, 1);
      await page.getByRole('button', { name: '¼×' }).click();
      await page.getByRole('button', { name: 'Play', exact: true }).click();
      await page.keyboard.down('x');
      await until(async () => expect(await playtest(page).textContent()).toMatch(/^0\.[1-9]|^[1-9]/));
      await page.keyboard.press('Escape');
      await playtest(page).waitFor({ state: 'hidden' });
      await page.keyboard.up('x');
      await page.getByRole('tab', { name: 'Runs' }).click();
      const attempts = page.getByRole('region', { name: 'Attempts' });
      await attempts.getByText(/^left at \d+\.\d\d s/).waitFor();
      await attempts.getByRole('button', { name: 'Keep attempt 2 as a run' }).click();
      await until(() => expect(names()).toEqual(['solution', 'all-minerals', 'attempt 1', 'attempt 2']));
      expect(file('16').runs?.[3].holds[0]).toEqual([expect.any(Number), expect.any(Number)]);
      await verdict(page, 'completable');
    }),
  );

  it(
    'an attempt that completed the level before a change becomes the last run as well',
    on({ '01': near() }, async ({ page, canvas, file }) => {
      await verdict(page, 'completable');
      await canvas.fit(file('01'));
      await hurry(page, 8);
      await page.getByRole('button', { name: 'Play', exact: true }).click();
      await theEnd(page).getByText('Level completed').waitFor();
      await playtest(page).getByRole('button', { name: 'Keep as a run' }).waitFor();
      await page.keyboard.press('Escape');
      await playtest(page).waitFor({ state: 'hidden' });
      await canvas.drag({ x: 400, y: 304 }, { to: [{ x: 200, y: 504 }] });
      await verdict(page, 'impossible');
      await page.getByRole('tab', { name: 'Runs' }).click();
      await page.getByRole('button', { name: 'Keep attempt 1 as a run' }).click();
      await page.getByText('Attempt 1 does not complete the level as it is now').waitFor();
      await until(() => expect(file('01').runs?.map(({ name }) => name)).toEqual(['solution', 'attempt 1']));
      await verdict(page, 'impossible');
    }),
  );

  it(
    'are still there when another level has been opened in the meantime, in the list and on the canvas',
    on({ '01': near({ name: 'First' }), '02': near({ name: 'Second' }) }, async ({ page, saved }) => {
      await saved();
      const open = (name: string) =>
        page.getByRole('tree', { name: 'Levels' }).getByRole('treeitem').filter({ hasText: name }).click();
      const attempts = page.getByRole('region', { name: 'Attempts and plays' });
      await hurry(page, 8);
      await page.getByRole('button', { name: 'Play', exact: true }).click();
      await theEnd(page).getByText('Level completed').waitFor();
      await page.keyboard.press('Escape');
      await playtest(page).waitFor({ state: 'hidden' });
      await page.getByRole('tab', { name: 'Attempts' }).click();
      await attempts.getByRole('treeitem').waitFor();
      await open('Second');
      await attempts.getByText('Nobody has played this level here yet.').waitFor();
      await open('First');
      await attempts
        .getByRole('treeitem')
        .getByText(/She reaches the black hole/)
        .waitFor();
      await attempts.getByRole('treeitem').click();
      await page.keyboard.press('Enter');
      await page.getByRole('application', { name: /^Replay of/ }).waitFor();
    }),
  );
});
