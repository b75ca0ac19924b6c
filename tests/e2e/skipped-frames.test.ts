import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { command } from './commands.ts';
import { hurry, pass } from './frames.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';

/**
 * Waits until the canvas has not changed for some frames; with 0 of them, it looks once.
 * @returns whether the canvas shows something else than at the last call
 */
const changes = (page: Page, calm: number): Promise<boolean> =>
  page.evaluate(async (frames) => {
    const canvas = document.querySelector<HTMLCanvasElement>('[aria-label="Level canvas"] canvas');
    const brush = canvas?.getContext('2d');
    if (canvas === null || !brush) throw new Error('no canvas');
    const seen = globalThis as { shown?: Uint32Array };
    const look = async () => {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      return new Uint32Array(brush.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
    };
    const isSame = (one: Uint32Array, other: Uint32Array) => {
      for (let i = 0; i < one.length; i++) if (one[i] !== other[i]) return false;
      return one.length === other.length;
    };
    // after two frames, all changes are drawn
    await look();
    let now = await look();
    for (let same = 0; same < frames; ) {
      const before = now;
      now = await look();
      same = isSame(now, before) ? same + 1 : 0;
    }
    const isNew = seen.shown === undefined || !isSame(seen.shown, now);
    seen.shown = now;
    return isNew;
  }, calm);

inChromium('frames that are skipped in Chromium', ({ on }) => {
  it(
    'hide nothing: with reduced motion, the canvas shows each change before its clock goes on',
    on({ '01': garden(), '02': straight() }, async ({ page, canvas, file, saved }) => {
      await saved();
      await canvas.fit(file('01'));
      // workers measure it, and it may come at any time
      await command(page, 'Show or hide the slack fan');
      const nova = { x: 400, y: 440 };
      const to = (name: string, level: string) => async () => {
        await page.getByRole('tree', { name: 'Levels' }).getByRole('treeitem').filter({ hasText: name }).first().click();
        await page.getByRole('heading', { level: 1, name, exact: true }).waitFor();
        await canvas.fit(file(level));
      };
      const key = (name: string) => () => page.keyboard.press(name);
      const at = canvas.at(nova);
      const steps: Readonly<Record<string, () => Promise<unknown>>> = {
        hover: () => page.mouse.move(at.x, at.y),
        select: () => canvas.click(nova),
        'begin a drag': async () => {
          await page.mouse.move(at.x, at.y);
          await page.mouse.down();
          await page.mouse.move(at.x + 40, at.y + 20, { steps: 3 });
        },
        'end it': async () => {
          await page.mouse.move(at.x + 60, at.y, { steps: 3 });
          await page.mouse.up();
        },
        undo: key('Control+z'),
        nudge: key('ArrowRight'),
        'select all': key('Control+a'),
        'select nothing': key('Escape'),
        'zoom in': key('+'),
        'zoom out': key('-'),
        'to a tick': key('End'),
        'hide the ranges': () => command(page, 'Show or hide the range of the gun'),
        theme: () => page.emulateMedia({ colorScheme: 'dark' }),
        'another theme': () => page.emulateMedia({ colorScheme: 'light' }),
        'a larger page': () => page.setViewportSize({ width: 1400, height: 860 }),
        'a smaller page': () => page.setViewportSize({ width: 1180, height: 760 }),
        'another level': to('Straight', '02'),
        'and back': to('Garden', '01'),
      };
      await hurry(page, 0);
      await changes(page, 5);
      const unchanged: string[] = [];
      for (const [name, act] of Object.entries(steps)) {
        await act();
        if (!(await changes(page, 5))) unchanged.push(name);
        await pass(page, 2000);
        expect(await changes(page, 0), `after "${name}", the canvas changes by itself`).toBe(false);
      }
      // each of them is seen, or it would show nothing here
      expect(unchanged).toEqual([]);
    }),
  );
});
