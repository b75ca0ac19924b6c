import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import type { LevelFile } from '../../schema/index.ts';
import { nextFrames } from './frames.ts';
import { compare } from './pictures.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const COLUMNS = 50;
const STEP = 40;

const field = (name: string, from: number, count: number) =>
  Array.from({ length: count }, (_, k) => ({
    id: `${name}${k}`.padEnd(2, '0'),
    x: STEP * (k % COLUMNS),
    y: STEP * (from + Math.floor(k / COLUMNS)),
    radius: 14,
  }));

/** Two thousand objects. */
const crowd = (): LevelFile => ({
  version: 1,
  name: 'Crowd',
  astronaut: { x: -80, y: 800 },
  blackHole: { x: 2100, y: 800 },
  asteroids: field('a', 0, 1000),
  novae: field('n', 20, 1000),
});

/** Turns the wheel once per frame, in and out again. @returns the largest number of images and circles drawn in a frame */
const zoomAndCount = (page: Page, turns: number): Promise<number> =>
  page.evaluate(async (count) => {
    const host = document.querySelector('.canvas');
    if (host === null) throw new Error('no canvas');
    const { left, top, width, height } = host.getBoundingClientRect();
    const brush = CanvasRenderingContext2D.prototype;
    const { drawImage, arc } = brush;
    let drawn = 0;
    brush.drawImage = function (this: CanvasRenderingContext2D, ...what: unknown[]) {
      drawn++;
      return Reflect.apply(drawImage, this, what);
    };
    brush.arc = function (this: CanvasRenderingContext2D, ...what) {
      drawn++;
      return Reflect.apply(arc, this, what);
    };
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    let most = 0;
    for (let i = 0; i < 2 * count; i++) {
      const at = { clientX: left + width / 2, clientY: top + height / 2 };
      host.dispatchEvent(new WheelEvent('wheel', { bubbles: true, cancelable: true, deltaY: i < count ? -40 : 40, ...at }));
      drawn = 0;
      await frame();
      await frame();
      most = Math.max(most, drawn);
    }
    Object.assign(brush, { drawImage, arc });
    return most;
  }, turns);

inChromium('thousands of objects in Chromium', ({ on }) => {
  it(
    'are not drawn one by one during a zoom with all of them selected, and are sharp again at rest',
    on(
      { '01': crowd() },
      async ({ page, saved }) => {
        await saved();
        const canvas = page.getByRole('application', { name: 'Level canvas' });
        await canvas.focus();
        await page.keyboard.press('f');
        await page.keyboard.press('Control+a');
        await page.getByRole('heading', { name: '2,002 objects' }).waitFor();
        const look = async () => {
          await page.mouse.move(2, 2);
          await nextFrames(page);
          return canvas.screenshot();
        };
        // the canvas is at rest when two pictures are equal
        let before = await look();
        await until(async () => {
          const last = before;
          before = await look();
          expect(before.equals(last)).toBe(true);
        });
        // in two frames; one by one it would be more than 10,000
        expect(await zoomAndCount(page, 8)).toBeLessThan(3000);
        await until(async () => expect((await compare(page, before, await look())).share).toBeLessThan(0.002));
      },
      { context: { reducedMotion: 'reduce', viewport: { width: 1280, height: 800 } }, query: 'renderer=canvas' },
    ),
  );
});
