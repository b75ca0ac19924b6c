import { join } from 'node:path';
import { expect, it } from 'vitest';
import { gq } from '../cli/gq.ts';
import { verdict } from './commands.ts';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';

inChromium('the verdict in Chromium', ({ on }) => {
  it(
    'a black hole out of reach makes the level impossible, as in gq check, and undo reverts that',
    on(
      { '01': straight(), '02': straight({ name: 'Far', blackHole: { x: 9999, y: 304 } }) },
      async ({ page, canvas, file, folder, saved }) => {
        await verdict(page, 'completable');
        const levels = page.getByRole('tree', { name: 'Levels' });
        await levels.getByRole('treeitem', { name: /Far/ }).getByText('impossible').waitFor();
        await canvas.fit(file('01'));
        await page
          .getByRole('tree', { name: 'Objects of the level' })
          .getByRole('treeitem', { name: /^Black hole/ })
          .click();
        await page.getByRole('textbox', { name: 'x', exact: true }).fill('9999');
        await page.keyboard.press('Enter');
        await verdict(page, 'impossible');
        await levels
          .getByRole('treeitem', { name: /Straight/ })
          .getByText('impossible')
          .waitFor();
        await page
          .getByRole('list', { name: 'Problems' })
          .getByText(/nobody can complete this level: the black hole is/)
          .waitFor();
        await saved();
        const check = await gq(['check', join(folder, '01.level.json'), '--format', 'json']);
        expect([check.code, JSON.parse(check.stdout).levels[0].verdict]).toEqual([1, 'impossible']);
        await page.keyboard.press('Escape');
        await page.getByRole('button', { name: /^Undo/ }).click();
        await verdict(page, 'completable');
      },
    ),
  );
});
