import { expect, it } from 'vitest';
import { command, verdict } from './commands.ts';
import { controlsOf } from './controls.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';

/** px; the width and height that a finger hits easily */
const FINGER = 44;

const PANELS = ['Timeline', 'Levels', 'Outline', 'Runs', 'Inspector', 'Solver', 'Effects', 'Accuracy', 'Problems'];
const DIALOGS: Readonly<Record<string, string>> = {
  'Shortcuts and gestures': 'Shortcuts and gestures',
  Settings: 'Settings',
  'New level': 'New level',
  'Import, export, link': 'Import, export, link',
  'Publish as a page to play': 'Publish',
  'Import levels': 'Import, export, link',
  'Deleted levels': 'Deleted levels',
  'Unsaved changes kept in this browser': 'Unsaved changes',
};

inChromium('touch in Chromium', ({ on }) => {
  it(
    'every control is large enough for a finger, in every panel, menu and dialog',
    on(
      { '01': straight(), '02': garden() },
      async ({ page }) => {
        await verdict(page, 'completable');
        const small: string[] = [];
        const measure = async (where: string) => {
          for (const { name, width, height } of await controlsOf(page)) {
            if (width < FINGER || height < FINGER) small.push(`${where}: ${width} x ${height} ${name}`);
          }
        };
        const panels = page.getByRole('navigation', { name: 'Panels' });
        for (const panel of PANELS) {
          const tab = panels.getByRole('button', { name: panel });
          if ((await tab.getAttribute('aria-pressed')) !== 'true') await tab.tap();
          await measure(panel);
        }
        await panels.getByRole('button', { name: 'Levels' }).tap();
        await page.getByRole('tree', { name: 'Levels' }).locator('.tree__more').first().tap();
        await page.getByRole('menu').waitFor();
        await measure('menu');
        await page.keyboard.press('Escape');
        await page.getByRole('button', { name: 'Search all commands' }).tap();
        await page.getByRole('dialog', { name: 'Commands' }).waitFor();
        await measure('palette');
        await page.keyboard.press('Escape');
        for (const [title, name] of Object.entries(DIALOGS)) {
          await command(page, title);
          const dialog = page.getByRole('dialog', { name });
          await dialog.waitFor();
          await measure(title);
          await page.keyboard.press('Escape');
          await dialog.waitFor({ state: 'hidden' });
        }
        expect(small).toEqual([]);
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );
});
