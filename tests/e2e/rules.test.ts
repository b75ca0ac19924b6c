// Editing the rules of a level, and the effect of a folder's configuration. GQ_SHOTS names a folder for pictures of the page.
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { gq } from '../cli/gq.ts';
import { SWING } from '../editor/swing-level.ts';
import { put } from '../server/running.ts';
import { complaintsAbout } from './axe.ts';
import { command, verdict } from './commands.ts';
import { nextFrames } from './frames.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const shots = process.env.GQ_SHOTS;

const swing = (changes: Readonly<Record<string, unknown>> = {}) => ({ ...SWING, ...changes });

const BOX = { boxWidth: 120, boxHeight: 20 };
const CONFIG = 'gq.config.json';
const config = (rules: object): string => `${JSON.stringify({ rules }, null, 2)}\n`;

const slider = (page: Page, name: string): Locator => page.getByRole('slider', { name, exact: true });
const rule = (page: Page, name: string): Locator => page.getByRole('group', { name, exact: true });
const field = (page: Page, name: string): Locator => rule(page, name).getByRole('textbox', { name });
const reads = (page: Page, name: string, value: string) =>
  until(async () => expect(await field(page, name).inputValue()).toBe(value));

const messages = (page: Page): Locator => page.getByRole('list', { name: 'Messages' });

inChromium('rules in Chromium', ({ on }) => {
  it(
    'a rule is dragged while the verdict follows, as one undo step, and can be reset',
    on({ '01': swing() }, async ({ page, file, saved }) => {
      const shot = async (name: string) => {
        if (shots !== undefined) await page.screenshot({ path: `${shots}/${name}.png` });
      };
      await verdict(page, 'completable');
      await command(page, 'Go to rules');
      await until(async () => expect(await slider(page, 'pull').evaluate((one) => one === document.activeElement)).toBe(true));
      await shot('1-rules');
      await slider(page, 'pull').scrollIntoViewIfNeeded();
      const box = await slider(page, 'pull').boundingBox();
      if (box === null) throw new Error('the slider is not seen');
      const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
      await page.mouse.move(middle.x, middle.y);
      await page.mouse.down();
      await page.mouse.move(middle.x + 10, middle.y, { steps: 3 });
      await page.mouse.move(middle.x + 30, middle.y, { steps: 3 });
      // during the drag: the proof has followed, and nothing is written
      await verdict(page, 'broken');
      await shot('2-dragging');
      expect(file('01').rules).toBeUndefined();
      await page.mouse.move(middle.x + 40, middle.y, { steps: 3 });
      // released beside the slider
      await page.mouse.move(middle.x + 40, middle.y + 60);
      await page.mouse.up();
      await until(() => expect(file('01').rules?.pull).toBeGreaterThan(41));
      await rule(page, 'pull').getByText("Set by this level; the game's default is 39.").waitFor();
      await page.keyboard.press('Control+z');
      await verdict(page, 'completable');
      await reads(page, 'pull', '39');
      await until(() => expect(file('01').rules).toBeUndefined());
      await page.keyboard.press('Control+Shift+z');
      await verdict(page, 'broken');
      await rule(page, 'pull').getByRole('button', { name: 'Reset pull' }).click();
      await verdict(page, 'completable');
      await until(() => expect(file('01').rules).toBeUndefined());
      await saved();
    }),
  );

  it(
    'Esc cancels a drag, whatever the mouse does after it',
    on({ '01': swing() }, async ({ page, file, saved }) => {
      await verdict(page, 'completable');
      await slider(page, 'pull').scrollIntoViewIfNeeded();
      const box = await slider(page, 'pull').boundingBox();
      if (box === null) throw new Error('the slider is not seen');
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 30, y, { steps: 3 });
      await verdict(page, 'broken');
      await page.keyboard.press('Escape');
      await verdict(page, 'completable');
      await page.mouse.move(x + 60, y, { steps: 3 });
      await page.mouse.up();
      await reads(page, 'pull', '39');
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();
      await saved();
      expect(file('01').rules).toBeUndefined();
    }),
  );

  it(
    'keys and typing change rules, and all can be reset at once',
    on({ '01': swing() }, async ({ page, file }) => {
      await verdict(page, 'completable');
      await page.keyboard.press('Control+k');
      await page.getByRole('dialog', { name: 'Commands' }).getByRole('combobox').fill('speed limit');
      await page.getByRole('option', { name: /^Speed limit/ }).click();
      await until(async () =>
        expect(await slider(page, 'speed limit').evaluate((one) => one === document.activeElement)).toBe(true),
      );
      await page.keyboard.press('ArrowLeft');
      await page.keyboard.press('PageDown');
      await until(() => expect(file('01').rules).toEqual({ speedLimit: 890 }));
      expect(await slider(page, 'speed limit').getAttribute('aria-valuetext')).toBe('890 px/s');
      await page.keyboard.press('Home');
      await until(() => expect(file('01').rules).toEqual({ speedLimit: 10 }));
      await verdict(page, 'broken');
      await field(page, 'pull').fill('45');
      await field(page, 'pull').press('Enter');
      await until(() => expect(file('01').rules).toEqual({ pull: 45, speedLimit: 10 }));
      await field(page, 'pull').fill('2000');
      await field(page, 'pull').press('Enter');
      await rule(page, 'pull').getByRole('alert').getByText('expected 1 to 1000 px/s2, found 2000').waitFor();
      await page.keyboard.press('Escape');
      await command(page, "Reset the level's rules");
      await verdict(page, 'completable');
      await until(() => expect(file('01').rules).toBeUndefined());
      // consecutive keys are one step, and so is typing; in a field, Ctrl Z undoes text
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('Control+z');
      await until(() => expect(file('01').rules).toEqual({ pull: 45, speedLimit: 10 }));
      await page.keyboard.press('Control+z');
      await page.keyboard.press('Control+z');
      await until(() => expect(file('01').rules).toBeUndefined());
      await verdict(page, 'completable');
    }),
  );

  it(
    'those of gq.config.json apply, show their source, and are updated while the page is open',
    on(
      { '01': swing(), '02': swing({ name: 'Own', rules: { pull: 39 } }) },
      async ({ page, folder, file }) => {
        const listed = page.getByRole('tree', { name: 'Levels' });
        const byCommand = async () => {
          const { stdout } = await gq(['check', '.', '--format', 'json'], { cwd: folder });
          return (JSON.parse(stdout) as { levels: { verdict: string }[] }).levels.map((level) => level.verdict);
        };
        await verdict(page, 'broken');
        await listed.getByRole('treeitem', { name: /First Swing broken/ }).waitFor();
        await listed.getByRole('treeitem', { name: /Own completable/ }).waitFor();
        expect(await byCommand()).toEqual(['broken', 'completable']);
        await reads(page, 'pull', '45');
        await rule(page, 'pull').getByText("From gq.config.json; the game's default is 39.").waitFor();

        // the level's own value takes precedence, and a reset returns to that of the folder
        await field(page, 'pull').fill('39');
        await field(page, 'pull').press('Enter');
        await verdict(page, 'completable');
        await rule(page, 'pull').getByText('Set by this level; gq.config.json has 45.').waitFor();
        await until(() => expect(file('01').rules).toEqual({ pull: 39 }));
        if (shots !== undefined) await page.screenshot({ path: `${shots}/3-over-config.png` });
        for (const colorScheme of ['dark', 'light'] as const) {
          await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
          await until(async () => expect(await page.locator('html').getAttribute('data-theme')).toBe(colorScheme));
          expect(await complaintsAbout(page, colorScheme, '.inspector')).toEqual([]);
        }
        await rule(page, 'pull').getByRole('button', { name: 'Reset pull' }).click();
        await verdict(page, 'broken');
        await until(() => expect(file('01').rules).toBeUndefined());

        // another program changes the configuration
        put(folder, CONFIG, config({ pull: 38 }));
        await verdict(page, 'completable');
        await reads(page, 'pull', '38');
        await listed.getByRole('treeitem', { name: /First Swing completable/ }).waitFor();
        await messages(page)
          .getByText('gq.config.json has changed: levels without rules of their own now use pull 38 px/s2.')
          .waitFor();

        // an error is shown with its place, and the previous rules still apply
        await field(page, 'push').fill('30');
        await field(page, 'push').press('Enter');
        put(folder, CONFIG, '{\n  "rules": { "pul": 3 }\n}\n');
        await messages(page)
          .getByText(/gq\.config\.json:2:14: .*did you mean "pull"/i)
          .waitFor();
        await reads(page, 'pull', '38');
        await verdict(page, 'completable');
        await until(() => expect(file('01').rules).toEqual({ push: 30 }));
        if (shots !== undefined) await page.screenshot({ path: `${shots}/4-bad-config.png` });
        put(folder, CONFIG, config({ pull: 45 }));
        await verdict(page, 'broken');
        await messages(page)
          .getByText(/gq\.config\.json:2:14/)
          .waitFor({ state: 'hidden' });

        rmSync(join(folder, CONFIG));
        await verdict(page, 'completable');
        await reads(page, 'pull', '39');
        expect(await byCommand()).toEqual(['completable', 'completable']);
      },
      // started in the folder, so that the page names the file as gq does
      { others: { [CONFIG]: config({ pull: 45 }) }, ownProcess: true },
    ),
  );

  it(
    'links and files contain the rules of the folder; a level from a link keeps its rules',
    on(
      { '01': swing(), '02': swing({ name: 'Own', rules: { pull: 39 } }) },
      async ({ page, folder, file }) => {
        await verdict(page, 'broken');
        await command(page, 'Import, export, link');
        const dialog = page.getByRole('dialog', { name: 'Import, export, link' });
        await dialog.getByRole('tab', { name: 'Link' }).click();
        await dialog.getByText(/The link includes the rules of gq\.config\.json/).waitFor();
        const link = await dialog.getByRole('textbox', { name: 'Link with the level' }).inputValue();
        await dialog.getByRole('tab', { name: 'Export' }).click();
        await dialog.getByRole('button', { name: 'Copy as text' }).click();
        await until(async () =>
          expect(JSON.parse(await page.evaluate(() => navigator.clipboard.readText()))).toMatchObject({ rules: { pull: 45 } }),
        );
        await dialog.getByRole('checkbox', { name: /include the rules of gq\.config\.json/ }).uncheck();
        await dialog.getByRole('button', { name: 'Copy as text' }).click();
        await until(async () =>
          expect(JSON.parse(await page.evaluate(() => navigator.clipboard.readText()))).not.toHaveProperty('rules'),
        );
        await page.keyboard.press('Escape');

        // the same link in a folder without configuration, and a link from there
        put(folder, CONFIG, config({}));
        await verdict(page, 'completable');
        const hash = new URL(link).hash;
        const take = async (fragment: string) => {
          await page.evaluate((text) => {
            location.hash = text;
          }, fragment);
          const asked = page.getByRole('dialog', { name: 'Add the level from the link?' });
          const words = await asked.locator('dd').last();
          await until(async () => expect(await words.textContent()).not.toContain('…'));
          const said = await words.textContent();
          await asked.getByRole('button', { name: 'Add level' }).click();
          await asked.waitFor({ state: 'hidden' });
          return said;
        };
        expect(await take(hash)).toBe('broken');
        await until(() => expect(file('first-swing').rules).toEqual({ pull: 45 }));

        await page.getByRole('treeitem', { name: /First Swing completable/ }).click();
        // the other level of this name, which is broken, stays on the screen until this one is ready
        await verdict(page, 'completable');
        await command(page, 'Import, export, link');
        await dialog.getByRole('tab', { name: 'Link' }).click();
        const plain = await dialog.getByRole('textbox', { name: 'Link with the level' }).inputValue();
        await page.keyboard.press('Escape');
        put(folder, CONFIG, config({ pull: 45 }));
        await verdict(page, 'broken');
        expect(await take(new URL(plain).hash)).toBe('completable');
        await until(() => expect(file('first-swing-2').rules).toEqual({ pull: 39 }));
        await verdict(page, 'completable');
      },
      { others: { [CONFIG]: config({ pull: 45 }) }, ownProcess: true },
    ),
  );

  it(
    'a finger sets a rule by a tap or by one drag along the slider; an upward drag only scrolls the panel',
    on(
      { '01': swing() },
      async ({ page, context, file }) => {
        await verdict(page, 'completable');
        await command(page, 'Go to rules');
        const devtools = await context.newCDPSession(page);
        const places = async () => {
          await until(async () => {
            const one = await slider(page, 'pull').boundingBox();
            await nextFrames(page);
            expect(await slider(page, 'pull').boundingBox()).toEqual(one);
          });
          const box = await slider(page, 'pull').boundingBox();
          if (box === null) throw new Error('the slider is not seen');
          return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
        };
        const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', x?: number, y?: number) =>
          devtools.send('Input.dispatchTouchEvent', { type, touchPoints: x === undefined ? [] : [{ x, y: y ?? 0 }] });
        const swipe = async (from: number, dx: number, dy: number) => {
          const middle = await places();
          const [x, y] = [middle.x + from, middle.y];
          await touch('touchStart', x, y);
          for (let i = 1; i <= 6; i++) await touch('touchMove', x + (dx * i) / 6, y + (dy * i) / 6);
          await touch('touchEnd');
        };
        const { y: before } = await places();
        await swipe(60, 0, -120);
        await reads(page, 'pull', '39');
        await until(async () => expect((await places()).y).toBeLessThan(before));
        await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();

        await rule(page, 'pull').evaluate((one) => one.scrollIntoView({ block: 'center' }));
        await swipe(0, 60, 4);
        await verdict(page, 'broken');
        await until(() => expect(file('01').rules?.pull).toBeGreaterThan(41));
        await page.getByRole('button', { name: /^Undo: Set pull/ }).tap();
        await verdict(page, 'completable');
        await reads(page, 'pull', '39');

        const { x, y } = await places();
        await page.touchscreen.tap(x + 60, y);
        await verdict(page, 'broken');
        await rule(page, 'pull').getByRole('button', { name: 'Reset pull' }).tap();
        await verdict(page, 'completable');
        await until(() => expect(file('01').rules).toBeUndefined());
      },
      { context: { viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true } },
    ),
  );

  it(
    'the collision box on the canvas has the size of the folder',
    on(
      { '01': swing() },
      async ({ page, canvas, file }) => {
        await reads(page, 'box width', '120');
        await canvas.fit({ ...file('01'), rules: BOX });
        // outside of the game's box, within that of the folder
        await canvas.click({ x: 500 + 40, y: 760 });
        await page.getByRole('heading', { level: 3, name: 'Astronaut' }).waitFor();
      },
      { others: { [CONFIG]: config(BOX) } },
    ),
  );
});
