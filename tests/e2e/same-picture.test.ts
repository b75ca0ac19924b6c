import process from 'node:process';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { propertySettings } from '../property-settings.ts';
import { nextFrames } from './frames.ts';
import { garden, straight } from './levels.ts';
import { compare } from './pictures.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

/** Small levels, as the processor renders WebGL here. */
const SIZES = [
  { width: 360, height: 400 },
  { width: 400, height: 360 },
  { width: 840, height: 480 },
] as const;

const NAMES = ['Garden', 'Straight', 'Third'] as const;
const LEVELS = { '01': garden(), '02': straight(), '03': garden({ name: 'Third', range: 300 }) };

const openLevel = (page: Page) => page.locator('.topbar__level');

async function step(page: Page, key: 'Alt+PageDown' | 'Alt+PageUp', name: string): Promise<void> {
  await page.keyboard.press(key);
  await openLevel(page).filter({ hasText: name }).waitFor();
}

/** A picture of the canvas. */
async function look(page: Page): Promise<Buffer> {
  const canvas = page.getByRole('application', { name: 'Level canvas' });
  await canvas.focus();
  await page.keyboard.press('f');
  await page.mouse.move(2, 2);
  await nextFrames(page);
  return canvas.screenshot();
}

async function show(page: Page, colorScheme: 'dark' | 'light'): Promise<void> {
  await page.emulateMedia({ colorScheme });
  await page.locator(`html[data-theme=${colorScheme}]`).waitFor({ state: 'attached' });
}

const lookInBothThemes = async (page: Page): Promise<{ dark: Buffer; light: Buffer }> => {
  const dark = await look(page);
  await show(page, 'light');
  const light = await look(page);
  await show(page, 'dark');
  return { dark, light };
};

/** The number of canvases on which the level was ever drawn, including the current one. */
const countCanvases = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const seen = globalThis as { canvases?: Set<Element | null> };
    seen.canvases ??= new Set();
    return seen.canvases.add(document.querySelector('.canvas canvas')).size;
  });

/** `PROPERTY_RUNS=3` opens eighteen levels. */
const OPENED = 6 * Math.ceil(propertySettings(process.env).runs);

/**
 * Opens levels one after the other, two forward and two back, and changes the theme and the size and plays in between.
 * At the end, theme and size are the same as before.
 */
async function useFor(page: Page): Promise<void> {
  for (let i = 0; i < OPENED; i++) {
    const at = i % 4;
    if (at < 2) await step(page, 'Alt+PageDown', NAMES[at + 1]);
    else await step(page, 'Alt+PageUp', NAMES[3 - at]);
    await countCanvases(page);
    if (i % 3 === 1) await show(page, i % 2 === 1 ? 'light' : 'dark');
    if (i % 3 === 2) await page.setViewportSize(SIZES[((i + 1) / 3) % 3]);
    if (i % 5 !== 4) continue;
    await page.keyboard.press('Space');
    await page.getByRole('application', { name: /^Playtest/ }).waitFor();
    await nextFrames(page);
    await page.keyboard.press('Escape');
    await page.getByRole('application', { name: /^Playtest/ }).waitFor({ state: 'hidden' });
  }
  await show(page, 'dark');
  await page.setViewportSize(SIZES[0]);
}

inChromium('the canvas in Chromium', ({ on }) => {
  for (const renderer of ['canvas', 'webgl'] as const) {
    it(
      `looks as on a fresh page after many levels, themes, sizes and plays, on a single canvas, drawn by ${renderer}`,
      on(
        LEVELS,
        async ({ page }) => {
          const kinds = () =>
            page.evaluate(() => document.querySelector<HTMLCanvasElement>('.canvas canvas')?.getContext('2d') === null);
          await openLevel(page).filter({ hasText: NAMES[0] }).waitFor();
          expect(await kinds()).toBe(renderer === 'webgl');
          const fresh = await lookInBothThemes(page);
          await useFor(page);
          // back to the first level
          await until(async () => {
            await page.keyboard.press('Alt+PageUp');
            expect(await openLevel(page).textContent()).toContain(NAMES[0]);
          });
          const used = await lookInBothThemes(page);
          for (const theme of ['dark', 'light'] as const) {
            const { share, mean } = await compare(page, fresh[theme], used[theme]);
            expect(share, `share of px that differ on ${theme}`).toBeLessThan(0.001);
            expect(mean, `mean difference on ${theme}`).toBeLessThan(0.2);
          }
          // the two themes differ, which shows that the comparison works
          expect((await compare(page, used.dark, used.light)).share).toBeGreaterThan(0.5);
          expect(await countCanvases(page)).toBe(1);
        },
        {
          context: { reducedMotion: 'reduce', colorScheme: 'dark', viewport: SIZES[0] },
          query: `renderer=${renderer}`,
        },
      ),
    );
  }
});
