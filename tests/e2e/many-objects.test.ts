import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { extentOf } from '../../editor/canvas/extent.ts';
import { fitBox, type Point, toScreen } from '../../editor/canvas/view.ts';
import { boxOf } from '../../engine/index.ts';
import { DEFAULT_RULES, type LevelFile } from '../../schema/index.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const STEP = 32;
const COLUMNS = 16;

/** Rows of objects on a grid, with the given distance between rows, px. */
const rows = (name: string, from: number, count: number, radius: number, aside = 0) =>
  Array.from({ length: COLUMNS * count }, (_, k) => ({
    id: `${name}${k}`.padEnd(2, '0'),
    x: STEP * (k % COLUMNS) + aside,
    y: STEP * (from + Math.floor(k / COLUMNS)),
    radius,
  }));

/** Repulsors and asteroids above, novae and minerals below, which are drawn above asteroids. */
const crowd = (): LevelFile => ({
  version: 1,
  name: 'Crowd',
  astronaut: { x: 0, y: 360 },
  blackHole: { x: 480, y: 360 },
  repulsors: rows('r', 0, 4, 24, 16),
  asteroids: rows('a', 0, 4, 14),
  novae: rows('n', 6, 4, 12, 8),
  minerals: rows('m', 6, 4, 8),
});

interface Seen {
  /** The number of images drawn in the frame. */
  readonly drawn: number;
  /** The largest difference of a colour of a px between that frame and a later one at rest, 0 to 255. */
  readonly difference: number;
}

/** Moves the pointer once per frame, as a hand does, and reads the canvas in the last of these frames, and again at rest. */
const dragAndLook = (page: Page, from: Point, by: readonly Point[]): Promise<Seen> =>
  page.evaluate(
    async ([start, steps]) => {
      const canvas = document.querySelector<HTMLCanvasElement>('.canvas canvas');
      const brush = canvas?.getContext('2d');
      if (canvas === null || !brush) throw new Error('no canvas');
      let drawn = 0;
      const { drawImage } = CanvasRenderingContext2D.prototype;
      CanvasRenderingContext2D.prototype.drawImage = function (this: CanvasRenderingContext2D, ...what: unknown[]) {
        if (this.canvas === canvas) drawn++;
        return Reflect.apply(drawImage, this, what);
      };
      const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
      // requested last in a frame: Phaser has already drawn
      const drawnFrame = async (act: () => void) => {
        await frame();
        drawn = 0;
        act();
        await frame();
        return { drawn, data: brush.getImageData(0, 0, canvas.width, canvas.height).data };
      };
      let seen = { drawn: 0, data: new Uint8ClampedArray() };
      for (const { x, y } of steps) {
        const place = { clientX: start.x + x, clientY: start.y + y };
        seen = await drawnFrame(() =>
          canvas.dispatchEvent(new PointerEvent('pointermove', { bubbles: true, pointerType: 'mouse', ...place })),
        );
      }
      for (let i = 0; i < 30; i++) await frame();
      const rest = await drawnFrame(() => {});
      CanvasRenderingContext2D.prototype.drawImage = drawImage;
      let difference = 0;
      for (let i = 0; i < rest.data.length; i++) difference = Math.max(difference, Math.abs(rest.data[i] - seen.data[i]));
      return { drawn: seen.drawn, difference };
    },
    [from, by] as const,
  );

inChromium('hundreds of objects in Chromium', ({ on }) => {
  it(
    'are drawn as few images during a drag, at the right places and in the same order as at rest',
    on(
      { '01': crowd() },
      async ({ page, canvas, saved }) => {
        await saved();
        await canvas.fit(crowd());
        // the size of a grid step on the screen, px
        await page.keyboard.press('Control+0');
        await until(async () => expect(await page.getByText('100 %', { exact: true }).count()).toBe(1));
        const box = await page.getByRole('application', { name: 'Level canvas' }).boundingBox();
        const all = extentOf(crowd(), boxOf(DEFAULT_RULES));
        if (box === null || all === null) throw new Error('the canvas is not seen');
        const view = { ...fitBox({ x: 0, y: 0, zoom: 1, width: box.width, height: box.height }, all), zoom: 1 };
        const at = (place: Point): Point => {
          const { x, y } = toScreen(view, place);
          return { x: box.x + x, y: box.y + y };
        };
        const go = async (place: Point) => {
          const { x, y } = at(place);
          await page.mouse.move(x, y, { steps: 3 });
        };
        await go({ x: -30, y: -40 });
        await page.mouse.down();
        await go({ x: 540, y: 140 });
        await page.mouse.up();
        await page.getByRole('heading', { name: `${2 * 4 * COLUMNS} objects` }).waitFor();
        const start = { x: 4 * STEP, y: 2 * STEP };
        await go(start);
        await page.mouse.down();
        await go({ x: start.x + 8, y: start.y });
        const steps = Array.from({ length: 24 }, (_, k) => ({ x: 8, y: 8 * (k + 1) }));
        const { drawn, difference } = await dragAndLook(page, at(start), steps);
        await page.mouse.up();
        expect(drawn).toBeGreaterThan(0);
        expect(drawn).toBeLessThan(60);
        // blended colours are rounded in another order
        expect(difference).toBeLessThanOrEqual(8);
      },
      { context: { reducedMotion: 'reduce', viewport: { width: 1440, height: 900 } } },
    ),
  );
});
