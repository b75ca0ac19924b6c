import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { extentOf } from '../../editor/canvas/extent.ts';
import { fitBox } from '../../editor/canvas/view.ts';
import { boxOf } from '../../engine/index.ts';
import { DEFAULT_RULES, type LevelFile } from '../../schema/index.ts';
import { command, tool, verdict } from './commands.ts';
import { garden, straight } from './levels.ts';
import { countColour } from './screen-colours.ts';
import { inChromium, type Stage } from './stage.ts';
import { until } from './until.ts';

const A = { x: 400, y: 200 };
const B = { x: 560, y: 160 };
const C = { x: 720, y: 240 };

/** Waits until the file on the disk contains this. */
const onDisk = ({ file }: Pick<Stage, 'file'>, what: object) => until(() => expect(file('01')).toMatchObject(what));
const asteroids = (file: LevelFile) => (file.asteroids ?? []).map(({ x, y }) => ({ x, y }));

inChromium('the canvas in Chromium', ({ on }) => {
  it(
    'moves an object while the verdict follows, as one undo step that is written to the disk',
    on({ '01': straight() }, async ({ page, canvas, file, saved }) => {
      await verdict(page, 'completable');
      await canvas.fit(file('01'));
      // during the drag it is broken, completable and broken again, all before the button is released
      await canvas.drag(
        { x: 448, y: 304 },
        {
          to: [
            { x: 448, y: 200 },
            { x: 448, y: 304 },
            { x: 448, y: 200 },
          ],
          before: () => verdict(page, 'broken'),
        },
      );
      await onDisk({ file }, { asteroids: [{ id: 'rock', x: 448, y: 200 }] });
      await saved();
      await page.keyboard.press('Control+z');
      await verdict(page, 'completable');
      await onDisk({ file }, { asteroids: [{ id: 'rock', x: 448, y: 304 }] });
      await page.keyboard.press('Control+Shift+z');
      await verdict(page, 'broken');
      await onDisk({ file }, { asteroids: [{ id: 'rock', x: 448, y: 200 }] });
    }),
  );

  it(
    'places objects of every kind by dropping them from the toolbar, and by tool and click',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      const { x, y } = canvas.at({ x: 322, y: 102 });
      const box = await page.getByRole('application', { name: 'Level canvas' }).boundingBox();
      await tool(page, 'Asteroid').dragTo(page.getByRole('application', { name: 'Level canvas' }), {
        targetPosition: { x: x - (box?.x ?? 0), y: y - (box?.y ?? 0) },
      });
      await until(() => expect(asteroids(file('01'))).toContainEqual({ x: 320, y: 104 }));
      // the dropped object is selected
      await page.keyboard.press('ArrowRight');
      await until(() => expect(asteroids(file('01'))).toContainEqual({ x: 321, y: 104 }));

      const places: readonly (readonly [name: string, list: keyof LevelFile, x: number])[] = [
        ['Hot asteroid', 'asteroids', 400],
        ['Nova', 'novae', 480],
        ['Repulsor', 'repulsors', 560],
        ['Alien', 'aliens', 640],
        ['Mineral', 'minerals', 720],
      ];
      for (const [name, , at] of places) {
        await tool(page, name).click();
        await canvas.click({ x: at, y: 560 });
        // after one object, the tool is deselected
        await until(async () => expect(await tool(page, 'Select').getAttribute('aria-pressed')).toBe('true'));
      }
      for (const [, list, at] of places)
        await onDisk({ file }, { [list]: expect.arrayContaining([expect.objectContaining({ x: at, y: 560 })]) });
      expect(file('01').asteroids?.at(-1)).toMatchObject({ x: 400, hot: true });

      // with Shift the tool stays selected; a drag sets the radius; without the grid places are exact
      await page.keyboard.press('n');
      await canvas.click({ x: 240, y: 160 }, ['Shift']);
      await canvas.drag({ x: 240, y: 400 }, { to: [{ x: 240, y: 420 }] });
      await onDisk({ file }, { novae: expect.arrayContaining([expect.objectContaining({ x: 240, y: 400, radius: 20 })]) });
      for (let i = 0; i < 9; i++) await page.keyboard.press('Control+z');
      await onDisk({ file }, { asteroids: garden().asteroids as object, novae: [{ id: 'n1' }], minerals: [{ id: 'm1' }] });
    }),
  );

  it(
    'selects by click, Shift and marquee; nudges, duplicates and deletes the selection',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      await canvas.fit(file('01'));
      await canvas.click(A);
      await canvas.click(C, ['Shift']);
      // consecutive keys are one step
      for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowDown');
      await until(() => expect(asteroids(file('01'))).toEqual([{ x: 400, y: 203 }, B, { x: 720, y: 243 }]));
      await page.keyboard.press('Control+z');
      await until(() => expect(asteroids(file('01'))).toEqual([A, B, C]));
      await canvas.click(A, ['Shift']);
      await page.keyboard.press('Shift+ArrowLeft');
      await until(() => expect(asteroids(file('01'))).toEqual([A, B, { x: 712, y: 240 }]));

      await canvas.drag({ x: 340, y: 100 }, { to: [{ x: 620, y: 260 }] });
      await page.keyboard.press('Control+d');
      await until(() => expect(asteroids(file('01'))).toHaveLength(5));
      expect(asteroids(file('01')).slice(3)).toEqual([
        { x: 432, y: 232 },
        { x: 592, y: 192 },
      ]);
      await page.keyboard.press('Delete');
      await until(() => expect(asteroids(file('01'))).toHaveLength(3));

      await page.keyboard.press('Control+a');
      await page.keyboard.press('Delete');
      // the astronaut and the black hole stay, as every level needs them
      await onDisk({ file }, { astronaut: { x: 200, y: 304 }, blackHole: { x: 904, y: 304 } });
      await until(() => expect(asteroids(file('01'))).toEqual([]));
      // broken, until it is proved that nobody can complete it without an asteroid
      await verdict(page, 'impossible');
      await canvas.click({ x: 904, y: 304 });
      await page.keyboard.press('Delete');
      await page.getByText('they can be moved, not deleted').waitFor();

      for (let i = 0; i < 5; i++) await page.keyboard.press('Control+z');
      await saved();
      await until(() => expect(file('01')).toMatchObject(garden()));
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();
    }),
  );

  it(
    'copies with Alt, and with the clipboard as text that is part of a level',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      await canvas.drag(A, { to: [{ x: 400, y: 352 }], keys: ['Alt'] });
      await until(() => expect(asteroids(file('01'))).toHaveLength(4));
      expect(asteroids(file('01'))).toEqual(expect.arrayContaining([A, { x: 400, y: 352 }]));
      await page.keyboard.press('Control+z');
      await until(() => expect(asteroids(file('01'))).toEqual([A, B, C]));

      await canvas.click(A);
      await canvas.click({ x: 560, y: 480 }, ['Shift']);
      await page.keyboard.press('Control+c');
      // all tests of a worker have one clipboard
      await until(async () =>
        expect(JSON.parse(await page.evaluate(() => navigator.clipboard.readText()))).toEqual({
          asteroids: [{ x: 400, y: 200, radius: 32 }],
          minerals: [{ x: 560, y: 480 }],
        }),
      );
      await page.keyboard.press('Control+v');
      await until(() => expect(asteroids(file('01'))).toEqual([A, B, C, { x: 432, y: 232 }]));
      // the new objects are selected
      await page.keyboard.press('Control+x');
      await until(() => expect(asteroids(file('01'))).toEqual([A, B, C]));
      await page.evaluate(() => navigator.clipboard.writeText('a shopping list'));
      await page.keyboard.press('Control+v');
      await page.getByText('the clipboard contains no objects of a level').waitFor();
    }),
  );

  it(
    'changes a radius by dragging the rim, of all selected objects by the same factor',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      await canvas.click(A);
      await canvas.drag({ x: A.x + 32, y: A.y }, { to: [{ x: A.x + 48, y: A.y }] });
      await until(() => expect(file('01').asteroids?.map(({ radius }) => radius)).toEqual([48, 32, 16]));
      await canvas.click(C, ['Shift']);
      await canvas.drag({ x: A.x + 48, y: A.y }, { to: [{ x: A.x + 24, y: A.y }] });
      await until(() => expect(file('01').asteroids?.map(({ radius }) => radius)).toEqual([24, 32, 8]));
      await page.keyboard.press('Control+z');
      await until(() => expect(file('01').asteroids?.map(({ radius }) => radius)).toEqual([48, 32, 16]));
    }),
  );

  it(
    'snaps to the grid and with guides to other objects; with Ctrl not at all, and with Shift along an axis',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      const place = (id: string) => file('01').asteroids?.find((one) => one.id === id);
      await canvas.drag(C, { to: [{ x: 771, y: 371 }] });
      await until(() => expect(place('c1')).toMatchObject({ x: 768, y: 368 }));
      // close to where its centre is aligned with that of A
      const guides = () => countColour(page, canvas.at({ x: 400, y: 344 }), 20, COLOURS.dark.guide);
      expect(await guides()).toBe(0);
      await canvas.drag(
        { x: 768, y: 368 },
        { to: [{ x: 402, y: 347 }], before: () => until(async () => expect(await guides()).toBeGreaterThan(10)) },
      );
      await until(() => expect(place('c1')).toMatchObject({ x: 400, y: 344 }));
      await until(async () => expect(await guides()).toBe(0));
      await canvas.drag({ x: 400, y: 344 }, { to: [{ x: 463, y: 341 }], keys: ['Shift'] });
      await until(() => expect(place('c1')).toMatchObject({ x: 464, y: 344 }));
      await canvas.drag({ x: 464, y: 344 }, { to: [{ x: 467, y: 389 }], keys: ['Control'] });
      const free = await until(() => {
        const found = place('c1');
        expect(found?.y).toBeGreaterThan(380);
        return found;
      });
      expect(Math.abs((free?.x ?? 0) - 467)).toBeLessThan(1.5 / canvas.zoom());
      expect(Number.isInteger((free?.x ?? 0) / 8) && Number.isInteger((free?.y ?? 0) / 8)).toBe(false);
    }),
  );

  it(
    'aligns and distributes objects',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      await canvas.click(A);
      await canvas.click(B, ['Shift']);
      await canvas.click(C, ['Shift']);
      const after = async (title: string, expected: { x: number; y: number }[]) => {
        await command(page, title);
        await until(() => expect(asteroids(file('01'))).toEqual(expected));
        await page.keyboard.press('Control+z');
        await until(() => expect(asteroids(file('01'))).toEqual([A, B, C]));
      };
      await after('Align top edges', [{ x: 400, y: 160 }, B, { x: 720, y: 144 }]);
      await after('Align left edges', [A, { x: 400, y: 160 }, { x: 384, y: 240 }]);
      await after('Align vertical centres', [
        { x: 400, y: 192 },
        { x: 560, y: 192 },
        { x: 720, y: 192 },
      ]);
      await page.keyboard.press('Shift+ArrowRight');
      await canvas.click(B);
      await page.keyboard.press('Shift+ArrowRight');
      await page.keyboard.press('Shift+ArrowRight');
      await canvas.click({ x: 408, y: 200 }, ['Shift']);
      await canvas.click({ x: 728, y: 240 }, ['Shift']);
      await command(page, 'Distribute horizontally');
      await until(() => expect(asteroids(file('01')).map(({ x }) => x)).toEqual([408, 568, 728]));
    }),
  );

  it(
    'zooms to the pointer, pans and fits; Esc cancels a gesture',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      await canvas.fit(file('01'));
      const zoomShown = async () => Number.parseInt((await page.getByText(/^\d+ %$/).textContent()) ?? '', 10);
      const before = await zoomShown();
      const { x, y } = canvas.at(C);
      await page.mouse.move(x, y);
      await page.mouse.wheel(0, -400);
      await until(async () => expect(await zoomShown()).toBeGreaterThan(1.5 * before));
      // the same place is still under the pointer
      await page.mouse.click(x, y);
      await page.keyboard.press('ArrowUp');
      await until(() => expect(asteroids(file('01'))).toEqual([A, B, { x: 720, y: 239 }]));
      for (const button of ['middle', 'right'] as const) {
        await page.mouse.move(x, y);
        await page.mouse.down({ button });
        await page.mouse.move(x - 60, y + 50, { steps: 3 });
        await page.mouse.up({ button });
      }
      await page.mouse.click(x - 120, y + 100);
      await page.keyboard.press('ArrowUp');
      await until(() => expect(asteroids(file('01'))).toEqual([A, B, { x: 720, y: 238 }]));
      await page.keyboard.press('g');
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 120, y - 100, { steps: 3 });
      await page.mouse.up();
      await page.keyboard.press('v');
      await page.mouse.click(x, y);
      await page.keyboard.press('ArrowDown');
      await until(() => expect(asteroids(file('01'))).toEqual([A, B, { x: 720, y: 239 }]));
      await page.keyboard.press('ArrowDown');
      await until(() => expect(asteroids(file('01'))).toEqual([A, B, C]));
      await canvas.fit(file('01'));
      expect(await zoomShown()).toBe(before);
      // if the page gets smaller, the whole level stays in view, but a view that the user has chosen does not change
      const large = page.viewportSize() ?? { width: 0, height: 0 };
      await page.setViewportSize({ width: 960, height: 600 });
      await until(async () => {
        const box = await page.getByRole('application', { name: 'Level canvas' }).boundingBox();
        const view = { x: 0, y: 0, zoom: 1, width: box?.width ?? 0, height: box?.height ?? 0 };
        const { zoom } = fitBox(view, extentOf(file('01'), boxOf(DEFAULT_RULES)) ?? { left: 0, top: 0, right: 0, bottom: 0 });
        expect(zoom).toBeLessThan(0.9 * (before / 100));
        expect(await zoomShown()).toBe(Math.round(100 * zoom));
      });
      await page.keyboard.press('Control+0');
      await until(async () => expect(await zoomShown()).toBe(100));
      await page.setViewportSize(large);
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      expect(await zoomShown()).toBe(100);

      await canvas.fit(file('01'));
      await saved();
      const written = file('01');
      await canvas.drag(A, {
        to: [{ x: 500, y: 300 }],
        before: async () => {
          await page.keyboard.press('Escape');
        },
      });
      await page.getByRole('button', { name: /^Undo: Nudge/ }).waitFor();
      await saved();
      expect(file('01')).toEqual(written);
    }),
  );

  // so many that those that do not move are drawn together
  const crowd = Array.from({ length: 130 }, (_, i) => ({
    id: `m${i}`.padEnd(3, 'x'),
    x: 208 + 48 * (i % 10),
    y: 400 + 48 * Math.floor(i / 10),
    radius: 16,
  }));
  it(
    'shows many objects correctly, both the resting ones and the moving one',
    on({ '01': straight({ novae: [], minerals: crowd }) }, async ({ page, canvas, file }) => {
      const [from, near, to] = [crowd[44], crowd[45], { x: 696, y: 520 }];
      const seen = async () =>
        Promise.all(
          [from, near, to].map(async (place) => (await countColour(page, canvas.at(place), 8, COLOURS.dark.mineral)) > 10),
        );
      // the outline at the former place has the colour of minerals
      await command(page, 'Show or hide the run before and after a change');
      await canvas.fit(file('01'));
      await until(async () => expect(await seen()).toEqual([true, true, false]));
      const moved = () => until(async () => expect(await seen()).toEqual([false, true, true]));
      await canvas.drag(from, { to: [to], before: moved });
      // a selected object has an outline, which would hide it in the comparison
      await canvas.click({ x: 696, y: 640 });
      await moved();
      await page.keyboard.press('Control+z');
      await until(async () => expect(await seen()).toEqual([true, true, false]));
      // zoom in and out
      await page.keyboard.press('+');
      await canvas.fit(file('01'));
      await until(async () => expect(await seen()).toEqual([true, true, false]));
    }),
  );

  it(
    'undoes without limit',
    on({ '01': garden() }, async ({ page, canvas, file, text, saved }) => {
      await saved();
      const before = text('01');
      await canvas.fit(file('01'));
      await canvas.click({ x: 560, y: 480 });
      for (let i = 0; i < 5; i++) await page.keyboard.press('Control+d');
      await until(() => expect(file('01').minerals).toHaveLength(6));
      for (let i = 0; i < 5; i++) await page.keyboard.press('Control+z');
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();
      await until(() => expect(file('01').minerals).toHaveLength(1));
      for (let i = 0; i < 5; i++) await page.keyboard.press('Control+y');
      await until(() => expect(file('01').minerals).toHaveLength(6));
      for (let i = 0; i < 5; i++) await page.keyboard.press('Control+z');
      await until(() => expect(JSON.parse(text('01'))).toEqual(JSON.parse(before)));
    }),
  );
});
