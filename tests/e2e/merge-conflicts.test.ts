import { expect, it } from 'vitest';
import { withConflicts } from '../../review/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { verdict } from './commands.ts';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('a level in which a merge left conflicts, in Chromium', ({ on }) => {
  const level = straight() as unknown as LevelFile;
  const marked = withConflicts({
    file: level,
    conflicts: [
      { key: 'name', what: 'name', base: 'before', mine: level.name, theirs: 'Their name' },
      { key: 'blackHole/radius', what: 'black hole, radius', base: undefined, mine: undefined, theirs: 20 },
    ],
  });

  it(
    'asks on opening, writes the choices, and can be undone',
    on({ '01': straight(), '02': marked }, async ({ page, file }) => {
      const dialog = page.getByRole('dialog', { name: 'A merge left conflicts in this level' });
      await page.getByRole('tree', { name: 'Levels' }).getByRole('treeitem').nth(1).click();
      await dialog.waitFor();
      // decided later: nothing is lost, and the page says so
      await dialog.getByRole('button', { name: 'Later' }).click();
      await page.getByRole('status', { name: 'Verdict: invalid' }).waitFor();
      await page.getByRole('list', { name: 'Problems' }).getByText('"name" is undecided after a merge').waitFor();
      expect(file('02').conflicts).toHaveLength(2);
      await page.getByRole('button', { name: 'Resolve' }).click();
      const name = dialog.getByRole('group', { name: 'name' });
      await name.getByRole('radio', { name: /theirs/ }).check();
      await dialog.getByRole('button', { name: 'Merge' }).click();
      await page.getByRole('heading', { level: 1, name: 'Their name' }).waitFor();
      await verdict(page, 'completable');
      await until(() => expect(file('02')).toEqual({ ...level, name: 'Their name' }));
      await page.keyboard.press('Control+z');
      await until(() => expect(file('02')).toEqual(marked));
    }),
  );
});
