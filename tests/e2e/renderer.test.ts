import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { command } from './commands.ts';
import { nextFrames } from './frames.ts';
import { straight } from './levels.ts';
import { compare } from './pictures.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const drawnBy = (page: Page): Promise<'webgl' | 'canvas'> =>
  page.evaluate(() => (document.querySelector<HTMLCanvasElement>('.canvas canvas')?.getContext('2d') ? 'canvas' : 'webgl'));

inChromium('the renderer in Chromium', ({ on }) => {
  it(
    'is a setting for the next page; the address takes precedence; the only canvas survives a page without levels',
    on(
      { '01': straight() },
      async ({ page, canvas, file, saved }) => {
        await saved();
        await page.getByText('Expected the renderer webgl or canvas in the address of this page, found “gpu”').waitFor();
        expect(await drawnBy(page)).toBe('canvas');

        const look = async () => {
          await canvas.fit(file('01'));
          await page.mouse.move(2, 2);
          await nextFrames(page);
          return page.getByRole('application', { name: 'Level canvas' }).screenshot();
        };
        const before = await look();
        const first = await page.locator('.canvas canvas').elementHandle();
        await command(page, 'Delete this level');
        await page.getByText('No levels here yet.').waitFor();
        await page.getByRole('button', { name: 'Undo', exact: true }).click();
        await saved();
        expect(await page.evaluate((one) => one === document.querySelector('.canvas canvas'), first)).toBe(true);
        await until(async () => expect((await compare(page, before, await look())).share).toBeLessThan(0.001));

        // a change is kept even if the page is reloaded at once
        await command(page, 'Select all');
        await page.keyboard.press('ArrowDown');
        await command(page, 'Settings');
        const dialog = page.getByRole('dialog', { name: 'Settings' });
        expect(await dialog.getByText('Takes effect after a reload').count()).toBe(0);
        await dialog.getByRole('combobox', { name: 'Renderer' }).selectOption('WebGL');
        await dialog.getByText('Takes effect after a reload.').waitFor();
        expect(await drawnBy(page)).toBe('canvas');
        await dialog.getByRole('button', { name: 'Reload' }).click();
        await dialog.waitFor({ state: 'hidden' });
        await saved();
        await until(async () => expect(await drawnBy(page)).toBe('webgl'));
        expect(file('01').astronaut.y).toBe(305);

        const address = new URL(page.url());
        address.search = 'renderer=canvas';
        await page.goto(address.href);
        await saved();
        expect(await drawnBy(page)).toBe('canvas');
        await command(page, 'Settings');
        await dialog.getByText('The address of this page sets the renderer to Canvas, which overrides this setting.').waitFor();
        expect(await dialog.getByRole('combobox', { name: 'Renderer' }).inputValue()).toBe('webgl');
      },
      { context: { reducedMotion: 'reduce', viewport: { width: 900, height: 700 } }, query: 'renderer=gpu' },
    ),
  );
});
