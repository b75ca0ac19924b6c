import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { firstFiles } from '../editor/first-files.ts';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const focused = (page: Page): Promise<string | null> =>
  page.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? null);

inChromium('parts of the page that are loaded later, in Chromium', ({ on }) => {
  it(
    'a panel and a dialog that are opened before their scripts say so in their place, and Esc takes the dialog back',
    on({ '01': straight() }, async ({ page, saved }) => {
      const first = firstFiles();
      let release = () => {};
      const released = new Promise<void>((resolve) => {
        release = resolve;
      });
      await page.route('**/assets/*', async (route) => {
        const path = new URL(route.request().url()).pathname.slice(1);
        if (!first.has(path) && !path.startsWith('assets/worker-')) await released;
        await route.continue();
      });
      await page.reload();
      await saved();
      await page.getByRole('tab', { name: 'Solver' }).click();
      const panel = page.getByRole('tabpanel', { name: 'Solver' });
      const coming = panel.getByText('Loading…');
      await coming.waitFor();
      const [of, whole] = await Promise.all([coming.boundingBox(), panel.boundingBox()]);
      expect(of?.height).toBeGreaterThan(0.9 * (whole?.height ?? 0));

      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('y');
      const cover = page.locator('.coming--cover');
      await cover.waitFor();
      await page.keyboard.press('Escape');
      await cover.waitFor({ state: 'hidden' });
      await page.keyboard.press('y');
      await cover.waitFor();
      release();
      await page.getByRole('dialog', { name: 'History', exact: true }).getByRole('tree').waitFor();
      await page.keyboard.press('Escape');
      await panel.getByRole('heading', { name: 'Find runs' }).waitFor();
    }),
  );

  it(
    'the level is shown and saved without them; one that can not be loaded says so, leaves the keyboard alone, and comes at the next attempt',
    on(
      { '01': straight() },
      async ({ page, canvas, file, saved }) => {
        const first = firstFiles();
        let isCut = true;
        await page.route('**/assets/*', (route) => {
          const path = new URL(route.request().url()).pathname.slice(1);
          return isCut && !first.has(path) && !path.startsWith('assets/worker-') ? route.abort() : route.continue();
        });
        await page.reload();
        await saved();
        await canvas.fit(file('01'));
        const level = page.getByRole('application', { name: 'Level canvas' });
        await level.focus();
        await page.keyboard.press('Control+a');
        await page.keyboard.press('ArrowDown');
        await until(() => expect(file('01').astronaut).toMatchObject({ y: 305 }));

        // what covers the page
        await page.keyboard.press('y');
        const failed = page.getByRole('dialog', { name: 'Not loaded' });
        await failed.getByText('This part of the page could not be loaded').waitFor();
        await failed.getByText('Start gq edit again').waitFor();
        await page.keyboard.press('Escape');
        await failed.waitFor({ state: 'hidden' });
        await until(async () => expect(await focused(page)).toBe('Level canvas'));
        await page.keyboard.press('ArrowDown');
        await until(() => expect(file('01').astronaut).toMatchObject({ y: 306 }));
        await page.keyboard.press('y');
        await failed.waitFor();

        // a panel
        await page.keyboard.press('Escape');
        await page.getByRole('tab', { name: 'Solver' }).click();
        const panel = page.getByRole('tabpanel', { name: 'Solver' });
        await panel.getByRole('alert').getByText('This part of the page could not be loaded').waitFor();

        isCut = false;
        await panel.getByRole('button', { name: 'Try again' }).click();
        await panel.getByRole('heading', { name: 'Find runs' }).waitFor();
        await level.focus();
        await page.keyboard.press('y');
        await page.getByRole('dialog', { name: 'History', exact: true }).getByRole('tree').waitFor();
      },
      { complaints: /ERR_FAILED/ },
    ),
  );
});
