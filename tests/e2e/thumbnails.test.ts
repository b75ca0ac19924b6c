import { expect, it } from 'vitest';
import { command } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('thumbnails of the levels in Chromium', ({ on }) => {
  it(
    'the old picture stays until the new one is there, and another theme does not compute verdicts again',
    on({ '01': garden(), '02': straight() }, async ({ page, canvas, file, write }) => {
      const row = (name: string) => page.getByRole('tree', { name: 'Levels' }).getByRole('treeitem', { name });
      const source = (name: string) => row(name).locator('img').getAttribute('src');
      await row('Garden').locator('img').waitFor();
      await row('Straight').getByText('completable').first().waitFor();
      await row('Straight').locator('img').waitFor();
      await canvas.fit(file('01'));
      // records everything that the list shows from now on
      await page.evaluate(() => {
        const seen = { pictures: 2, isChecking: false };
        Object.assign(window, { seen });
        const tree = document.querySelector('[role=tree][aria-label=Levels]');
        if (tree === null) throw new Error('no list of levels');
        new MutationObserver(() => {
          seen.pictures = Math.min(seen.pictures, tree.querySelectorAll('img').length);
          seen.isChecking ||= tree.textContent?.includes('checking') === true;
        }).observe(tree, { subtree: true, childList: true, characterData: true, attributes: true });
      });
      const seen = () => page.evaluate(() => (window as unknown as { seen: unknown }).seen);
      const before = await source('Garden');
      await canvas.drag({ x: 400, y: 200 }, { to: [{ x: 400, y: 320 }] });
      await until(async () => expect(await source('Garden')).not.toBe(before));
      const inDark = await source('Straight');
      await command(page, 'Switch between light and dark');
      await until(async () => expect(await source('Straight')).not.toBe(inDark));
      expect(await seen()).toEqual({ pictures: 2, isChecking: false });

      // a changed file needs a new verdict, but its old picture is better than none
      const inLight = await source('Straight');
      write('02', straight({ name: 'Straight', runs: [] }));
      await row('Straight').getByText('unproven').first().waitFor();
      await until(async () => expect(await source('Straight')).not.toBe(inLight));
      expect(await seen()).toMatchObject({ pictures: 2 });
    }),
  );
});
