import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { COLOUR_RULES, complaintsAbout } from './axe.ts';
import { command, verdict } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';

const PANELS = ['Outline', 'Runs', 'Inspector', 'Solver', 'Effects', 'Accuracy'];
const DIALOGS = {
  'Shortcuts and gestures': 'Shortcuts and gestures',
  Settings: 'Settings',
  'New level': 'New level',
  'Import, export, link': 'Import, export, link',
  'Publish as a page to play': 'Publish',
  'Deleted levels': 'Deleted levels',
  'Unsaved changes kept in this browser': 'Unsaved changes',
};

const THEMES = ['dark', 'light'] as const;

async function show(page: Page, colorScheme: 'dark' | 'light'): Promise<void> {
  await page.emulateMedia({ colorScheme });
  await page.locator(`html[data-theme=${colorScheme}]`).waitFor({ state: 'attached' });
}

inChromium('names in Chromium', ({ on }) => {
  it(
    'rows have names with everything that they show, including verdicts',
    on({ '01-straight': straight(), '02-garden': garden(), '03-torn': '{' }, async ({ page }) => {
      const levels = page.getByRole('tree', { name: 'Levels' });
      await levels.getByRole('treeitem', { name: /^01 Straight completable/ }).waitFor();
      await levels.getByRole('treeitem', { name: /^02 Garden broken/ }).waitFor();
      await levels.getByRole('treeitem', { name: /03-torn.*invalid/ }).waitFor();
      const objects = page.getByRole('tree', { name: 'Objects of the level' });
      await objects.getByRole('treeitem', { name: 'Asteroid 1 rock at 448, 304', exact: true }).waitFor();
      await objects.getByRole('treeitem', { name: 'Minerals 1', exact: true }).waitFor();
      await page.getByRole('tab', { name: 'Runs' }).click();
      await page
        .getByRole('tree', { name: 'Runs of the level' })
        .getByRole('treeitem', { name: /^solution first [\d.]+ s completes/ })
        .waitFor();
    }),
  );

  it(
    'every panel and dialog meets the rules for names, roles and contrast, in both themes',
    on({ '01-straight': straight(), '02-garden': garden(), '03-torn': '{' }, async ({ page }) => {
      await verdict(page, 'completable');
      await page
        .getByRole('tree', { name: 'Levels' })
        .getByRole('treeitem', { name: /^02 Garden broken/ })
        .waitFor();
      const complaints: string[] = [];
      /** Names and roles are the same in both themes, and the page around a part is the same with all of them. */
      const look = async (where: string, theme: (typeof THEMES)[number], part: string) => {
        complaints.push(...(await complaintsAbout(page, `${where}, ${theme}`, part, theme === 'dark' ? null : COLOUR_RULES)));
      };
      for (const theme of THEMES) {
        await show(page, theme);
        await look('the page', theme, 'html');
        for (const panel of PANELS) {
          await page.getByRole('tab', { name: panel }).click();
          await look(panel, theme, '[role=tabpanel]');
        }
      }
      for (const [title, name] of Object.entries(DIALOGS)) {
        await command(page, title);
        const dialog = page.getByRole('dialog', { name });
        await dialog.waitFor();
        for (const theme of THEMES) {
          await show(page, theme);
          await look(title, theme, '[role=dialog]');
        }
        await page.keyboard.press('Escape');
        await dialog.waitFor({ state: 'hidden' });
      }
      expect(complaints).toEqual([]);
    }),
  );
});
