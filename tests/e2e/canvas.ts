import type { Page } from 'playwright-core';
import { expect } from 'vitest';
import { extentOf } from '../../editor/canvas/extent.ts';
import { fitBox, type Point, toScreen, type View } from '../../editor/canvas/view.ts';
import { boxOf } from '../../engine/index.ts';
import { type LevelFile, rulesOf } from '../../schema/index.ts';
import { until } from './until.ts';

export interface Drag {
  /** Places of the drag; the button is released at the last one. */
  readonly to: readonly Point[];
  /** Keys that are held from before the press until after the release. */
  readonly keys?: readonly string[];
  readonly button?: 'left' | 'middle' | 'right';
  /** Called while the button is still down. */
  readonly before?: () => Promise<void>;
}

/** Mouse and keyboard on the canvas; places are in px of the level. */
export interface Canvas {
  /** Fits the level into view and computes from its file where objects are on the screen. */
  fit(file: LevelFile): Promise<void>;
  /** The position on the page of a place of the level. */
  at(place: Point): Point;
  click(place: Point, keys?: readonly string[]): Promise<void>;
  drag(from: Point, drag: Drag): Promise<void>;
  /** screen px per px of the level, as of the last fit */
  zoom(): number;
}

/** Presses keys, does something, and releases them. */
export async function holding(page: Page, keys: readonly string[], act: () => Promise<void>): Promise<void> {
  for (const key of keys) await page.keyboard.down(key);
  await act();
  for (const key of [...keys].reverse()) await page.keyboard.up(key);
}

export function canvasOf(page: Page): Canvas {
  const element = page.getByRole('application', { name: 'Level canvas' });
  let view: View = { x: 0, y: 0, zoom: 1, width: 1, height: 1 };
  let corner: Point = { x: 0, y: 0 };
  const at = (place: Point): Point => {
    const { x, y } = toScreen(view, place);
    return { x: corner.x + x, y: corner.y + y };
  };
  return {
    at,
    zoom: () => view.zoom,
    async fit(file) {
      const all = extentOf(file, boxOf(rulesOf(file)));
      if (all === null) throw new Error('a level has an astronaut at least');
      await element.focus();
      await page.keyboard.press('f');
      await until(async () => {
        const box = await element.boundingBox();
        if (box === null) throw new Error('the canvas is not seen');
        corner = { x: box.x, y: box.y };
        view = fitBox({ x: 0, y: 0, zoom: 1, width: box.width, height: box.height }, all);
        expect(
          await page
            .locator('.statusbar')
            .getByText(/^\d+ %$/)
            .textContent(),
        ).toBe(`${Math.round(view.zoom * 100)} %`);
      });
    },
    async click(place, keys = []) {
      const { x, y } = at(place);
      await holding(page, keys, () => page.mouse.click(x, y));
    },
    async drag(from, { to, keys = [], button = 'left', before }) {
      const start = at(from);
      await holding(page, keys, async () => {
        await page.mouse.move(start.x, start.y);
        await page.mouse.down({ button });
        for (const place of to) {
          const { x, y } = at(place);
          await page.mouse.move(x, y, { steps: 3 });
        }
        await before?.();
        await page.mouse.up({ button });
      });
    },
  };
}
