import { expect, it } from 'vitest';
import { verdict } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('undo for the list of levels in Chromium', ({ on }) => {
  it(
    'a new order and a deletion are undone and redone in sequence with changes of levels',
    on(
      { '01-straight': straight(), '02-garden': garden(), '03-park': garden({ name: 'Park' }) },
      async ({ page, file, canvas }) => {
        const levels = page.getByRole('tree', { name: 'Levels' });
        const order = (...names: string[]) =>
          until(async () => {
            const rows = await levels.getByRole('treeitem').allTextContents();
            expect(rows.map((row) => names.find((name) => row.includes(name)))).toEqual(names);
          });
        const undo = (what: string) => page.getByRole('button', { name: `Undo: ${what}` }).waitFor();
        await verdict(page, 'completable');

        // a rename, then a new order, then a change of the level
        const name = page.getByRole('textbox', { name: 'name', exact: true });
        await name.fill('Plain');
        await until(() => expect(file('01-straight').name).toBe('Plain'));
        await levels.focus();
        await page.keyboard.press('Alt+ArrowDown');
        await order('Garden', 'Plain', 'Park');
        await until(() => expect(file('02-straight').name).toBe('Plain'));
        await undo('Reorder levels');
        await canvas.fit(file('02-straight'));
        await canvas.drag({ x: 448, y: 304 }, { to: [{ x: 448, y: 344 }] });
        await until(() => expect(file('02-straight').asteroids?.[0]).toMatchObject({ y: 344 }));

        await page.keyboard.press('Control+z');
        await until(() => expect(file('02-straight').asteroids?.[0]).toMatchObject({ y: 304 }));
        await order('Garden', 'Plain', 'Park');
        await undo('Reorder levels');
        await page.keyboard.press('Control+z');
        await order('Plain', 'Garden', 'Park');
        await until(() => expect(file('01-straight').name).toBe('Plain'));
        await page.keyboard.press('Control+z');
        await until(() => expect(file('01-straight').name).toBe('Straight'));

        // redo everything
        for (let i = 0; i < 3; i++) await page.keyboard.press('Control+Shift+z');
        await order('Garden', 'Plain', 'Park');
        await until(() => expect(file('02-straight').asteroids?.[0]).toMatchObject({ y: 344 }));

        // the deleted level is restored, and the open level is not affected
        await levels.focus();
        await page.keyboard.press('Delete');
        await order('Garden', 'Park');
        await undo('Delete "Plain"');
        await page.getByRole('heading', { name: 'Park', level: 1 }).waitFor();
        await page.keyboard.press('Control+z');
        await order('Garden', 'Plain', 'Park');
        await page.getByRole('heading', { name: 'Plain', level: 1 }).waitFor();
        expect(file('02-straight').asteroids?.[0]).toMatchObject({ y: 344 });
      },
      // a thumbnail may still be requested by the previous name
      { complaints: /404/ },
    ),
  );
});
