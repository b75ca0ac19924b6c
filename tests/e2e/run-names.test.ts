import { expect, it } from 'vitest';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('names of runs in Chromium', ({ on }) => {
  it(
    'a taken or empty name stays in the field with an error beside it until it is fixed',
    on(
      {
        '01': straight({
          runs: [
            { name: 'solution', holds: [[0, 600]] },
            { name: 'other', holds: [[0, 601]] },
          ],
        }),
      },
      async ({ page, file }) => {
        const names = () => file('01').runs?.map(({ name }) => name);
        await page.getByRole('tab', { name: 'Runs' }).click();
        await page.getByRole('treeitem', { name: /^other/ }).click();
        await page.keyboard.press('F2');
        const field = page.getByRole('textbox', { name: 'Run name' });
        const problem = page.getByRole('alert').filter({ hasText: 'Esc to keep the old one' });
        await field.fill('solution');
        await page.keyboard.press('Enter');
        await problem.getByText('Another run is called “solution”').waitFor();
        expect(await field.getAttribute('aria-invalid')).toBe('true');
        const [of, beside] = [await field.boundingBox(), await problem.boundingBox()];
        expect(Math.abs((beside?.y ?? 0) - (of?.y ?? 0) - (of?.height ?? 0))).toBeLessThan(8);
        // after a click elsewhere, the typed text is not lost
        await page.getByRole('heading', { name: 'Runs' }).click();
        expect(await field.inputValue()).toBe('solution');
        await problem.waitFor();
        await field.fill('');
        await page.keyboard.press('Enter');
        await problem.getByText('A run needs a name').waitFor();
        await field.fill('second');
        await problem.waitFor({ state: 'hidden' });
        await page.keyboard.press('Enter');
        await until(() => expect(names()).toEqual(['solution', 'second']));
        await field.waitFor({ state: 'hidden' });
        // Esc restores the name
        await page.keyboard.press('F2');
        await field.fill('solution');
        await page.keyboard.press('Escape');
        await field.waitFor({ state: 'hidden' });
        expect(names()).toEqual(['solution', 'second']);
      },
    ),
  );
});
