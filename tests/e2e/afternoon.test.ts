import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import type { LevelFile, PackFile } from '../../schema/index.ts';
import { gq } from '../cli/gq.ts';
import { command, tool, verdict } from './commands.ts';
import { hurry, paceFrames } from './frames.ts';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { PATIENCE, until } from './until.ts';

/** Makes a level from a template and waits until it is open. */
async function make(page: Page, template: string, name: string, file: string): Promise<void> {
  await page.keyboard.press('Alt+n');
  const dialog = page.getByRole('dialog', { name: 'New level' });
  await dialog.getByText(template, { exact: true }).click();
  await dialog.getByLabel('Level name').fill(name);
  await dialog.getByLabel('File name').fill(file);
  await dialog.getByRole('button', { name: 'Create' }).click();
  await page.getByRole('heading', { name, level: 1 }).waitFor();
}

const packIn = (folder: string): PackFile => JSON.parse(readFileSync(join(folder, 'pack.json'), 'utf8'));
const cards = (view: Locator): Locator => view.locator('[role=option][data-key]');
const namesIn = (view: Locator): Promise<string[]> => cards(view).locator('.pack__name').allTextContents();

/** What `gq check` says of a folder: its exit code, and name and verdict of each level in order. */
async function checked(folder: string): Promise<{ code: number | null; levels: [string, string][]; packs: unknown }> {
  const { code, stdout } = await gq(['check', folder, '--format', 'json']);
  const { levels, packs } = JSON.parse(stdout) as {
    levels: { name: string; verdict: string }[];
    packs?: { problems: { code: string }[] }[];
  };
  return {
    code,
    levels: levels.map(({ name, verdict: is }) => [name, is]),
    packs: packs?.flatMap(({ problems }) => problems.map((one) => one.code)),
  };
}

inChromium("a designer's afternoon in Chromium", ({ on }) => {
  it(
    'three levels are built, broken, mended, proved, ordered, reviewed and played on a phone',
    on({ pull: straight({ name: 'Pull', minerals: [], novae: [], astronaut: { x: 200, y: 304, vx: 120 } }) }, async (stage) => {
      const { page, canvas, folder, file, saved, server, context } = stage;
      await verdict(page, 'completable');

      // built: a level with a run of its own, with a nova and a mineral beside the path
      await make(page, 'A first swing', 'Swing', 'swing');
      await verdict(page, 'completable');
      await canvas.fit(file('swing'));
      await tool(page, 'Nova').click();
      await canvas.click({ x: 640, y: 520 });
      await until(() => expect(file('swing').novae).toHaveLength(1));
      await page.keyboard.press('Escape');
      await verdict(page, 'completable');

      // built and proved: a level without a run, until a search finds one
      await make(page, 'Empty', 'Gap', 'gap');
      await verdict(page, 'unproven');
      await page.keyboard.press('Control+Enter');
      const solver = page.getByRole('tabpanel', { name: 'Solver' });
      await solver.getByRole('button', { name: 'Add', exact: true }).first().click();
      await verdict(page, 'completable');
      await until(() => expect(file('gap').runs).toHaveLength(1));
      await saved();
      expect(await checked(folder)).toMatchObject({
        code: 0,
        levels: [
          ['Gap', 'completable'],
          ['Pull', 'completable'],
          ['Swing', 'completable'],
        ],
      });

      // broken: the asteroid of the swing is dragged too far, beside the path as it was
      await page.getByRole('treeitem', { name: /Swing/ }).first().click();
      await page.getByRole('heading', { name: 'Swing', level: 1 }).waitFor();
      await verdict(page, 'completable');
      await saved();
      await page.keyboard.press('Shift+Y');
      await page.getByRole('dialog', { name: 'Name this version' }).getByRole('textbox', { name: 'Name' }).fill('It works');
      await page.keyboard.press('Enter');
      await page.getByText('This version is kept as "It works".').waitFor();
      const works = file('swing');
      await canvas.fit(works);
      const rock = (level: LevelFile) => level.asteroids?.[0] ?? { x: 0, y: 0 };
      const { x, y } = rock(works);
      await canvas.drag(
        { x, y },
        {
          to: [{ x: x + 96, y }],
          before: async () => {
            await page.getByText('before → after').waitFor();
            await verdict(page, 'broken');
          },
        },
      );
      await until(() => expect(rock(file('swing')).x).toBeGreaterThan(x + 80));
      await saved();
      expect(await checked(folder)).toMatchObject({ code: 1 });

      // mended: the smallest way back, seen before it is taken
      const mend = page.getByRole('region', { name: 'Mend' });
      await mend.getByRole('button', { name: 'Mend' }).click();
      const first = mend.getByRole('list', { name: 'What mends the level' }).getByRole('listitem').first();
      await first.getByRole('button', { name: 'Preview' }).click();
      await verdict(page, 'completable');
      await first.getByRole('button', { name: 'Take' }).click();
      await mend.waitFor({ state: 'hidden' });
      await verdict(page, 'completable');
      await saved();
      await until(async () => expect(await checked(folder)).toMatchObject({ code: 0 }));

      // ordered: the pull first, then the gap, then the swing
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('Shift+P');
      const pack = page.getByRole('dialog', { name: 'Pack' });
      await until(async () => expect(await namesIn(pack)).toEqual(['Gap', 'Pull', 'Swing']));
      await cards(pack).filter({ hasText: 'Pull' }).click();
      await page.keyboard.press('Alt+ArrowLeft');
      await until(async () => expect(await namesIn(pack)).toEqual(['Pull', 'Gap', 'Swing']));
      await until(() => expect(packIn(folder).levels).toEqual(['pull', 'gap', 'swing']));
      await page.keyboard.press('Escape');
      await pack.waitFor({ state: 'hidden' });
      const ordered = await checked(folder);
      expect(ordered.levels.map(([name]) => name)).toEqual(['Pull', 'Gap', 'Swing']);
      expect([ordered.code, ordered.packs]).toEqual([0, []]);

      // reviewed: what has changed since it worked
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('y');
      const history = page.getByRole('dialog', { name: 'History', exact: true });
      await history.getByRole('treeitem', { name: /It works/ }).click();
      const changes = history.getByRole('region', { name: /^Version of / }).getByRole('checkbox');
      await until(async () => expect(await changes.count()).toBeGreaterThan(0));
      await page.keyboard.press('Escape');
      await history.waitFor({ state: 'hidden' });

      // played on a phone: a finger holds the gun until she is there
      await saved();
      const browser = context.browser();
      if (browser === null) throw new Error('a page belongs to a browser');
      const phone = await browser.newContext({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
      try {
        await phone.addInitScript(`localStorage['gravity-quest-editor-settings'] ??= '{"tourSeen":true}'`);
        await phone.addInitScript(paceFrames);
        const small = await phone.newPage();
        small.setDefaultTimeout(PATIENCE);
        await small.goto(`${server().address}&level=pull`);
        await small.getByRole('heading', { name: 'Pull', level: 1 }).waitFor();
        await verdict(small, 'completable');
        await small.getByRole('button', { name: 'Play', exact: true }).tap();
        const playtest = small.getByRole('application', { name: /^Playtest/ });
        await playtest.waitFor();
        await hurry(small, 10);
        const touch = await phone.newCDPSession(small);
        await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x: 195, y: 500, id: 0 }] });
        await playtest.getByRole('status').filter({ hasText: 'Level completed' }).waitFor();
        await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
        await playtest.getByRole('button', { name: 'Edit' }).tap();
        await playtest.waitFor({ state: 'hidden' });
      } finally {
        await phone.close();
      }
      await command(page, 'Show attempts');
      await verdict(page, 'completable');
      expect(await checked(folder)).toMatchObject({ code: 0, packs: [] });
    }),
  );
});
