import { expect, it } from 'vitest';
import { complaintsAbout } from './axe.ts';
import { command } from './commands.ts';
import { garden } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const A = { x: 400, y: 200 };
const B = { x: 560, y: 160 };

/** Minerals beside each other, above everything else. */
const row = (count: number) => Array.from({ length: count }, (_, i) => ({ id: `m${i}`, x: 20 * i, y: -400 }));

/** px of screen from the box of the selection to what is selected, and to the circle that turns it. */
const [AWAY, STEM] = [14, 26];

inChromium('scaling, turning and repeating in Chromium', ({ on }) => {
  it(
    'by the handles of the box, by keys, and by typed figures; each is one step',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      await canvas.fit(file('01'));
      const rocks = () => (file('01').asteroids ?? []).slice(0, 2).map(({ x, y, radius }) => [x, y, radius]);
      const step = async (what: () => Promise<void>, expected: number[][]) => {
        await what();
        await until(() => expect(rocks()).toEqual(expected));
        await page.keyboard.press('Control+z');
        await until(() => expect(rocks()).toEqual([[400, 200, 32], [560, 160, 32]])); // biome-ignore format: a row each
      };
      await canvas.click(A);
      await canvas.click(B, ['Shift']);
      const px = 1 / canvas.zoom();
      // the right edge of the box: x scales, the left object stays
      const right = { x: 592 + AWAY * px, y: 180 };
      await step(() => canvas.drag(right, { to: [{ x: right.x + 160, y: 180 }] }), [[400, 200, 32], [720, 160, 32]]); // biome-ignore format: a row each
      // the corner keeps the shape; Alt takes the radii along: the box of 224 x 104 px doubles
      const corner = { x: 592 + AWAY * px, y: 232 + AWAY * px };
      await canvas.drag(corner, { to: [{ x: corner.x + 224, y: corner.y + 104 }], keys: ['Alt'] });
      await until(() => expect(rocks().map(([, , radius]) => radius)).toEqual([expect.closeTo(64, 0), expect.closeTo(64, 0)]));
      await page.keyboard.press('Control+z');
      // the circle above the box turns; Shift stops at 15 degrees
      const middle = { x: 480, y: 180 };
      const circle = { x: middle.x, y: 128 - (AWAY + STEM) * px };
      const reach = middle.y - circle.y;
      await step(
        () => canvas.drag(circle, { to: [{ x: middle.x + reach, y: middle.y + 3 }], keys: ['Shift'] }),
        [[460, 100, 32], [500, 260, 32]], // biome-ignore format: a row each
      );
      // Esc puts back
      await canvas.drag(circle, {
        to: [{ x: middle.x + reach, y: middle.y }],
        before: () => page.keyboard.press('Escape'),
      });
      expect(rocks()).toEqual([[400, 200, 32], [560, 160, 32]]); // biome-ignore format: a row each
      // by keys
      await step(() => page.keyboard.press('Shift+H'), [[560, 200, 32], [400, 160, 32]]); // biome-ignore format: a row each
      await step(() => page.keyboard.press('Shift+V'), [[400, 160, 32], [560, 200, 32]]); // biome-ignore format: a row each
      await step(
        async () => {
          for (let i = 0; i < 6; i++) await page.keyboard.press('Shift+Alt+Period');
        },
        [[460, 100, 32], [500, 260, 32]].map((row) => row.map((value) => expect.closeTo(value, 1))) as number[][], // biome-ignore format: a row each
      );
      // typed
      await page.getByRole('textbox', { name: 'scale %' }).fill('50');
      await page.getByRole('textbox', { name: 'scale %' }).press('Enter');
      await step(() => page.getByRole('button', { name: 'Scale to 50 %' }).click(), [[440, 190, 32], [520, 170, 32]]); // biome-ignore format: a row each
      await step(() => page.getByRole('button', { name: 'Turn by 90°' }).click(), [[460, 100, 32], [500, 260, 32]]); // biome-ignore format: a row each
      await saved();
    }),
  );

  it(
    'repeats the selection with a preview, which Cancel takes away and Repeat keeps',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      await canvas.fit(file('01'));
      await canvas.click(A);
      const rocks = () =>
        file('01')
          .asteroids?.slice(3)
          .map(({ x, y }) => [x, y]);
      const count = page.getByRole('contentinfo').getByText(/^\d+ objects$/);
      await page.keyboard.press('Control+Shift+D');
      const panel = page.getByRole('dialog', { name: 'Repeat the selection' });
      await panel.waitFor();
      await until(async () => expect(await count.textContent()).toBe('12 objects'));
      expect(await complaintsAbout(page, 'repeat', '.canvas__panel')).toEqual([]);
      // the differences stand beside the panel, which makes them
      await until(async () => {
        const [own, card] = await Promise.all([panel.boundingBox(), page.locator('.onion').boundingBox()]);
        if (own === null || card === null) throw new Error('not on the screen');
        const isBeside = card.x >= own.x + own.width || card.x + card.width <= own.x;
        expect(isBeside || card.y >= own.y + own.height || card.y + card.height <= own.y).toBe(true);
      });
      await panel.getByRole('button', { name: 'Cancel' }).click();
      await until(async () => expect(await count.textContent()).toBe('9 objects'));
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();

      await page.keyboard.press('Control+Shift+D');
      const type = async (name: string, text: string) => {
        await panel.getByRole('textbox', { name }).fill(text);
        await panel.getByRole('textbox', { name }).press('Enter');
      };
      await type('copies', '2');
      await type('step x', '40');
      await type('step y', '-8');
      await panel.getByRole('button', { name: 'Repeat' }).click();
      await until(() => expect(rocks()).toEqual([[440, 192], [480, 184]])); // biome-ignore format: places
      await page.keyboard.press('Control+z');
      await until(() => expect(rocks()).toEqual([]));

      await canvas.click({ x: 300, y: 100 });
      await canvas.click(A);
      await page.keyboard.press('Control+Shift+D');
      await panel.getByRole('radio', { name: 'in a circle' }).check();
      await type('copies', '3');
      await type('centre x', '400');
      await type('centre y', '300');
      await panel.getByRole('button', { name: 'Repeat' }).click();
      await until(() => expect(rocks()).toEqual([[500, 300], [400, 400], [300, 300]])); // biome-ignore format: places
      await saved();
    }),
  );

  it(
    'says in its panel why a repetition is not possible, and keeps nothing of it',
    on({ '01': { ...garden(), minerals: row(50) } }, async ({ page, file }) => {
      await command(page, 'Select all');
      await page.keyboard.press('Control+Shift+D');
      const panel = page.getByRole('dialog', { name: 'Repeat the selection' });
      const copies = panel.getByRole('textbox', { name: 'copies' });
      await copies.fill('500');
      await copies.press('Enter');
      await panel
        .getByRole('alert')
        .getByText(/20,?000/)
        .waitFor();
      expect(await panel.getByRole('button', { name: 'Repeat' }).isDisabled()).toBe(true);
      await copies.fill('1');
      await copies.press('Enter');
      await panel.getByRole('alert').waitFor({ state: 'hidden' });
      await panel.getByRole('button', { name: 'Repeat' }).click();
      await until(() => expect(file('01').minerals).toHaveLength(100));
    }),
  );
});
