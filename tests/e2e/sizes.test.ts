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

/** Checks that the canvas is large enough, the whole level fills most of it, and nothing extends beyond the page. */
async function lookAtCanvas(page: Page, where: string): Promise<void> {
  const size = page.viewportSize() as { width: number; height: number };
  const canvas = page.getByRole('application', { name: 'Level canvas' });
  await until(async () => {
    const box = await canvas.boundingBox();
    expect(box?.width, where).toBeGreaterThanOrEqual(LEAST.width);
    expect(box?.height, where).toBeGreaterThanOrEqual(Math.max(LEAST.height, LEAST.share * size.height) - 1);
  });
  await until(async () => {
    await canvas.press('f');
    const zoom =
      Number.parseInt(
        (await page
          .locator('.statusbar')
          .getByText(/^\d+ %$/)
          .textContent()) ?? '',
        10,
      ) / 100;
    expect(ACROSS * zoom, where).toBeGreaterThan(LEAST.width / 2);
  });
  const scrolled = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
  expect(scrolled, where).toEqual([size.width, size.height]);
}

async function lookAtControls(page: Page, where: string): Promise<void> {
  // no tooltip covers anything
  await page.mouse.move(1, 1);
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
    for (const panel of ['Runs', 'Outline', 'Solver', 'Effects', 'Accuracy', 'Inspector']) {
      await page.getByRole('tab', { name: panel }).click();
      await lookAtControls(page, `${name}, ${panel}`);
    }
    return;
  }
  for (const panel of PANELS) {
    const tab = tabs.getByRole('button', { name: panel });
    if ((await tab.getAttribute('aria-pressed')) !== 'true') await tab.click();
    await lookAtCanvas(page, `${name}, ${panel}`);
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
