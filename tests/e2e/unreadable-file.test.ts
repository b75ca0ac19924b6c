import { writeFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { verdict } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const TYPO = '{\n  "version": 1\n  "name": "Typo"\n}\n';

inChromium('a file that another program made unreadable, in Chromium', ({ on }) => {
  it(
    'is reported everywhere with its place, the last valid state stays editable, and saving continues once it is fixed',
    on({ '01': straight(), '02': garden() }, async ({ page, canvas, file, write, text, saved }) => {
      await canvas.fit(file('01'));
      await saved();
      const good = file('01');
      const saving = page.getByRole('status', { name: 'Saving' });
      const row = page.getByRole('tree', { name: 'Levels' }).getByRole('treeitem').first();
      const problems = page.getByRole('list', { name: 'Problems' });
      const place = /01\.level\.json:3:3: expected "," or "}", found "name".*comma/;
      write('01', TYPO);
      await saving.filter({ hasText: /^file can't be read$/ }).waitFor();
      await row.getByText('invalid').waitFor();
      await row.getByText('3:3 expected "," or "}", found "name"').waitFor();
      await problems.getByText(place).waitFor();
      await page.getByRole('list', { name: 'Messages' }).getByText(place).waitFor();
      // the complete level is there, and new changes are not lost
      await verdict(page, 'completable');
      await canvas.click({ x: 448, y: 520 });
      await page.keyboard.press('ArrowDown');
      await until(async () => expect(await page.getByRole('textbox', { name: 'y', exact: true }).inputValue()).toBe('521'));
      expect(text('01')).toBe(TYPO);

      write('01', formatLevel({ ...good, name: 'Mended' }));
      await page.getByRole('heading', { level: 1, name: 'Mended' }).waitFor();
      await saved();
      await until(() => expect(file('01')).toMatchObject({ name: 'Mended', novae: [{ y: 521 }] }));
      await row.getByText('completable').waitFor();
      expect(await problems.getByText(place).count()).toBe(0);
      expect(await page.getByRole('list', { name: 'Messages' }).getByText(place).count()).toBe(0);
    }),
  );

  it(
    'its text dialog follows the disk until the user types, and then offers the version on disk',
    on({ '01': straight(), '02': garden() }, async ({ page, file, write, saved, text }) => {
      await saved();
      const good = file('01') as LevelFile;
      write('01', TYPO);
      await page.getByRole('list', { name: 'Messages' }).getByRole('button', { name: 'Review' }).click();
      await page
        .getByRole('dialog', { name: "The file can't be read" })
        .getByRole('button', { name: /^Fix the file as text$/ })
        .click();
      const dialog = page.getByRole('dialog', { name: '01.level.json' });
      const field = dialog.getByRole('textbox', { name: 'Text of the level' });
      await until(async () => expect(await field.inputValue()).toBe(TYPO));
      await dialog.getByRole('list', { name: 'Problems' }).getByText('expected "," or "}"').waitFor();
      const mended = formatLevel({ ...good, name: 'Mended' });
      write('01', mended);
      await until(async () => expect(await field.inputValue()).toBe(mended));
      await dialog.getByText('A valid level.', { exact: true }).waitFor();

      // typed text is never discarded
      const typed = formatLevel({ ...good, name: 'Typed' });
      await field.fill(typed);
      const theirs = formatLevel({ ...good, name: 'Theirs' });
      write('01', theirs);
      await dialog.getByRole('alert').getByText('The level was changed on disk in the meantime').waitFor();
      expect(await field.inputValue()).toBe(typed);
      await dialog.getByRole('button', { name: /^Use the version on disk/ }).click();
      expect(await field.inputValue()).toBe(theirs);
      await field.fill(typed);
      write('01', mended);
      await dialog.getByRole('button', { name: /^Overwrite/ }).click();
      await until(() => expect(file('01').name).toBe('Typed'));
      await page.getByRole('heading', { level: 1, name: 'Typed' }).waitFor();
      expect(text('01')).toBe(typed);
    }),
  );

  it(
    'a page that starts with it says so, and opens it once it is fixed; Latin-1 does not count as a change',
    on({ '01': straight(), '02': garden() }, async ({ page, folder, file, write, saved }) => {
      await saved();
      const good = file('01');
      writeFileSync(`${folder}/01.level.json`, Buffer.from(formatLevel({ ...good, name: 'Böse' }), 'latin1'));
      await page
        .getByRole('list', { name: 'Problems' })
        .getByText(/the byte F6 at offset \d+ is not UTF-8/)
        .waitFor();
      await page.getByRole('heading', { level: 1, name: 'Straight' }).waitFor();
      await page.reload();
      await page
        .getByRole('main')
        .getByRole('alert')
        .getByText(/can't be read.*01\.level\.json:\d+:\d+: the byte F6/)
        .waitFor();
      write('01', formatLevel({ ...good, name: 'Böse' }));
      await page.getByRole('heading', { level: 1, name: 'Böse' }).waitFor();
      await saved();
    }),
  );
});
