import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { gq } from '../cli/gq.ts';
import { command, verdict } from './commands.ts';
import { nextFrames } from './frames.ts';
import { garden, near, straight } from './levels.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const levels = (page: Page) => page.getByRole('tree', { name: 'Levels' });
/** The row of a level by its name, possibly with a number before it and its verdict after it. */
const level = (page: Page, name: string) => levels(page).getByRole('treeitem', { name: new RegExp(`^(\\d+ )?${name} `) });
/** Presses a key on a row of a list: the list has the focus, and one of its rows is active. */
async function press(list: Locator, row: Locator, key: string): Promise<void> {
  await row.click();
  await list.focus();
  await list.page().keyboard.press(key);
}
const isOpen = (page: Page, name: string) => page.getByRole('heading', { level: 1, name, exact: true }).waitFor();
const objects = (page: Page) => page.getByRole('tree', { name: 'Objects of the level' });
const tab = (page: Page, name: string) => page.getByRole('tab', { name, exact: true }).click();
const levelFiles = (folder: string) =>
  readdirSync(folder)
    .filter((name) => name.endsWith('.level.json'))
    .sort();

inChromium('panels in Chromium', ({ on }) => {
  it(
    'lists levels with pictures and verdicts; opens, copies, renames, duplicates, reorders, deletes and restores them',
    on(
      { '01': straight(), '02': garden() },
      async ({ page, canvas, file, folder, saved }) => {
        await isOpen(page, 'Straight');
        await until(async () => expect(await levels(page).locator('img').count()).toBe(2));
        await level(page, 'Straight')
          .getByText('completable')
          .or(level(page, 'Straight').getByRole('img', { name: 'completable' }))
          .first()
          .waitFor();

        await canvas.fit(file('01'));
        await canvas.click({ x: 448, y: 304 });
        await page.keyboard.press('Control+c');
        await level(page, 'Garden').click();
        await isOpen(page, 'Garden');
        await page.getByRole('application', { name: 'Level canvas' }).focus();
        await page.keyboard.press('Control+v');
        await until(() => expect(file('02').asteroids).toHaveLength(4));
        await saved();

        await press(levels(page), level(page, 'Garden'), 'F2');
        const rename = page.getByRole('dialog', { name: 'Rename' });
        await rename.getByLabel('Level name').fill('Park');
        await rename.getByLabel('File name').fill('03-park');
        await page.keyboard.press('Enter');
        await isOpen(page, 'Park');
        await until(() => expect(levelFiles(folder)).toEqual(['01.level.json', '03-park.level.json']));
        await until(() => expect(file('03-park').name).toBe('Park'));

        await press(levels(page), level(page, 'Park'), 'Control+d');
        await until(() => expect(levelFiles(folder)).toHaveLength(3));
        await level(page, 'Straight').click();
        await isOpen(page, 'Straight');
        await press(levels(page), level(page, 'Straight'), 'Alt+ArrowDown');
        await until(async () => {
          const names = await levels(page).getByRole('treeitem').allTextContents();
          expect(names[0]).not.toContain('Straight');
        });
        await isOpen(page, 'Straight');
        // its file has another number by now, and the list knows it
        const idOf = (name: string) =>
          levelFiles(folder)
            .map((one) => one.replace('.level.json', ''))
            .find((id) => file(id).name === name) ?? '?';
        await until(async () => {
          expect(idOf('Straight')).not.toBe('01');
          expect(await level(page, 'Straight').textContent()).toContain(idOf('Straight').slice(0, 2));
        });

        await press(levels(page), level(page, 'Straight'), 'Delete');
        await until(() => expect(levelFiles(folder)).toHaveLength(2));
        await page.getByRole('heading', { level: 1, name: 'Straight', exact: true }).waitFor({ state: 'hidden' });
        await page.getByRole('button', { name: 'Deleted levels' }).click();
        await page.getByRole('dialog', { name: 'Deleted levels' }).getByRole('button', { name: 'Restore' }).first().click();
        await isOpen(page, 'Straight');
        expect(levelFiles(folder)).toHaveLength(3);
      },
      { complaints: /Failed to load resource/ },
    ),
  );

  it(
    'makes new levels from templates, the random one from its seed',
    on({ '01': straight() }, async ({ page, folder }) => {
      await isOpen(page, 'Straight');
      await page.keyboard.press('Alt+n');
      const dialog = page.getByRole('dialog', { name: 'New level' });
      await dialog.getByText('Random', { exact: true }).click();
      await dialog.getByRole('textbox', { name: 'Seed' }).fill('7');
      await dialog.getByLabel('Level name').fill('Dice');
      await dialog.getByLabel('File name').fill('dice');
      await dialog.getByRole('button', { name: 'Create' }).click();
      await isOpen(page, 'Dice');
      expect(levelFiles(folder)).toContain('dice.level.json');
      const { code } = await gq(['fmt', '--check', join(folder, 'dice.level.json')]);
      expect(code).toBe(0);
      await page.keyboard.press('Alt+n');
      await dialog.getByText('A first swing').click();
      await dialog.getByRole('button', { name: 'Create' }).click();
      await dialog.waitFor({ state: 'hidden' });
      await until(() => expect(levelFiles(folder)).toHaveLength(3));
    }),
  );

  it(
    'the outline follows the canvas, the inspector accepts numbers and sums within limits, and undo reverts each change',
    on({ '01': garden() }, async ({ page, file }) => {
      await tab(page, 'Outline');
      await objects(page)
        .getByRole('treeitem', { name: /^Asteroid 2/ })
        .click();
      const x = page.getByRole('textbox', { name: 'x', exact: true });
      await until(async () => expect(await x.inputValue()).toBe('560'));
      await x.fill('600+16');
      await page.keyboard.press('Enter');
      await until(() => expect(file('01').asteroids?.[1]).toMatchObject({ x: 616, y: 160 }));
      await objects(page)
        .getByRole('treeitem', { name: /^Asteroid 2.* at 616, 160/ })
        .waitFor();
      const radius = page.getByRole('textbox', { name: 'radius' });
      await radius.fill('wide');
      await page.getByRole('alert').getByText('expected a number, found "wide"').waitFor();
      await page.keyboard.press('Escape');
      await radius.press('ArrowUp');
      await until(() => expect(file('01').asteroids?.[1]).toMatchObject({ radius: 33 }));
      await page.getByRole('radio', { name: 'hot' }).check({ force: true });
      await until(() => expect(file('01').asteroids?.[1]).toMatchObject({ hot: true }));
      await objects(page)
        .getByRole('treeitem', { name: /^Hot asteroid 2/ })
        .waitFor();
      await objects(page)
        .getByRole('treeitem', { name: /^Asteroid 1/ })
        .click({ modifiers: ['Control'] });
      await page.getByRole('heading', { name: '2 objects' }).waitFor();
      await until(async () => expect(await x.getAttribute('placeholder')).toBe('mixed'));
      await page.getByRole('toolbar', { name: 'Arrange' }).getByRole('button', { name: 'Align top edges' }).click();
      await until(() => expect(file('01').asteroids?.map(({ y }) => y)).not.toEqual([200, 160, 240]));
      for (let i = 0; i < 4; i++) await page.getByRole('button', { name: /^Undo/ }).click();
      await until(() => expect(file('01')).toMatchObject(garden()));
    }),
  );

  it(
    'an object under the pointer is highlighted both on the canvas and in the outline',
    on(
      { '01': garden() },
      async ({ page, canvas, file }) => {
        await canvas.fit(file('01'));
        const row = objects(page).getByRole('treeitem', { name: /^Asteroid 2/ });
        const { x, y } = canvas.at({ x: 560, y: 160 });
        await page.mouse.move(x, y);
        await until(async () => expect(await row.getAttribute('class')).toContain('hovered'));
        await page.mouse.move(x, y + 100);
        await until(async () => expect(await row.getAttribute('class')).not.toContain('hovered'));
        const outline = () => countColour(page, { x, y }, 60, COLOURS.dark.select);
        await nextFrames(page);
        const bare = await outline();
        await row.hover();
        await until(async () => expect(await outline()).toBeGreaterThan(bare + 50));
        await page.getByRole('heading', { level: 1 }).hover();
        await until(async () => expect(await outline()).toBe(bare));
      },
      { context: { colorScheme: 'dark' } },
    ),
  );

  it(
    'runs can be added, named, reordered and deleted; a problem links to its place',
    on({ '01': straight({ minerals: [{ id: 'gem', x: 320, y: 600 }] }) }, async ({ page, file }) => {
      await tab(page, 'Runs');
      const runs = page.getByRole('tree', { name: 'Runs of the level' });
      const names = () => file('01').runs?.map(({ name }) => name);
      await press(runs, runs.getByRole('treeitem').first(), 'Control+d');
      await until(() => expect(names()).toHaveLength(2));
      await press(runs, runs.getByRole('treeitem').nth(1), 'F2');
      await page.getByRole('textbox', { name: 'Run name' }).fill('spare');
      await page.keyboard.press('Enter');
      await until(() => expect(names()).toEqual(['solution', 'spare']));
      await press(runs, runs.getByRole('treeitem', { name: /^spare/ }), 'Alt+ArrowUp');
      await until(() => expect(names()).toEqual(['spare', 'solution']));
      await press(runs, runs.getByRole('treeitem', { name: /^spare/ }), 'Delete');
      await until(() => expect(names()).toEqual(['solution']));
      await page.getByRole('combobox', { name: 'Run' }).waitFor();

      await page.getByRole('button', { name: /^Hold 1:/ }).click();
      await page.keyboard.press('Delete');
      await verdict(page, 'broken');
      await page.getByRole('list', { name: 'Problems' }).getByRole('listitem').first().waitFor();
    }),
  );

  it(
    'a problem calls an object by the name that it was given; the menu of the open level leads to its history',
    on(
      {
        '01': garden({
          novae: [
            { id: 'n1', x: 400, y: 440, radius: 32, 'x-name': 'Gate' },
            { id: 'n2', x: 408, y: 440, radius: 32, 'x-name': 'Door' },
          ],
        }),
      },
      async ({ page }) => {
        await page
          .getByRole('list', { name: 'Problems' })
          .getByRole('button', { name: /^Go to “(Gate|Door)”$/ })
          .first()
          .waitFor();
        await level(page, 'Garden').locator('.tree__more').click();
        await page.getByRole('menuitem', { name: 'History' }).click();
        await page.getByRole('dialog', { name: 'History', exact: true }).waitFor();
      },
    ),
  );

  it(
    'the solver finds a run, and shows its robustness and the difficulty of the level',
    // she arrives within seconds, so that little is to be measured
    on({ '01': near({ runs: undefined }) }, async ({ page, file, folder, saved }) => {
      await verdict(page, 'unproven');
      await tab(page, 'Solver');
      await page.getByRole('tabpanel', { name: 'Solver' }).getByRole('button', { name: 'Solve', exact: true }).click();
      await page.getByRole('list', { name: 'Runs found' }).getByRole('button', { name: 'Add' }).first().click();
      await verdict(page, 'completable');
      await saved();
      expect((await gq(['check', join(folder, '01.level.json')])).code).toBe(0);
      expect(file('01').runs).toHaveLength(1);
      // the search may end by itself at any moment, so it is left to do so
      await page.getByRole('button', { name: 'Cancel', exact: true }).waitFor({ state: 'hidden' });
      await page.getByRole('table').waitFor();
      await page
        .getByText(/certified/i)
        .first()
        .waitFor();
      await page.getByLabel('Show the search heat map').check();
      await command(page, 'Measure the difficulty');
      await page.getByRole('meter', { name: 'Grade' }).waitFor();
    }),
  );

  it(
    'a found run under the pressed button stays in place if the search ends before the release',
    on({ '01': garden({ runs: undefined }) }, async ({ page }) => {
      await tab(page, 'Solver');
      const solver = page.getByRole('tabpanel', { name: 'Solver' });
      // a search without a time limit
      await solver.getByRole('radio', { name: 'quickest' }).click();
      await solver.getByRole('textbox', { name: 'Seconds' }).fill('3600');
      await solver.getByRole('button', { name: 'Solve', exact: true }).click();
      const use = solver.getByRole('list', { name: 'Runs found' }).getByRole('button', { name: 'Add' }).first();
      await use.hover();
      await page.mouse.down();
      const cancel = solver.getByRole('button', { name: 'Cancel', exact: true });
      await cancel.dispatchEvent('click');
      await cancel.waitFor({ state: 'hidden' });
      await page.mouse.up();
      await verdict(page, 'completable');
    }),
  );

  it(
    'the costs of each accuracy and each effect in this level are shown',
    on({ '01': straight() }, async ({ page }) => {
      await tab(page, 'Accuracy');
      const choices = page.getByRole('radiogroup', { name: 'Accuracy' });
      await until(async () => expect(await choices.getByRole('radio').count()).toBe(4));
      await choices.getByRole('radio', { name: /arcade/ }).click();
      await page
        .getByRole('contentinfo')
        .getByText(/^arcade: /)
        .waitFor();
      await page
        .getByRole('contentinfo')
        .getByText(/^precise would differ by [\d.]+ px, same verdict$/)
        .waitFor();
      await choices.getByRole('radio', { name: /precise/ }).click();
      await page.getByRole('button', { name: 'Measure' }).click();
      await page.getByRole('button', { name: 'Measure again' }).waitFor();
      await page.getByRole('button', { name: /Enlarge/ }).click();
      await page.getByRole('dialog', { name: 'What accuracy costs' }).waitFor();
      await page.getByRole('button', { name: 'Close' }).click();
      await page.getByRole('dialog').waitFor({ state: 'hidden' });
      // Esc closes only the picture
      await tab(page, 'Outline');
      const rock = objects(page).getByRole('treeitem', { name: /^Asteroid 1/ });
      await rock.click();
      await page.getByRole('button', { name: /Enlarge/ }).click();
      await page.getByRole('dialog').getByRole('listbox', { name: 'Points of the diagram' }).click();
      await page.keyboard.press('Escape');
      await page.getByRole('dialog').waitFor({ state: 'hidden' });
      expect(await rock.getAttribute('aria-selected')).toBe('true');
      // all accuracies at once, and a slider from the coarsest to the finest
      await tab(page, 'Accuracy');
      await page.getByRole('button', { name: 'All at once' }).click();
      await page.getByRole('list', { name: 'Compared runs' }).getByRole('listitem').nth(2).waitFor();
      const told = page.getByRole('status', { name: 'What this accuracy changes' });
      await told.getByText(/^arcade reaches the black hole at .* precise, in use, reaches the black hole/).waitFor();
      await page.getByRole('slider', { name: 'Accuracy to compare with' }).press('ArrowRight');
      await told.getByText(/^fast .* They are never more than 1 px apart while both last\./).waitFor();
      const wide = page.viewportSize() ?? { width: 1280, height: 800 };
      await page.setViewportSize({ width: 390, height: 844 });
      await page.getByRole('navigation', { name: 'Panels' }).getByRole('button', { name: 'Accuracy' }).click();
      const lens = [page.getByRole('slider', { name: 'Accuracy to compare with' }), told];
      await until(async () => {
        for (const part of lens) {
          const { x, width } = (await part.boundingBox()) ?? { x: -1, width: 0 };
          expect([x >= 0, x + width <= 390, width > 200]).toEqual([true, true, true]);
        }
      });
      await told.getByText(/^fast /).waitFor();
      await page.setViewportSize(wide);
      await page.getByRole('button', { name: 'All at once' }).click();
      await page.getByRole('list', { name: 'Compared runs' }).waitFor({ state: 'hidden' });
      await tab(page, 'Effects');
      await page.getByRole('list', { name: 'Simulated effects' }).waitFor();
      await page.getByRole('list', { name: 'Effects that are not simulated' }).getByRole('listitem').first().waitFor();
      await page.getByRole('button', { name: 'Measure time' }).click();
      const hole = page.getByRole('list', { name: 'Simulated effects' }).getByRole('listitem').filter({ hasText: 'black-hole' });
      await hole.getByText(/^[\d.]+ % of the time: [\d.]+ of [\d.]+ µs per simulated second$/).waitFor();
    }),
  );

  it(
    'imports and exports text, pictures, original levels and links',
    on({ '01': straight() }, async ({ page, text, folder, saved }) => {
      await saved();
      await page.getByRole('button', { name: 'Import, export, link' }).click();
      const dialog = page.getByRole('dialog', { name: 'Import, export, link' });
      await dialog.getByRole('button', { name: 'Copy as text' }).click();
      await until(async () =>
        expect(JSON.parse(await page.evaluate(() => navigator.clipboard.readText()))).toEqual(JSON.parse(text('01'))),
      );
      await dialog.getByRole('img', { name: 'Preview of the exported level' }).waitFor();
      await dialog.getByRole('tab', { name: 'Link' }).click();
      const link = await until(async () => {
        const found = await dialog.getByRole('textbox', { name: 'Link with the level' }).inputValue();
        expect(found).toMatch(/#.{50}/);
        return found;
      });
      expect(link.length).toBeLessThan(2000);
      await dialog.getByRole('tab', { name: 'Import' }).click();
      const original = {
        player: { x: 100, y: 100 },
        target: { x: 300, y: 100, radius: 20 },
        asteroids: [{ x: 200, y: 120, radius: '16', enemy: false }],
      };
      await dialog.getByRole('textbox', { name: 'Or paste their text' }).fill(JSON.stringify([original]));
      await dialog.getByRole('button', { name: 'Import text' }).click();
      await until(() => expect(levelFiles(folder)).toHaveLength(2));
      expect(existsSync(join(folder, '01.level.json'))).toBe(true);
    }),
  );

  it(
    'downloads the level and its picture, as SVG and PNG',
    on({ '01': straight() }, async ({ page, text, saved }) => {
      await saved();
      await page.getByRole('button', { name: 'Import, export, link' }).click();
      const dialog = page.getByRole('dialog', { name: 'Import, export, link' });
      const download = async (name: string): Promise<[name: string, content: Buffer]> => {
        const [found] = await Promise.all([
          page.waitForEvent('download'),
          dialog.getByRole('button', { name, exact: true }).click(),
        ]);
        return [found.suggestedFilename(), readFileSync(await found.path())];
      };
      const [level, asText] = await download('01.level.json');
      expect(level).toBe('01.level.json');
      expect(JSON.parse(asText.toString())).toEqual(JSON.parse(text('01')));
      await dialog.getByRole('textbox', { name: 'Width' }).fill('640');
      await page.keyboard.press('Enter');
      const [svg, lines] = await download('SVG');
      expect(svg).toBe('01.svg');
      expect(lines.toString()).toMatch(/^<svg[^>]* width="640"/);
      const [png, pixels] = await download('PNG');
      expect(png).toBe('01.png');
      expect(pixels.subarray(0, 8).toString('latin1')).toBe('\x89PNG\r\n\x1a\n');
      expect(pixels.readUInt32BE(16)).toBe(640);
      // the picture is not empty: a single colour would take a few hundred bytes
      expect(pixels.length).toBeGreaterThan(5000);
    }),
  );
});
