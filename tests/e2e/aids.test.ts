import { expect, it } from 'vitest';
import { complaintsAbout } from './axe.ts';
import { garden } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('aids of the canvas in Chromium', ({ on }) => {
  it(
    'rulers and minimap are shown by keys; the map appears where part of the level is out of view, and moves the view',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      const map = page.getByRole('img', { name: 'Minimap: drag to move the view' });
      const rulers = page.locator('.rulers');
      expect([await map.count(), await rulers.count()]).toEqual([0, 0]);
      await page.keyboard.press('Shift+R');
      await rulers.waitFor();
      // the mark follows the pointer
      const at = canvas.at({ x: 400, y: 200 });
      await page.mouse.move(at.x, at.y);
      await until(async () => expect((await page.locator('.rulers__across').boundingBox())?.x).toBeCloseTo(at.x, -0.5));
      for (let i = 0; i < 6; i++) await page.keyboard.press('Equal');
      await map.waitFor();
      const seen = page.locator('.minimap__view');
      const before = await seen.boundingBox();
      const box = await map.boundingBox();
      if (box === null || before === null) throw new Error('the map is not seen');
      await page.mouse.move(box.x + 20, box.y + box.height - 20);
      await page.mouse.down();
      await until(async () => expect((await seen.boundingBox())?.x).toBeLessThan(before.x));
      await page.mouse.up();
      expect(await complaintsAbout(page, 'aids', 'main')).toEqual([]);
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('Shift+O');
      await map.waitFor({ state: 'hidden' });
      await page.keyboard.press('Shift+O');
      await map.waitFor();
      await page.keyboard.press('f');
      await map.waitFor({ state: 'hidden' });
      await page.keyboard.press('Shift+R');
      await rulers.waitFor({ state: 'hidden' });
    }),
  );

  it(
    'while an object is moved, equal gaps hold it and say how large they are',
    on(
      {
        '01': garden({
          asteroids: [
            { id: 'a1', x: 400, y: 200, radius: 16 },
            { id: 'b1', x: 471, y: 200, radius: 16 },
            { id: 'c1', x: 640, y: 200, radius: 16 },
          ],
        }),
      },
      async ({ page, canvas, file }) => {
        await canvas.fit(file('01'));
        await canvas.drag(
          { x: 640, y: 200 },
          {
            to: [{ x: 541, y: 200 }],
            before: async () => {
              await until(async () => expect(await page.locator('.canvas__message').getByText('39 px').count()).toBe(2));
            },
          },
        );
        await until(() => expect(file('01').asteroids?.[2]).toMatchObject({ x: 542, y: 200 }));
        expect(await page.locator('.canvas__message').getByText('39 px').count()).toBe(0);
      },
    ),
  );
});
