import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { nextFrames } from './frames.ts';
import { straight } from './levels.ts';
import { inChromium, type Stage } from './stage.ts';
import { until } from './until.ts';

/** She stays far from everything for a long time. */
const drifting = () =>
  straight({
    runs: [
      {
        name: 'first',
        holds: [
          [600, 1200],
          [1800, 2400],
        ],
      },
    ],
  });

const holdsAre = ({ file }: Stage, holds: number[][]) => until(() => expect(file('01').runs?.[0].holds).toEqual(holds));

async function boxOf(page: Page, role: 'button' | 'slider' | 'application' | 'img', name: RegExp) {
  const box = await page.getByRole(role, { name }).boundingBox();
  if (box === null) throw new Error(`${name} is not seen`);
  return { ...box, right: box.x + box.width, bottom: box.y + box.height, middle: box.y + box.height / 2 };
}

/** The first hold on the screen, and px per tick. */
async function firstHold(page: Page) {
  const bar = await boxOf(page, 'button', /^Hold 1:/);
  const name = (await page.getByRole('button', { name: /^Hold 1:/ }).getAttribute('aria-label')) ?? '';
  const [, press, release] = /tick (\d+) to (\d+)/.exec(name) ?? [];
  return { ...bar, zoom: (bar.width + 2) / (Number(release) - Number(press)) };
}

inChromium('the ends of holds in Chromium', ({ on }) => {
  it(
    'can be dragged from inside and outside of the bar, the middle moves it, and a legend explains the graphs',
    on({ '01': drifting() }, async (stage) => {
      const { page } = stage;
      // until the end is known, the timeline reaches to the last hold only
      await page.getByTitle(/^2 holds, reaches the black hole at/).waitFor();
      await nextFrames(page);
      // by as many ticks as fit into whole px
      const drag = async (x: number, px: number) => {
        const { middle, zoom } = await firstHold(page);
        await page.mouse.move(Math.round(x), middle);
        await page.mouse.down();
        await page.mouse.move(Math.round(x) + px, middle, { steps: 3 });
        await page.mouse.up();
        return Math.round(px / zoom);
      };
      const { x, right, width } = await firstHold(page);
      const inside = await drag(x + 3, -20);
      await holdsAre(stage, [
        [600 + inside, 1200],
        [1800, 2400],
      ]);
      await page.keyboard.press('Control+z');
      await holdsAre(stage, [
        [600, 1200],
        [1800, 2400],
      ]);
      await until(async () => expect((await firstHold(page)).x).toBeCloseTo(x, 0));
      const outside = await drag(right + 4, 20);
      await holdsAre(stage, [
        [600, 1200 + outside],
        [1800, 2400],
      ]);
      await page.keyboard.press('Control+z');
      await until(async () => expect((await firstHold(page)).right).toBeCloseTo(right, 0));
      const moved = await drag(x + width / 2, 15);
      await holdsAre(stage, [
        [600 + moved, 1200 + moved],
        [1800, 2400],
      ]);

      // the labels of the graphs are above them and do not cover them
      const key = await page.getByText(/^speed, to \d+ px\/s$/).boundingBox();
      const graphs = await boxOf(page, 'img', /^Speed and clearance/);
      expect((key?.y ?? 0) + (key?.height ?? 0)).toBeLessThanOrEqual(graphs.y + 1);

      await page.getByRole('button', { name: 'Timeline legend' }).click();
      const legend = page.getByRole('dialog', { name: 'Timeline legend' });
      for (const words of [
        'The gun is held',
        'Slack:',
        'Not reached:',
        'Near miss:',
        'Asteroid 2 becomes the target',
        'enters repulsor 1',
      ]) {
        await legend.getByText(words).waitFor();
      }
      await page.keyboard.press('Escape');
      await legend.waitFor({ state: 'hidden' });
    }),
  );

  it(
    'have room for a finger on a phone, as do the buttons around',
    on(
      { '01': drifting() },
      async (stage) => {
        const { page, context } = stage;
        await page.getByTitle(/^2 holds, reaches the black hole at/).waitFor({ state: 'attached' });
        await nextFrames(page);
        const small: unknown[] = [];
        for (const part of [/^Press of hold 1/, /^Release of hold 2/]) {
          const { width, height } = await boxOf(page, 'slider', part);
          if (width < 44 || height < 44) small.push([part, width, height]);
        }
        const ruler = await boxOf(page, 'slider', /^Time$/);
        if (ruler.height < 44) small.push(['ruler', ruler.height]);
        for (const button of await page.locator('.transport button').all()) {
          const box = await button.boundingBox();
          if (box === null || box.width < 44 || box.height < 44) small.push([await button.getAttribute('aria-label'), box]);
        }
        expect(small).toEqual([]);

        const { right, middle, zoom } = await firstHold(page);
        const finger = await context.newCDPSession(page);
        const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', x: number) =>
          finger.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x, y: middle }] });
        // clearly beside the edge
        const from = Math.round(right) + 12;
        await touch('touchStart', from);
        await touch('touchMove', from + 6);
        await touch('touchMove', from + 12);
        await touch('touchEnd', from + 12);
        await holdsAre(stage, [
          [600, 1200 + Math.round(12 / zoom)],
          [1800, 2400],
        ]);
        const { zoom: before } = await firstHold(page);
        await page.getByRole('button', { name: 'Zoom the timeline in' }).tap();
        await until(async () => expect((await firstHold(page)).zoom / before).toBeCloseTo(1.5, 1));
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );
});
