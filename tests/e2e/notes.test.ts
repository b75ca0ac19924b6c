import { expect, it } from 'vitest';
import { complaintsAbout } from './axe.ts';
import { command } from './commands.ts';
import { garden } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('notes on the canvas in Chromium', ({ on }) => {
  it(
    'are added by the menu and by key, opened, moved, listed, hidden and deleted',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      await canvas.fit(file('01'));
      const notes = () => Object.values((file('01') as unknown as Record<string, object>)['x-notes'] ?? {});
      const at = canvas.at({ x: 304, y: 104 });
      await page.mouse.click(at.x, at.y, { button: 'right' });
      await page.getByRole('menuitem', { name: 'Add a note here' }).click();
      const field = page.getByRole('textbox', { name: 'Text of the note' });
      await until(async () => expect(await field.evaluate((element) => element === document.activeElement)).toBe(true));
      await page.keyboard.type('Too narrow?');
      await page.keyboard.press('Control+Enter');
      await until(() =>
        expect(notes()).toEqual([{ x: expect.closeTo(304, -1), y: expect.closeTo(104, -1), text: 'Too narrow?' }]),
      );
      const pin = page.getByRole('button', { name: /^Note: Too narrow\?/ });
      await pin.waitFor();
      expect(await complaintsAbout(page, 'notes', 'main')).toEqual([]);
      // Esc keeps the old text
      await pin.click();
      await field.fill('no');
      await field.press('Escape');
      await field.waitFor({ state: 'hidden' });
      expect(notes()).toHaveLength(1);
      // a drag and the arrow keys move it
      await pin.hover();
      await page.mouse.down();
      await page.mouse.move(canvas.at({ x: 304, y: 560 }).x, canvas.at({ x: 304, y: 560 }).y, { steps: 4 });
      await page.mouse.up();
      await until(() => expect(notes()).toEqual([expect.objectContaining({ y: expect.closeTo(560, -1.5) })]));
      const [{ x }] = notes() as { x: number }[];
      await pin.focus();
      await page.keyboard.press('ArrowRight');
      await until(() => expect(notes()).toEqual([expect.objectContaining({ x: x + 1 })]));
      // by key, at the selected object
      await canvas.click({ x: 720, y: 240 });
      await page.keyboard.press('Shift+T');
      await field.fill('The gate');
      await page.getByRole('button', { name: 'Done' }).click();
      await until(() => expect(notes()).toContainEqual({ x: 720, y: 240, text: 'The gate' }));
      // the list goes there; the layer is hidden and shown by a command
      await command(page, 'Show or hide the notes');
      await pin.waitFor({ state: 'hidden' });
      await page.getByRole('region', { name: 'Notes' }).getByRole('button', { name: 'The gate' }).click();
      await until(async () => expect(await field.inputValue()).toBe('The gate'));
      await page.getByRole('dialog', { name: 'Note' }).getByRole('button', { name: 'Delete' }).click();
      await until(() => expect(notes()).toHaveLength(1));
      await pin.focus();
      await page.keyboard.press('Delete');
      await until(() => expect(file('01')).not.toHaveProperty('x-notes'));
      for (let i = 0; i < 6; i++) await page.keyboard.press('Control+z');
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();
      await saved();
    }),
  );
});
