import { expect, it } from 'vitest';
import { garden } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('wrong input in Chromium', ({ on }) => {
  it(
    'stays in its field, which says what was expected and found, until it is fixed or Esc restores the value',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      await canvas.fit(file('01'));
      await canvas.click({ x: 400, y: 200 });
      const inspector = page.getByRole('tabpanel', { name: 'Inspector' });
      const x = inspector.getByRole('textbox', { name: 'x', exact: true });
      const radius = inspector.getByRole('textbox', { name: 'radius' });
      const isRefused = async (field: typeof x, text: string, why: RegExp) => {
        expect(await field.inputValue()).toBe(text);
        expect(await field.getAttribute('aria-invalid')).toBe('true');
        const described = page.locator(`[id="${await field.getAttribute('aria-describedby')}"]`);
        expect(await described.textContent()).toMatch(why);
      };
      for (const [typed, why] of [
        ['12 px', /^expected a number, found "12 px"\. It is still 400: .*Esc/],
        ['2e9', /^expected -1000000000 to 1000000000 px, found 2000000000\. It is still 400/],
        ['', /^expected a number, found nothing\. It is still 400/],
      ] as const) {
        await x.fill(typed);
        await x.press('Enter');
        await isRefused(x, typed, why);
        await radius.focus();
        await isRefused(x, typed, why);
      }
      await x.press('Escape');
      expect(await x.inputValue()).toBe('400');
      expect(await x.getAttribute('aria-invalid')).toBe('false');
      await x.fill('410+6');
      await x.press('Enter');
      await until(() => expect(file('01').asteroids?.[0]).toMatchObject({ x: 416, y: 200 }));
      // an undo replaces the input
      await radius.fill('0');
      await x.focus();
      await isRefused(radius, '0', /^expected 0\.001 to 1000000 px, found 0\. It is still 32/);
      await radius.fill('40');
      await radius.press('Enter');
      await until(() => expect(file('01').asteroids?.[0]).toMatchObject({ radius: 40 }));
      await radius.fill('much');
      await page.getByRole('button', { name: /^Undo: Set radius/ }).click();
      await until(async () => expect(await radius.inputValue()).toBe('32'));
      expect(await radius.getAttribute('aria-invalid')).toBe('false');

      // a text that is not valid in a level
      await canvas.click({ x: 300, y: 100 });
      // the fields of the object, which has a name as well, are gone
      const range = inspector.getByRole('textbox', { name: 'range' });
      await range.waitFor();
      const name = inspector.getByRole('textbox', { name: 'name', exact: true });
      await name.fill('');
      await range.focus();
      await isRefused(name, '', /^a level needs a name/);
      await name.press('Escape');
      expect(await name.inputValue()).toBe('Garden');
      await saved();
      expect(file('01').name).toBe('Garden');
    }),
  );
});
