// Editing kinds with vectors or a second place. GQ_SHOTS names a folder for pictures of the page.
import { expect, it } from 'vitest';
import { tool } from './commands.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const LEVEL = {
  version: 1,
  name: 'Wind',
  astronaut: { x: 100, y: 300 },
  blackHole: { x: 900, y: 300 },
  asteroids: [{ id: 'rock', x: 300, y: 200, radius: 32 }],
  winds: [{ id: 'breeze', x: 500, y: 160, radius: 96 }],
  wormholes: [{ id: 'worm', x: 400, y: 440, toX: 700, toY: 480, radius: 32 }],
};

const shots = process.env.GQ_SHOTS;

inChromium('winds and wormholes', ({ on }) => {
  it(
    'can be placed, dragged, typed, undone and saved',
    on({ '01': LEVEL }, async ({ page, canvas, file, saved }) => {
      const shot = async (name: string) => {
        if (shots !== undefined) await page.screenshot({ path: `${shots}/${name}.png` });
      };
      const worm = (id = 'worm') =>
        (file('01').wormholes ?? []).find((one) => one.id === id) ?? { x: 0, y: 0, toX: 0, toY: 0, radius: 0 };
      await canvas.fit(file('01'));
      await shot('1-open');
      // each mouth separately
      await canvas.drag({ x: 700, y: 480 }, { to: [{ x: 640, y: 520 }] });
      await until(() => expect(worm()).toMatchObject({ x: 400, y: 440, toX: 640, toY: 520 }));
      await canvas.drag({ x: 400, y: 440 }, { to: [{ x: 352, y: 400 }], before: () => shot('2-dragging-a-mouth') });
      await until(() => expect(worm()).toMatchObject({ x: 352, y: 400, toX: 640, toY: 520 }));
      await shot('3-mouths-dragged');
      await page.keyboard.press('Control+z');
      await until(() => expect(worm()).toMatchObject({ x: 400, y: 440, toX: 640, toY: 520 }));
      // a nudge moves both
      await page.keyboard.press('ArrowRight');
      await until(() => expect(worm()).toMatchObject({ x: 401, y: 440, toX: 641, toY: 520 }));
      await page.keyboard.press('Control+z');
      // a marquee around the second mouth selects the wormhole; together with an asteroid, a drag moves both mouths
      await canvas.drag({ x: 580, y: 570 }, { to: [{ x: 700, y: 450 }] });
      await canvas.click({ x: 300, y: 200 }, ['Shift']);
      await shot('4-group');
      await canvas.drag({ x: 300, y: 200 }, { to: [{ x: 300, y: 240 }] });
      await until(() => {
        expect(worm().y).not.toBe(440);
        // it may have snapped
        expect(worm()).toMatchObject({ toX: worm().x + 240, toY: worm().y + 80 });
      });
      await page.keyboard.press('Control+z');
      await until(() => expect(worm()).toMatchObject({ x: 400, y: 440, toX: 640, toY: 520 }));
      // a rim resizes both
      await page.keyboard.press('Escape');
      await canvas.click({ x: 640, y: 520 });
      await canvas.drag({ x: 672, y: 520 }, { to: [{ x: 688, y: 520 }] });
      await until(() => expect(worm()).toMatchObject({ radius: 48 }));
      await shot('5-inspected');
      // copies
      await page.keyboard.press('Control+d');
      await until(() => expect(file('01').wormholes).toHaveLength(2));
      expect(file('01').wormholes?.[1]).toMatchObject({ x: 432, y: 472, toX: 672, toY: 552 });
      await page.keyboard.press('Control+z');
      // tools
      await tool(page, 'Wind').click();
      await canvas.click({ x: 760, y: 160 });
      await until(() => expect(file('01').winds).toHaveLength(2));
      const ax = page.getByLabel('wind x');
      await ax.fill('60');
      await ax.press('Enter');
      await until(() => expect(file('01').winds?.[1]).toMatchObject({ ax: 60 }));
      await page.getByLabel('wind y').fill('1000');
      await page.getByLabel('wind y').press('Enter');
      await shot('6-wind-typed');
      await page.keyboard.press('Escape');
      await tool(page, 'Wormhole').click();
      await canvas.click({ x: 160, y: 520 });
      await until(() => expect(file('01').wormholes).toHaveLength(2));
      await shot('7-wormhole-placed');
      await saved();
    }),
  );
});
