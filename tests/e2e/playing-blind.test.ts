import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { verdict } from './commands.ts';
import { straight } from './levels.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const playtest = (page: Page) => page.getByRole('application', { name: /^Playtest/ });

inChromium('playing without a shown run, in Chromium', ({ on }) => {
  it(
    'hides the run, on the canvas and the timeline, until a button or key shows it',
    on(
      { '01': straight({ minerals: [] }) },
      async ({ page, canvas, file }) => {
        await verdict(page, 'completable');
        await canvas.fit(file('01'));
        const green = () => countColour(page, canvas.at({ x: 560, y: 304 }), 20, COLOURS.dark.way);
        const lane = page.getByRole('application', { name: /^Gun of the run/ });
        await until(async () => expect(await green()).toBeGreaterThan(20));
        await page.keyboard.press('Space');
        await playtest(page).waitFor();
        await until(async () => expect(await green()).toBe(0));
        await lane.waitFor({ state: 'hidden' });
        const toggle = playtest(page).getByRole('button', { name: "Show the run's path", pressed: false });
        await toggle.click();
        await playtest(page).getByRole('button', { name: "Show the run's path", pressed: true }).waitFor();
        await until(async () => expect(await green()).toBeGreaterThan(20));
        await lane.waitFor();
        await page.keyboard.press('w');
        await until(async () => expect(await green()).toBe(0));
        await page.keyboard.press('Escape');
        await until(async () => expect(await green()).toBeGreaterThan(20));
        await lane.waitFor();
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );

  it(
    'mentions fingers on a phone, where it can be restarted and left',
    on(
      { '01': straight() },
      async ({ page }) => {
        await page.getByRole('button', { name: 'Play', exact: true }).tap();
        await playtest(page).getByText('hold a finger on the screen').waitFor();
        expect(await playtest(page).textContent()).not.toMatch(/mouse|Space|Esc|\bR\b/);
        for (const name of ["Show the run's path", 'Play again', 'Back to editing']) {
          const box = await playtest(page).getByRole('button', { name }).boundingBox();
          expect([name, (box?.width ?? 0) >= 44, (box?.height ?? 0) >= 44]).toEqual([name, true, true]);
        }
        await playtest(page).getByRole('button', { name: 'Back to editing' }).tap();
        await playtest(page).waitFor({ state: 'hidden' });
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );
});
