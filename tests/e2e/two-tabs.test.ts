import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import type { LevelFile } from '../../schema/index.ts';
import { complaintsAbout } from './axe.ts';
import { command } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium, type Stage } from './stage.ts';
import { until } from './until.ts';

/** The browser logs every request without an answer. */
const OUTAGE = /Failed to load resource|ERR_/;

const A = { x: 400, y: 200 };
const saving = (page: Page, text: RegExp) => page.getByRole('status', { name: 'Saving' }).filter({ hasText: text }).waitFor();
const question = (page: Page) => page.getByRole('complementary', { name: 'Change that waits' });
const rock = (file: LevelFile) => file.asteroids?.find((one) => one.id === 'a1');

/** Opens the level in a second tab, which may not write it. */
async function second({ page, open, saved }: Stage) {
  await saved();
  // a page that starts while another is still opening the level asks before it opens it, too
  await page.waitForFunction(() => !localStorage.getItem('gravity-quest-editor-opening')?.includes('"'));
  const other = await open();
  await saving(other.page, /^read-only$/);
  return other;
}

const takeOver = (page: Page) => question(page).getByRole('button', { name: 'Take over and save' }).click();

/** Ways to change the level. */
const EDITS: readonly ((page: Page) => Promise<void>)[] = [
  // a key on the canvas
  (page) => page.keyboard.press('ArrowDown'),
  // a field of the inspector
  async (page) => {
    const x = page.getByRole('textbox', { name: 'x', exact: true });
    await x.fill('411');
    await x.press('Enter');
  },
  // a pasted object
  async (page) => {
    await page.getByRole('application', { name: 'Level canvas' }).focus();
    await page.keyboard.press('Control+c');
    await page.keyboard.press('Control+v');
  },
  // a hold on the timeline
  async (page) => {
    await page.getByRole('slider', { name: 'Release of hold 1' }).focus();
    await page.keyboard.press('ArrowRight');
  },
];

inChromium('two tabs on one level, in Chromium', ({ on }) => {
  it(
    'each kind of change in the tab that may not write is kept until it takes over, can be undone and redone, and is saved',
    on({ '01': garden() }, async (stage) => {
      const { file, page, canvas, text } = stage;
      const other = await second(stage);
      const before = text('01');
      await other.canvas.fit(file('01'));
      for (const edit of EDITS) {
        await other.canvas.click(A);
        await edit(other.page);
        await question(other.page).waitFor();
        await saving(other.page, /^not saved$/);
        // what is undone is no question any more
        await other.page.getByRole('button', { name: /^Undo: / }).click();
        await question(other.page).waitFor({ state: 'hidden' });
        await saving(other.page, /^read-only$/);
      }
      // and what is redone is one again
      await other.page.getByRole('button', { name: /^Redo: / }).click();
      await question(other.page).waitFor();
      await other.page.getByRole('button', { name: /^Undo: / }).click();
      await other.canvas.click(A);
      for (const edit of EDITS) await edit(other.page);
      // the first tab goes on meanwhile
      await page.bringToFront();
      await canvas.fit(file('01'));
      await canvas.click({ x: 720, y: 240 });
      await page.keyboard.press('Shift+ArrowDown');
      await until(() => expect(file('01').asteroids?.[2].y).toBe(248));
      expect(text('01')).not.toBe(before);
      await other.page.bringToFront();
      await takeOver(other.page);
      await question(other.page).waitFor({ state: 'hidden' });
      await saving(other.page, /^saved$/);
      await saving(page, /^read-only$/);
      await until(() => {
        expect(rock(file('01'))).toMatchObject({ x: 411, y: 201 });
        expect(file('01').asteroids).toHaveLength(4);
        expect(file('01').runs?.[0].holds).toEqual([[30, 91]]);
      });
      expect(file('01').asteroids?.[2].y).toBe(248);
    }),
  );

  it(
    'what is dropped leaves the tab as the other one is, and undo brings it back; nothing on the page breaks a rule of accessibility',
    on({ '01': garden() }, async (stage) => {
      const { file, text } = stage;
      const other = await second(stage);
      const before = text('01');
      await other.canvas.fit(file('01'));
      await other.canvas.click(A);
      await other.page.keyboard.press('ArrowDown');
      await question(other.page).waitFor();
      expect(await complaintsAbout(other.page, 'the question', '.heldbar')).toEqual([]);
      const y = other.page.getByRole('textbox', { name: 'y', exact: true });
      await until(async () => expect(await y.inputValue()).toBe('201'));
      await question(other.page).getByRole('button', { name: 'Drop the change' }).click();
      await question(other.page).waitFor({ state: 'hidden' });
      await until(async () => expect(await y.inputValue()).toBe('200'));
      await saving(other.page, /^read-only$/);
      await command(other.page, 'Undo');
      await question(other.page).waitFor();
      await until(async () => expect(await y.inputValue()).toBe('201'));
      expect(text('01')).toBe(before);
    }),
  );

  it(
    'a change is kept while another level is looked at, and is saved when the first tab is closed',
    on({ '01': garden(), '02': straight() }, async (stage) => {
      const { page, file } = stage;
      const other = await second(stage);
      await other.canvas.fit(file('01'));
      await other.canvas.click(A);
      await other.page.keyboard.press('ArrowDown');
      await question(other.page).waitFor();
      const levels = other.page.getByRole('tree', { name: 'Levels' });
      await levels.getByRole('treeitem', { name: /Straight/ }).click();
      await other.page.getByRole('heading', { level: 1, name: 'Straight' }).waitFor();
      await question(other.page).waitFor({ state: 'hidden' });
      await levels.getByRole('treeitem', { name: /Garden/ }).click();
      await question(other.page).waitFor();
      await page.close();
      await saving(other.page, /^saved$/);
      await until(() => expect(rock(file('01'))).toMatchObject({ x: 400, y: 201 }));
    }),
  );

  it(
    'the first tab crashes with changes that it could not save: both tabs’ changes are saved',
    on(
      { '01': garden() },
      async (stage) => {
        const { page, canvas, file, endServer, startServer, server } = stage;
        const other = await second(stage);
        const { port } = server();
        await canvas.fit(file('01'));
        await endServer();
        await canvas.click({ x: 720, y: 240 });
        await page.keyboard.press('Shift+ArrowDown');
        await saving(page, /disconnected, kept in this browser/);
        await other.page.bringToFront();
        await other.canvas.fit(file('01'));
        await other.canvas.click(A);
        await other.page.keyboard.press('ArrowDown');
        await question(other.page).waitFor();
        const crashed = page.waitForEvent('crash');
        await page.goto('chrome://crash').catch(() => {});
        await crashed;
        await saving(other.page, /disconnected, kept in this browser/);
        await other.page.close();
        await startServer(port);
        const again = await stage.open();
        await saving(again.page, /^saved$/);
        await until(() => expect(rock(file('01'))).toMatchObject({ x: 400, y: 201 }));
        expect(file('01').asteroids?.[2].y).toBe(248);
      },
      { complaints: OUTAGE },
    ),
  );

  it(
    'a first tab that is frozen does not answer: the level is taken from it, and it asks when it wakes with a change',
    on({ '01': garden() }, async (stage) => {
      const { page, canvas, file, context } = stage;
      const other = await second(stage);
      await canvas.fit(file('01'));
      await canvas.click({ x: 720, y: 240 });
      const debug = await context.newCDPSession(page);
      await debug.send('Debugger.enable');
      const paused = new Promise((resolve) => debug.once('Debugger.paused', resolve));
      await debug.send('Debugger.pause');
      // the page stops at its next script
      await paused;
      await other.page.bringToFront();
      await other.canvas.fit(file('01'));
      await other.canvas.click(A);
      await other.page.keyboard.press('ArrowDown');
      await takeOver(other.page);
      await saving(other.page, /^saved$/);
      await until(() => expect(rock(file('01'))).toMatchObject({ x: 400, y: 201 }));
      await debug.send('Debugger.disable');
      await page.bringToFront();
      await saving(page, /^read-only$/);
      await canvas.click({ x: 720, y: 240 });
      await page.keyboard.press('Shift+ArrowDown');
      await question(page).waitFor();
      await takeOver(page);
      await saving(page, /^saved$/);
      await until(() => expect(file('01').asteroids?.[2].y).toBe(248));
      expect(rock(file('01'))).toMatchObject({ x: 400, y: 201 });
    }),
  );
});
