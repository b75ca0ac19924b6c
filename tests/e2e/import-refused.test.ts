import { readdirSync } from 'node:fs';
import { expect, it } from 'vitest';
import { drop } from './drop.ts';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const PNG = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52];
const ZIP = [0x50, 0x4b, 3, 4, 20, 0];

inChromium('a refused import in Chromium', ({ on }) => {
  it(
    'says what the file is, does not cover the work area, and disappears with the next import',
    on({ '01': straight() }, async ({ page, saved, folder }) => {
      await saved();
      const messages = page.getByRole('list', { name: 'Messages' });
      await drop(page, { 'shot.png': PNG, 'levels.zip': ZIP, 'typo.json': '{\n  "version" 1\n}' });
      const notice = messages.getByRole('listitem').filter({ hasText: 'shot.png' });
      await notice.getByText('shot.png: expected a level as JSON text, found a PNG picture.').waitFor();
      await notice.getByText('levels.zip: expected a level as JSON text, found a ZIP archive. Unpack it').waitFor();
      await notice.getByText('typo.json:2:13: expected a colon').waitFor();
      const [card, timeline] = await Promise.all([
        notice.boundingBox(),
        page.getByRole('region', { name: 'Timeline' }).boundingBox(),
      ]);
      if (card === null || timeline === null) throw new Error('the message and the timeline are shown');
      expect(card.x).toBeGreaterThanOrEqual(timeline.x + timeline.width);

      // another drop replaces it, and the import dialog removes it
      await drop(page, { 'other.png': PNG });
      await messages.getByText('other.png').waitFor();
      expect(await messages.getByText('shot.png').count()).toBe(0);
      await page.getByRole('button', { name: 'Import, export, link' }).click();
      const dialog = page.getByRole('dialog', { name: 'Import, export, link' });
      await dialog.getByRole('tab', { name: 'Import' }).click();
      await until(async () => expect(await messages.getByText('other.png').count()).toBe(0));

      // the dialog shows its own refusals until it is closed
      const [chooser] = await Promise.all([
        page.waitForEvent('filechooser'),
        dialog.getByRole('button', { name: /^Choose files/ }).click(),
      ]);
      await chooser.setFiles({ name: 'photo.json', mimeType: 'image/png', buffer: Buffer.from(PNG) });
      const alert = dialog.getByRole('alert', { name: 'Not imported' });
      await alert.getByText('photo.json: expected a level as JSON text, found a PNG picture.').waitFor();
      await dialog.getByRole('textbox', { name: 'Or paste their text' }).fill('{');
      await dialog.getByRole('button', { name: 'Import text' }).click();
      await alert.getByText(/pasted text:1:2: expected/).waitFor();
      expect(await alert.getByText('photo.json').count()).toBe(0);
      await page.keyboard.press('Escape');
      await dialog.waitFor({ state: 'hidden' });
      expect(await messages.getByText(/expected/).count()).toBe(0);
      expect(readdirSync(folder).filter((name) => name.endsWith('.level.json'))).toEqual(['01.level.json']);
    }),
  );
});
