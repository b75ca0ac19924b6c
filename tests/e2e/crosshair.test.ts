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

/** The place of the crosshair, as announced. */
async function placeOf(page: Page): Promise<Place> {
  await hears(page, /x -?[\d.]+, y -?[\d.]+/);
  const [, x, y] = /x (-?[\d.]+), y (-?[\d.]+)/.exec((await said(page).textContent()) ?? '') ?? [];
  return { x: Number(x), y: Number(y) };
}

/** The end of a stride: the next grid line in that direction, or one px. */
function onward(from: number, way: number, size: number): number {
  if (size === 1) return from + way;
  return way > 0 ? (Math.floor(from / size) + 1) * size : (Math.ceil(from / size) - 1) * size;
}

/** Moves the crosshair by arrow keys: first in strides of 8 lines of the 8 px grid, then of one line, then px by px. */
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

/** Presses an arrow key several times. */
async function press(page: Page, arrow: string, times: number): Promise<void> {
  for (let i = 0; i < times; i++) await page.keyboard.press(arrow);
}

const focused = (page: Page) =>
  page.getByRole('application', { name: 'Level canvas' }).evaluate((e) => e === document.activeElement);
const last = (file: LevelFile, list: 'asteroids' | 'novae' | 'repulsors' | 'aliens' | 'minerals') => file[list]?.at(-1);

inChromium('the crosshair in Chromium', ({ on }) => {
  it(
    'every tool works by the keyboard alone, and its result is announced',
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
        // a place of the long strides
        const to = { x: 320 + 64 * i, y: 320 };
        await go(page, to);
        await hears(page, `x ${to.x}, y ${to.y}, empty`);
        await page.keyboard.press('Enter');
        await hears(page, `${name} added at x ${to.x}, y ${to.y}`);
        await until(() => expect(last(file('01'), list)).toMatchObject(to));
      }
      expect(last(file('01'), 'asteroids')).toMatchObject({ hot: true });

      // with Shift the tool stays selected; arrows with a held key set the radius
      await page.keyboard.press('n');
      await go(page, { x: 320, y: 512 });
      await page.keyboard.press('Shift+Enter');
      await hears(page, 'Nova 3 added');
      await go(page, { x: 640, y: 576 });
      await page.keyboard.press('d');
      await press(page, 'ArrowRight', 3);
      await hears(page, 'Nova 4 added at x 640, y 576, radius 24');
      await page.keyboard.press('d');
      await until(() => expect(last(file('01'), 'novae')).toMatchObject({ x: 640, y: 576, radius: 24 }));
    }),
  );

  it(
    'names a locked object that it passes by',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      await canvas.click({ x: 400, y: 200 });
      await page.keyboard.press('Control+Shift+L');
      await until(() => expect(file('01').asteroids?.[0]).toMatchObject({ 'x-locked': true }));
      await page.keyboard.press('Escape');
      await page.keyboard.press('v');
      await page.keyboard.press('ArrowRight');
      await go(page, { x: 400, y: 200 });
      await hears(page, 'x 400, y 200, asteroid 1, locked');
    }),
  );

  it(
    'a button selects a tool, the view follows the crosshair, and Esc and the pointer hide it',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      // a tool's button shows the crosshair as well, and the view follows it
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

      // Esc hides both; using the pointer hides the crosshair, too
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
    'keys select, move, resize and nudge objects, as one step each, and Esc cancels',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      const placed = (id: string) =>
        [file('01').asteroids, file('01').minerals].flatMap((list) => list ?? []).find((one) => one.id === id);
      await canvas.fit(file('01'));
      // without a selection, arrows move the crosshair; otherwise they nudge
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

      // after Esc, arrows nudge; Enter brings the crosshair back
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

      // the astronaut, who can't be added to the level
      await go(page, { x: 200, y: 304 });
      await hears(page, 'x 200, y 304, astronaut');
      await page.keyboard.press('d');
      await press(page, 'ArrowUp', 1);
      await hears(page, 'Astronaut moved to x 200, y 296');
      await page.keyboard.press('d');
      await until(() => expect(file('01').astronaut).toMatchObject({ x: 200, y: 296 }));

      // a rim of the selection
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
    'a rectangle selects objects, a held key is announced on release, and the crosshair waits while the focus is elsewhere',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      await page.keyboard.press('ArrowDown');
      // a rectangle that begins in empty space
      await go(page, { x: 480, y: 96 });
      await page.keyboard.press('Enter');
      await hears(page, 'Nothing is selected');
      await page.keyboard.press('d');
      await hears(page, 'Selecting from x 480, y 96');
      await page.keyboard.down('Shift');
      // a held key is announced on release
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

      // away and back by Tab: the crosshair of a tool stays there
      await page.keyboard.press('m');
      await go(page, { x: 640, y: 320 });
      await page.keyboard.press('Shift+Tab');
      await until(async () => expect(await focused(page)).toBe(false));
      await page.keyboard.press('Tab');
      await hears(page, /^x 640, y 320/);

      // the cheat sheet and the description of the canvas explain all this
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
