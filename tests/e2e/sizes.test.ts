import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { verdict } from './commands.ts';
import { controlsOf } from './controls.ts';
import { straight } from './levels.ts';
import { inChromium, type Stage } from './stage.ts';
import { until } from './until.ts';

/** The smallest size of the canvas on any page: px, and a share of the page's height. */
const LEAST = { width: 320, height: 220, share: 0.45 };

/** px; on wider pages, all panels are around the canvas */
const WIDE = { width: 880, height: 520 };

/** px; the distance from her to the black hole in the level */
const ACROSS = 504;

const PANELS = ['Timeline', 'Levels', 'Outline', 'Runs', 'Inspector', 'Solver', 'Effects', 'Accuracy', 'Problems'];

/** Checks that the canvas is large enough, and nothing extends beyond the page. @returns the size of the canvas */
async function lookAtCanvas(page: Page, where: string): Promise<string> {
  const size = page.viewportSize() as { width: number; height: number };
  return until(async () => {
    const [width, height, ...scrolled] = await page.evaluate(() => {
      const box = document.querySelector('[aria-label="Level canvas"]')?.getBoundingClientRect();
      const { scrollWidth, scrollHeight } = document.documentElement;
      return [box?.width ?? 0, box?.height ?? 0, scrollWidth, scrollHeight];
    });
    expect(width, where).toBeGreaterThanOrEqual(LEAST.width);
    expect(height, where).toBeGreaterThanOrEqual(Math.max(LEAST.height, LEAST.share * size.height) - 1);
    expect(scrolled, where).toEqual([size.width, size.height]);
    return `${width} x ${height}`;
  });
}

/** Checks that the whole level fills most of the canvas. */
async function lookAtLevel(page: Page, where: string): Promise<void> {
  const shown = page.locator('.statusbar').getByText(/^\d+ %$/);
  await until(async () => {
    await page.getByRole('application', { name: 'Level canvas' }).press('f');
    const zoom = Number.parseInt((await shown.textContent()) ?? '', 10) / 100;
    expect(ACROSS * zoom, where).toBeGreaterThan(LEAST.width / 2);
  });
}

async function lookAtControls(page: Page, where: string): Promise<void> {
  await until(async () => {
    const missed = (await controlsOf(page)).filter(({ isReached }) => !isReached);
    expect(missed.map(({ name }) => `${where}: ${name}`)).toEqual([]);
  });
}

async function lookAt({ page }: Stage, size: { width: number; height: number }): Promise<void> {
  const name = `${size.width} x ${size.height}`;
  await page.setViewportSize(size);
  const tabs = page.getByRole('navigation', { name: 'Panels' });
  const isWide = size.width >= WIDE.width && size.height >= WIDE.height;
  await tabs.waitFor({ state: isWide ? 'hidden' : 'visible' });
  if (isWide) {
    await lookAtCanvas(page, name);
    await lookAtLevel(page, name);
    for (const panel of ['Runs', 'Outline', 'Solver', 'Effects', 'Accuracy', 'Inspector']) {
      // by the keyboard: no tooltip covers anything
      await page.getByRole('tab', { name: panel }).press('Enter');
      await lookAtControls(page, `${name}, ${panel}`);
    }
    return;
  }
  const sizes = new Set<string>();
  for (const panel of PANELS) {
    const tab = tabs.getByRole('button', { name: panel });
    if ((await tab.getAttribute('aria-pressed')) !== 'true') await tab.press('Enter');
    const canvas = await lookAtCanvas(page, `${name}, ${panel}`);
    if (!sizes.has(canvas)) await lookAtLevel(page, `${name}, ${panel}`);
    sizes.add(canvas);
    await lookAtControls(page, `${name}, ${panel}`);
  }
}

inChromium('sizes of the page in Chromium', ({ on }) => {
  it(
    'the canvas stays large and every panel is reachable, from a full screen to one at 200 % zoom',
    on({ '01': straight() }, async (stage) => {
      await verdict(stage.page, 'completable');
      const sizes = [
        [1440, 900],
        [1280, 600],
        [880, 520],
        [1024, 500],
        [720, 450],
        [640, 480],
      ];
      for (const [width, height] of sizes) await lookAt(stage, { width, height });
    }),
  );

  it(
    'the same holds on phones and tablets, in portrait and landscape',
    on(
      { '01': straight() },
      async (stage) => {
        await verdict(stage.page, 'completable');
        const sizes = [
          [360, 640],
          [640, 360],
          [390, 844],
          [844, 390],
          [932, 430],
          [820, 1180],
        ];
        for (const [width, height] of sizes) await lookAt(stage, { width, height });
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );
});
