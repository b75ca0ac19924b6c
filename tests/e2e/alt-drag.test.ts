import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { garden } from './levels.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const A = { x: 400, y: 200 };
const MINERAL = { x: 560, y: 480 };

inChromium('dragging objects in Chromium', ({ on }) => {
  it(
    'moves a copy with Alt, pressed at any time, while the original stays; one step, which Esc cancels',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      const rocks = () => (file('01').asteroids ?? []).map(({ id, x, y }) => ({ id, x, y }));
      const [first, ...others] = rocks();
      await canvas.fit(file('01'));
      await canvas.drag(A, { to: [{ x: 400, y: 352 }], keys: ['Alt'] });
      await until(() => expect(rocks()).toEqual([first, ...others, { id: expect.any(String), x: 400, y: 352 }]));
      expect(rocks().map(({ id }) => id)).toContain('a1');
      expect(new Set(rocks().map(({ id }) => id)).size).toBe(4);
      // the copy is selected
      await page.keyboard.press('ArrowDown');
      await until(() => expect(rocks()).toEqual([first, ...others, { id: expect.any(String), x: 400, y: 353 }]));
      await page.keyboard.press('Control+z');
      await page.keyboard.press('Control+z');
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();
      await until(() => expect(rocks()).toEqual([first, ...others]));

      // several objects, with the astronaut, who is not copied
      await canvas.click(A);
      await canvas.click(MINERAL, ['Shift']);
      await canvas.click({ x: 200, y: 304 }, ['Shift']);
      await canvas.drag(A, { to: [{ x: 400, y: 304 }], keys: ['Alt'] });
      await until(() => expect(file('01').minerals).toHaveLength(2));
      const [mineral, mineralCopy] = file('01').minerals ?? [];
      expect(mineral).toEqual({ id: 'm1', ...MINERAL });
      expect(rocks()).toEqual([
        first,
        ...others,
        { id: expect.any(String), x: A.x + mineralCopy.x - MINERAL.x, y: A.y + mineralCopy.y - MINERAL.y },
      ]);
      expect(file('01').astronaut).toEqual({ x: 200, y: 304 });
      await page.getByRole('button', { name: /^Undo: Duplicate 2 objects/ }).click();
      await until(() => expect(rocks()).toEqual([first, ...others]));
      expect(file('01').minerals).toEqual([{ id: 'm1', ...MINERAL }]);

      // Alt pressed during the drag copies, released it moves, and Esc cancels everything
      const name = (which: RegExp) => page.getByRole('region', { name: 'Inspector and tools' }).getByText(which);
      await canvas.click({ x: 300, y: 100 });
      await canvas.drag(A, {
        to: [{ x: 440, y: 352 }],
        before: async () => {
          await page.keyboard.down('Alt');
          await page.getByRole('heading', { name: 'Asteroid 4' }).waitFor();
          await page.keyboard.up('Alt');
          await page.getByRole('heading', { name: 'Asteroid 1' }).waitFor();
          await page.keyboard.down('Alt');
          await page.getByRole('heading', { name: 'Asteroid 4' }).waitFor();
          await page.keyboard.press('Escape');
          await page.keyboard.up('Alt');
        },
      });
      await page.getByRole('heading', { name: 'Asteroid 1' }).waitFor();
      expect(await name(/Asteroid 4/).count()).toBe(0);
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();
      await canvas.drag(A, {
        to: [{ x: 440, y: 352 }],
        keys: ['Alt'],
        before: async () => {
          await page.keyboard.up('Alt');
        },
      });
      await until(() => expect(rocks()).toEqual([{ id: 'a1', x: 440, y: 352 }, ...others]));
      await saved();
    }),
  );

  it(
    'guides connect the dragged object with the objects that it aligns with',
    on(
      {
        '01': garden({
          astronaut: { x: 200, y: 700 },
          blackHole: { x: 904, y: 740 },
          asteroids: [
            { id: 'a1', ...A, radius: 32 },
            { id: 'c1', x: 720, y: 560, radius: 16 },
          ],
          novae: [],
          repulsors: [],
          aliens: [],
          minerals: [],
        }),
      },
      async ({ page, canvas, file }) => {
        await canvas.fit(file('01'));
        const guideAt = (place: { x: number; y: number }) => countColour(page, canvas.at(place), 12, COLOURS.dark.guide);
        await canvas.drag(
          { x: 720, y: 560 },
          {
            to: [{ x: 401, y: 326 }],
            before: async () => {
              await until(async () => expect(await guideAt({ x: 400, y: 260 })).toBeGreaterThan(10));
              // at the start of the drag, and on the way back there
              expect(await guideAt({ x: 400, y: 450 })).toBe(0);
              expect(await guideAt({ x: 400, y: 560 })).toBe(0);
            },
          },
        );
        await page.keyboard.press('Control+z');
        await canvas.drag(
          { x: 720, y: 560 },
          {
            to: [{ x: 560, y: 201 }],
            before: async () => {
              await until(async () => expect(await guideAt({ x: 490, y: 200 })).toBeGreaterThan(10));
              expect(await guideAt({ x: 650, y: 200 })).toBe(0);
            },
          },
        );
        await until(() => expect(file('01').asteroids?.[1]).toMatchObject({ x: 560, y: 200 }));
      },
    ),
  );
});
