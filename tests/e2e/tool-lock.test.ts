import { expect, it } from 'vitest';
import { tool } from './commands.ts';
import { garden } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('the lock of the tools in Chromium', ({ on }) => {
  it(
    'keeps the tool after placing, by a double-click, the button or Q, until Esc or another tool',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      const lock = tool(page, 'Keep the tool after placing an object');
      const isLocked = (is: boolean) => until(async () => expect(await lock.getAttribute('aria-pressed')).toBe(String(is)));
      const isChosen = (name: string) =>
        until(async () => expect(await tool(page, name).getAttribute('aria-pressed')).toBe('true'));
      await tool(page, 'Nova').dblclick();
      await isLocked(true);
      await canvas.click({ x: 304, y: 104 });
      await canvas.click({ x: 304, y: 560 });
      await until(() => expect(file('01').novae).toHaveLength(3));
      await isChosen('Nova');
      // another tool that places keeps the lock, one that does not ends it
      await page.keyboard.press('m');
      await isChosen('Mineral');
      await isLocked(true);
      await page.keyboard.press('Escape');
      await isLocked(false);
      await isChosen('Select');
      await page.keyboard.press('q');
      await isLocked(true);
      await page.keyboard.press('n');
      await page.keyboard.press('Enter');
      await until(() => expect(file('01').novae).toHaveLength(4));
      await isChosen('Nova');
      await page.keyboard.press('v');
      await isLocked(false);
      await lock.click();
      await lock.click();
      await isLocked(false);
      // without it, the tool is put away
      await page.keyboard.press('n');
      await canvas.click({ x: 800, y: 560 });
      await isChosen('Select');
    }),
  );
});
