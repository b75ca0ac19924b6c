import { expect, it } from 'vitest';
import { heatColour } from '../../picture/index.ts';
import { command } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

/** A mineral that nobody can reach. */
const ASIDE = [{ id: 'gem', x: 660, y: 520, radius: 7 }];

inChromium('messages of the solver in Chromium', ({ on }) => {
  it(
    'mentions the request and the results of the own runs, and minerals only if they were requested',
    on({ '01': straight({ minerals: ASIDE }) }, async ({ page, saved }) => {
      await saved();
      await page.getByRole('tab', { name: 'Solver' }).click();
      const solver = page.getByRole('tabpanel', { name: 'Solver' });
      const report = solver.locator('.report').first();
      const solve = async (minerals: string) => {
        await solver.getByRole('group', { name: 'Minerals' }).getByRole('radio', { name: minerals, exact: true }).click();
        await command(page, 'Solve: find runs');
      };
      await solve('any');
      await report
        .getByRole('status')
        .filter({ hasText: /different runs? found/ })
        .waitFor();
      expect(await report.textContent()).not.toMatch(/asked for|No run found|with the mineral/);
      await solver.getByText(/^Looked for up to 5 runs\./).waitFor();

      // the mineral is out of reach, but the level is still completable
      await solve('all 1');
      await report
        .getByRole('alert')
        .getByText(
          'Proved: no run completes the level with the mineral. The level is completable all the same: its run “solution” reaches the black hole.',
        )
        .waitFor();
    }),
  );

  it(
    'the visited places of a search are drawn as in pictures, with a legend of numbers, in both themes',
    on({ '01': garden({ runs: undefined }) }, async ({ page, saved }) => {
      await saved();
      await page.getByRole('tab', { name: 'Solver' }).click();
      const solver = page.getByRole('tabpanel', { name: 'Solver' });
      const legend = page.getByRole('figure', { name: 'Search heat map' });
      await solver.getByRole('textbox', { name: 'Seconds' }).fill('3600');
      await solver.getByRole('button', { name: 'Solve', exact: true }).click();
      await solver.getByLabel('Show the search heat map').check();
      await legend.getByText('visits of the search to each square of 32 px').waitFor();
      // every intensity has its numbers
      await until(async () => expect(await legend.getByRole('listitem').count()).toBeGreaterThan(3));
      const labels = await legend.getByRole('listitem').allInnerTexts();
      for (const label of labels) expect(label).toMatch(/^\d[\d.kM]*(–\d[\d.kM]*)?$/);
      const colour = () =>
        legend
          .getByRole('listitem')
          .last()
          .locator('span span')
          .evaluate((square) => getComputedStyle(square).backgroundColor);
      const rgb = (hex: string) => `rgb(${[1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16)).join(', ')})`;
      const shown = await page.evaluate(() => document.documentElement.dataset.theme);
      const first = shown === 'light' ? 'light' : 'dark';
      expect(await colour()).toBe(rgb(heatColour(first)));
      await page.emulateMedia({ colorScheme: first === 'light' ? 'dark' : 'light' });
      await until(async () => expect(await colour()).toBe(rgb(heatColour(first === 'light' ? 'dark' : 'light'))));
      await solver.getByLabel('Show the search heat map').uncheck();
      await legend.waitFor({ state: 'hidden' });
    }),
  );
});
