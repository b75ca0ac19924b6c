import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { command } from './commands.ts';
import { hurry, nextFrames, pass } from './frames.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

/** What the canvas shows. */
const drawn = (page: Page): Promise<string> =>
  page.evaluate(() => (document.querySelector('[aria-label="Level canvas"] canvas') as HTMLCanvasElement).toDataURL());

/** Waits until the canvas has not changed for five frames. */
async function atRest(page: Page): Promise<string> {
  let [before, same] = [await drawn(page), 0];
  await until(async () => {
    await nextFrames(page);
    const now = await drawn(page);
    same = now === before ? same + 1 : 0;
    before = now;
    expect(same).toBeGreaterThanOrEqual(5);
  });
  return before;
}

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
      let last = await atRest(page);
      const unchanged: string[] = [];
      for (const [name, act] of Object.entries(steps)) {
        await act();
        const shown = await atRest(page);
        if (shown === last) unchanged.push(name);
        await pass(page, 2000);
        await nextFrames(page);
        last = await drawn(page);
        expect(last === shown, `after "${name}", the canvas changes by itself`).toBe(true);
      }
      // each of them is seen, or it would show nothing here
      expect(unchanged).toEqual([]);
    }),
  );
});
