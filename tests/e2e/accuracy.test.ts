import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { complaintsAbout } from './axe.ts';
import { command } from './commands.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const VAULT: unknown = JSON.parse(readFileSync(join(import.meta.dirname, '..', '..', 'levels', '22-vault.level.json'), 'utf8'));
/** It is completed in frames only. */
const MISS = {
  version: 1,
  name: 'Miss',
  astronaut: { x: 500, y: 760, vx: 0, vy: -60 },
  blackHole: { x: 830, y: 510 },
  asteroids: [{ id: 'aa', x: 600, y: 620, radius: 32 }],
  runs: [{ name: 'in frames only', holds: [[120, 435]] }],
};

const points = (page: Page): Locator => page.getByRole('listbox', { name: 'Points of the diagram' });
const chosen = (page: Page): Locator => points(page).getByRole('option', { selected: true });
const words = (page: Page): Locator => page.locator('.diagram__words');

async function measure(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Measure', exact: true }).click();
  await page.getByRole('button', { name: 'Measure again' }).waitFor();
  await points(page).waitFor();
}

inChromium('the work-precision diagram in Chromium', ({ on }) => {
  it(
    'names each point by pointer and keys: what it is, how exact, what it costs, how the run ends',
    on({ '01': MISS }, async ({ page }) => {
      await command(page, 'Show accuracy');
      await measure(page);
      expect(await points(page).getByRole('option').count()).toBe(59);
      // the keyboard begins at the setting in use
      await points(page).focus();
      await until(async () =>
        expect(await words(page).textContent()).toMatch(/^taylor to 1e-9 px, swept contacts \(precise\): /),
      );
      expect(await words(page).textContent()).toMatch(
        /off by (< )?[\d.e-]+ px, known to [\d.e-]+ px; [\d.e-]+ µs a second of play, [\d.e-]+ % of a frame at 60 Hz, [\d,]+ runs a second; is lost at 11\.35 s/,
      );
      // to the right are larger errors, and beyond them runs that end otherwise
      await page.keyboard.press('End');
      await until(async () => expect(await words(page).textContent()).toMatch(/; another outcome: reaches the black hole/));
      await page.keyboard.press('ArrowLeft');
      await page.keyboard.press('Home');
      expect(await words(page).textContent()).not.toContain('another outcome');
      // along the cost: the dearest is at the top
      for (let i = 0; i < 60; i++) await page.keyboard.press('ArrowUp');
      expect(await words(page).textContent()).toMatch(/ at 960 Hz, /);
      expect(await chosen(page).getAttribute('aria-label')).toBe(await words(page).textContent());

      const arcade = points(page).getByRole('option', { name: /^arcade: / });
      const [mark, box] = [await arcade.boundingBox(), await points(page).boundingBox()];
      await page.mouse.move((mark?.x ?? 0) + 3, (mark?.y ?? 0) - 4);
      await until(async () =>
        expect(await words(page).textContent()).toMatch(/^arcade: euler at 60 Hz, contacts once a frame: off by /),
      );
      expect((mark?.x ?? 0) > (box?.x ?? 0) + 0.7 * (box?.width ?? 0)).toBe(true);
      expect(await page.getByRole('img', { name: /^Work-precision diagram: 59 points, [1-9]\d* of them/ }).count()).toBe(1);
    }),
  );

  it(
    'has all runs in a point, or a point for each; in the panel, large and on a phone, accessible in both themes',
    on({ '01': VAULT }, async ({ page }) => {
      const complaints: string[] = [];
      await command(page, 'Show accuracy');
      await measure(page);
      await points(page).focus();
      await until(async () =>
        expect(await words(page).textContent()).toMatch(/ in the median of 2 runs, .* times all runs a second; /),
      );
      await page.getByRole('checkbox', { name: 'one point a run' }).check();
      await until(async () => expect(await points(page).getByRole('option').count()).toBe(118));
      expect(
        await points(page)
          .getByRole('option', { name: /^solution: taylor to 1e-9 px/ })
          .count(),
      ).toBe(2);
      for (const theme of ['dark', 'light']) {
        await page.evaluate((name) => document.documentElement.setAttribute('data-theme', name), theme);
        complaints.push(...(await complaintsAbout(page, `panel, ${theme}`, '.diagram')));
      }
      await page.getByRole('checkbox', { name: 'one point a run' }).uncheck();
      await page.getByRole('button', { name: 'Enlarge' }).click();
      const dialog = page.getByRole('dialog', { name: 'What accuracy costs' });
      await dialog.getByRole('listbox', { name: 'Points of the diagram' }).focus();
      await dialog.getByText(/^taylor to 1e-9 px/).waitFor();
      complaints.push(...(await complaintsAbout(page, 'dialog', '[role=dialog]')));
      await page.keyboard.press('Escape');
      await dialog.waitFor({ state: 'hidden' });

      await page.setViewportSize({ width: 390, height: 844 });
      await measure(page);
      await until(async () => {
        const { x, width } = (await points(page).boundingBox()) ?? { x: 0, width: 0 };
        expect([x >= 0, x + width <= 390, width > 330]).toEqual([true, true, true]);
      });
      complaints.push(...(await complaintsAbout(page, 'phone', '.accuracies')));
      expect(complaints).toEqual([]);
    }),
  );
});
