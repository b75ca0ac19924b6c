import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import type { LevelFile } from '../../schema/index.ts';
import { tool } from './commands.ts';
import { garden } from './levels.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

interface Place {
  readonly x: number;
  readonly y: number;
}

const said = (page: Page) => page.getByRole('status', { name: 'Crosshair' });
const hears = (page: Page, text: string | RegExp) => said(page).filter({ hasText: text }).waitFor();

/** Where the crosshair is, as it is said. */
async function placeOf(page: Page): Promise<Place> {
  await hears(page, /x -?[\d.]+, y -?[\d.]+/);
  const [, x, y] = /x (-?[\d.]+), y (-?[\d.]+)/.exec((await said(page).textContent()) ?? '') ?? [];
  return { x: Number(x), y: Number(y) };
}

/** Where a stride leads: the next line that way, or a px on. */
function onward(from: number, way: number, size: number): number {
  if (size === 1) return from + way;
  return way > 0 ? (Math.floor(from / size) + 1) * size : (Math.ceil(from / size) - 1) * size;
}

/** Brings the crosshair there by arrows: as far as may be in strides of 8 lines of the grid of 8 px, then of one, then px by px. */
async function go(page: Page, to: Place): Promise<void> {
  const from = await placeOf(page);
  for (const [axis, back, on] of [
    ['x', 'ArrowLeft', 'ArrowRight'],
    ['y', 'ArrowUp', 'ArrowDown'],
  ] as const) {
    let at = from[axis];
    for (const [modifier, size] of [
      ['Shift+', 64],
      ['', 8],
      ['Alt+', 1],
    ] as const) {
      const way = Math.sign(to[axis] - at);
      for (let next = onward(at, way, size); way !== 0 && (to[axis] - next) * way >= 0; next = onward(at, way, size)) {
        await page.keyboard.press(`${modifier}${way < 0 ? back : on}`);
        at = next;
      }
    }
  }
  await hears(page, `x ${to.x}, y ${to.y}`);
}

/** Presses an arrow so many times. */
async function press(page: Page, arrow: string, times: number): Promise<void> {
  for (let i = 0; i < times; i++) await page.keyboard.press(arrow);
}

const focused = (page: Page) =>
  page.getByRole('application', { name: 'Level canvas' }).evaluate((e) => e === document.activeElement);
const last = (file: LevelFile, list: 'asteroids' | 'novae' | 'repulsors' | 'aliens' | 'minerals') => file[list]?.at(-1);

inChromium('the crosshair in Chromium', ({ on }) => {
  it(
    'every tool is used by the keyboard alone, and what comes of it is said',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      const lists = [
        ['a', 'asteroids', 'Asteroid 4', 'Add asteroids'],
        ['h', 'asteroids', 'Hot asteroid 5', 'Add hot asteroids'],
        ['n', 'novae', 'Nova 2', 'Add novae'],
        ['r', 'repulsors', 'Repulsor 2', 'Add repulsors'],
        ['e', 'aliens', 'Alien 2', 'Add aliens'],
        ['m', 'minerals', 'Mineral 2', 'Add minerals'],
      ] as const;
      for (const [i, [key, list, name, title]] of lists.entries()) {
        await page.keyboard.press(key);
        await hears(page, new RegExp(`^${title}\\. x `));
        const to = { x: 320 + 80 * i, y: 344 };
        await go(page, to);
        await hears(page, `x ${to.x}, y ${to.y}, empty`);
        await page.keyboard.press('Enter');
        await hears(page, `${name} added at x ${to.x}, y ${to.y}`);
        await until(() => expect(last(file('01'), list)).toMatchObject(to));
      }
      expect(last(file('01'), 'asteroids')).toMatchObject({ hot: true });

      // with Shift the tool stays in hand; held, arrows give the radius
      await page.keyboard.press('n');
      await go(page, { x: 320, y: 520 });
      await page.keyboard.press('Shift+Enter');
      await hears(page, 'Nova 3 added');
      await go(page, { x: 640, y: 560 });
      await page.keyboard.press('d');
      await press(page, 'ArrowRight', 3);
      await hears(page, 'Nova 4 added at x 640, y 560, radius 24');
      await page.keyboard.press('d');
      await until(() => expect(last(file('01'), 'novae')).toMatchObject({ x: 640, y: 560, radius: 24 }));
    }),
  );

  it(
    'a tool is chosen by its button, the view goes where the crosshair goes, Esc and the pointer put it away',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      // a tool's button leads there as well, and the view goes where the crosshair goes
      await tool(page, 'Move the view').press('Enter');
      expect(await focused(page)).toBe(true);
      await hears(page, /^Move the view\. x /);
      const far = { x: 1536, y: 560 };
      await go(page, far);
      await page.keyboard.press('Enter');
      await hears(page, `The middle of the view is at x ${far.x}, y ${far.y}`);
      const box = await page.getByRole('application', { name: 'Level canvas' }).boundingBox();
      if (box === null) throw new Error('the canvas is not seen');
      const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
      await until(async () => expect(await countColour(page, middle, 14, COLOURS.dark.select)).toBeGreaterThan(20));

      // Esc puts both away; the crosshair is gone for the pointer, too
      await page.keyboard.press('Escape');
      await until(async () => expect(await countColour(page, middle, 14, COLOURS.dark.select)).toBe(0));
      expect(await tool(page, 'Select').getAttribute('aria-pressed')).toBe('true');
      await page.keyboard.press('a');
      await until(async () => expect(await countColour(page, middle, 14, COLOURS.dark.select)).toBeGreaterThan(20));
      await page.mouse.move(box.x + 40, box.y + 200);
      await page.mouse.move(box.x + 60, box.y + 240, { steps: 3 });
      await until(async () => expect(await countColour(page, middle, 14, COLOURS.dark.select)).toBe(0));
    }),
  );

  it(
    'objects are selected, moved, resized and nudged by keys, as one step each, and Esc puts back',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      const placed = (id: string) =>
        [file('01').asteroids, file('01').minerals].flatMap((list) => list ?? []).find((one) => one.id === id);
      await canvas.fit(file('01'));
      // nothing is selected: the arrows are the crosshair's; else they nudge
      await page.keyboard.press('ArrowRight');
      await go(page, { x: 400, y: 200 });
      await hears(page, 'x 400, y 200, asteroid 1');
      await page.keyboard.press('Enter');
      await hears(page, 'Asteroid 1 is selected. x 400, y 200');
      await go(page, { x: 560, y: 480 });
      await hears(page, 'x 560, y 480, mineral 1');
      await page.keyboard.press('Shift+Enter');
      await hears(page, 'Mineral 1 is selected, 2 in all');
      await page.keyboard.press('d');
      await hears(page, 'Holding mineral 1, selected');
      await press(page, 'ArrowDown', 2);
      await page.keyboard.press('Control+ArrowDown');
      await hears(page, '2 objects moved');
      await page.keyboard.press('Escape');
      await hears(page, 'Put back. x 560, y 497');
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();
      await go(page, { x: 560, y: 480 });
      await page.keyboard.press('d');
      await press(page, 'ArrowDown', 2);
      await page.keyboard.press('Enter');
      await until(() =>
        expect([placed('a1'), placed('m1')]).toMatchObject([
          { x: 400, y: 216 },
          { x: 560, y: 496 },
        ]),
      );
      await page.keyboard.press('Control+z');
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();

      // Esc, and arrows nudge; Enter, and the crosshair is back
      await page.keyboard.press('Escape');
      await page.keyboard.press('ArrowLeft');
      await until(() =>
        expect([placed('a1'), placed('m1')]).toMatchObject([
          { x: 399, y: 200 },
          { x: 559, y: 480 },
        ]),
      );
      await page.keyboard.press('Control+z');
      await page.keyboard.press('Enter');
      await hears(page, /^x 560, y 496/);

      // the astronaut, who can't be added
      await go(page, { x: 200, y: 304 });
      await hears(page, 'x 200, y 304, astronaut');
      await page.keyboard.press('d');
      await press(page, 'ArrowUp', 1);
      await hears(page, 'Astronaut moved to x 200, y 296');
      await page.keyboard.press('d');
      await until(() => expect(file('01').astronaut).toMatchObject({ x: 200, y: 296 }));

      // a rim of what is selected
      await go(page, { x: 400, y: 200 });
      await page.keyboard.press('Enter');
      await go(page, { x: 432, y: 200 });
      await hears(page, 'rim of asteroid 1, selected');
      await page.keyboard.press('d');
      await press(page, 'ArrowRight', 2);
      await hears(page, 'Asteroid 1, radius 48');
      await page.keyboard.press('d');
      await until(() => expect(placed('a1')).toMatchObject({ x: 400, radius: 48 }));
    }),
  );

  it(
    'objects are selected in a rectangle, a held key is told when it is let go, and the crosshair waits while the focus is elsewhere',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      await page.keyboard.press('ArrowDown');
      // a rectangle from empty space
      await go(page, { x: 480, y: 96 });
      await page.keyboard.press('Enter');
      await hears(page, 'Nothing is selected');
      await page.keyboard.press('d');
      await hears(page, 'Selecting from x 480, y 96');
      await page.keyboard.down('Shift');
      // the key is held: it is told once it is let go
      for (let i = 0; i < 5; i++) await page.keyboard.down('ArrowRight');
      await hears(page, 'x 512, y 96, 0 selected');
      await page.keyboard.up('ArrowRight');
      await hears(page, 'x 768, y 96, 0 selected');
      await page.keyboard.press('ArrowDown');
      await page.keyboard.press('ArrowDown');
      await page.keyboard.press('ArrowDown');
      await page.keyboard.up('Shift');
      await hears(page, 'x 768, y 256, 2 selected');
      await page.keyboard.press('d');
      await hears(page, '2 objects are selected');
      await page.keyboard.press('Shift+D');
      await press(page, 'Shift+ArrowDown', 3);
      await press(page, 'Shift+ArrowLeft', 1);
      await hears(page, 'x 704, y 448, 3 selected');
      await page.keyboard.press('d');
      await hears(page, 'Alien 1 is selected, 3 in all');
      await page.keyboard.press('Delete');
      await until(() => expect([file('01').asteroids, file('01').aliens ?? []]).toMatchObject([[{ id: 'a1' }], []]));

      // away and back by Tab: the crosshair of a tool waits there
      await page.keyboard.press('m');
      await go(page, { x: 640, y: 320 });
      await page.keyboard.press('Shift+Tab');
      await until(async () => expect(await focused(page)).toBe(false));
      await page.keyboard.press('Tab');
      await hears(page, /^x 640, y 320/);

      // how all this goes is on the cheat sheet, and said of the canvas
      expect(await page.getByRole('application', { name: 'Level canvas' }).getAttribute('aria-description')).toMatch(
        /crosshair.*Enter/,
      );
      await page.keyboard.press('?');
      const sheet = page.getByRole('dialog', { name: 'Shortcuts and gestures' });
      await sheet.getByRole('heading', { name: 'Crosshair' }).waitFor();
      await sheet.getByText('Move the crosshair by the grid').waitFor();
    }),
  );
});
