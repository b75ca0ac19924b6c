import { expect, it } from 'vitest';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const rock = { x: 448, y: 304, radius: 16 };

inChromium('words in Chromium', ({ on }) => {
  it(
    'objects have the same names everywhere, a copy gets its own name and number, and file names have no umlauts',
    on(
      {
        '01-start': straight({
          asteroids: [
            { id: 'rock', ...rock },
            { id: 'fire', ...rock, hot: true },
          ],
        }),
        '02-end': straight({ name: 'End', asteroids: [{ id: 'rock', ...rock, radius: 'big' }] }),
      },
      async ({ page, canvas, file }) => {
        await canvas.fit(file('01-start'));
        const problems = page.getByRole('list', { name: 'Problems' });
        await problems.getByText('asteroid 2 has the same centre as asteroid 1').waitFor();
        expect(await problems.textContent()).not.toMatch(/\w\[\d+\]/);
        const tree = page.getByRole('tree', { name: 'Levels' });
        await tree.getByText('asteroid 1, radius: expected a number').first().waitFor();

        await page
          .getByRole('tree', { name: 'Objects of the level' })
          .getByRole('treeitem', { name: /Hot asteroid 2/ })
          .click();
        const inspector = page.getByRole('tabpanel', { name: 'Inspector' });
        await inspector.getByText('Kills on touch').waitFor();

        await tree.getByRole('treeitem', { name: 'Straight' }).click({ button: 'right' });
        await page.getByRole('menuitem', { name: 'Duplicate' }).click();
        await tree.getByRole('treeitem', { name: 'Straight copy' }).waitFor();
        await page.getByRole('heading', { name: 'Straight copy' }).waitFor();
        await until(() => expect(file('03-start-copy')).toMatchObject({ ...file('01-start'), name: 'Straight copy' }));
        await tree.getByRole('treeitem', { name: 'Straight copy' }).getByText('03', { exact: true }).waitFor();

        await page.keyboard.press('Alt+n');
        const dialog = page.getByRole('dialog', { name: 'New level' });
        await dialog.getByLabel('Level name').fill('Böse Größe');
        expect(await dialog.getByLabel('File name').inputValue()).toBe('04-boese-groesse');
        await dialog.getByLabel('Level name').fill('Старт');
        expect(await dialog.getByLabel('File name').inputValue()).toBe('04-level');
      },
    ),
  );
});
