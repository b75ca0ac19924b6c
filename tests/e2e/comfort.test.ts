import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { command, tool, verdict } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const theme = (page: Page) => page.locator('html').getAttribute('data-theme');
const motion = (page: Page) => page.locator('html').getAttribute('data-motion');

inChromium('comfort in Chromium', ({ on }) => {
  it(
    'every command has a name in the palette, and every key is on the cheat sheet',
    on({ '01': garden() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      await command(page, 'Select all');
      await page.keyboard.press('Control+k');
      const palette = page.getByRole('dialog', { name: 'Commands' });
      await palette.getByRole('combobox').fill('dupl');
      await palette.getByRole('option', { name: /^Duplicate ?Edit ?Ctrl/ }).waitFor();
      await page.keyboard.press('Enter');
      await until(() => expect(file('01').asteroids).toHaveLength(6));
      await page.keyboard.press('Control+k');
      await palette.getByRole('combobox').fill('no such thing');
      await palette.getByText('No results.').waitFor();
      await page.keyboard.press('Escape');
      await palette.waitFor({ state: 'hidden' });

      // an unavailable command says what it needs, and Enter does nothing
      await page.keyboard.press('Escape');
      await page.keyboard.press('Control+k');
      await palette.getByRole('combobox').fill('align');
      const align = palette.getByRole('option', { name: /^Align left/ });
      await align.getByText('select two objects first').waitFor();
      expect(await align.getAttribute('aria-disabled')).toBe('true');
      await page.keyboard.press('Enter');
      expect(await palette.isVisible()).toBe(true);
      await page.keyboard.press('Escape');
      await command(page, 'Select all');
      await page.keyboard.press('Control+k');
      await palette.getByRole('combobox').fill('align');
      await align.waitFor();
      expect(await align.getAttribute('aria-disabled')).toBe('false');
      await page.keyboard.press('Escape');
      await palette.waitFor({ state: 'hidden' });

      await page.keyboard.press('?');
      const sheet = page.getByRole('dialog', { name: 'Shortcuts and gestures' });
      for (const text of ['Undo', 'Duplicate', 'Play from the start', 'Ctrl+D', 'drag its rim', 'move a copy']) {
        await sheet.getByText(text, { exact: true }).first().waitFor();
      }
      await page.keyboard.press('Escape');
      await sheet.waitFor({ state: 'hidden' });
      await page.getByRole('button', { name: 'Shortcuts and gestures' }).click();
      await sheet.waitFor();
    }),
  );

  it(
    'the palette finds levels, runs and objects by name',
    on({ '01': garden(), '02': straight() }, async ({ page, canvas, file }) => {
      await canvas.fit(file('01'));
      const palette = page.getByRole('dialog', { name: 'Commands' });
      const go = async (query: string, option: RegExp) => {
        await page.keyboard.press('Control+k');
        await palette.getByRole('combobox').fill(query);
        await palette.getByRole('option', { name: option }).waitFor();
        await page.keyboard.press('Enter');
        await palette.waitFor({ state: 'hidden' });
      };
      await go('asteroid b1', /^Asteroid 2/);
      await page.getByRole('heading', { name: 'Asteroid 2' }).waitFor();
      await go('straight', /^Straight/);
      await page.getByText('reaches the black hole').first().waitFor();
      await go('solution', /^solution ?Run ?1 hold/);
      expect(await page.getByRole('combobox', { name: 'Run' }).inputValue()).toBe('solution');
    }),
  );

  it(
    'theme, reduced motion and grid follow the system or the setting, and are kept',
    on(
      { '01': garden() },
      async ({ page, canvas, file }) => {
        await until(async () => expect([await theme(page), await motion(page)]).toEqual(['light', 'less']));
        await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'no-preference' });
        await until(async () => expect([await theme(page), await motion(page)]).toEqual(['dark', 'full']));
        await page.getByRole('button', { name: 'Settings' }).click();
        const settings = page.getByRole('dialog', { name: 'Settings' });
        await settings.getByLabel('Theme').selectOption('light');
        await settings.getByLabel('Motion').selectOption('yes');
        await settings.getByLabel('Snap to other objects').uncheck();
        await settings.getByRole('textbox', { name: 'Grid' }).fill('50');
        await page.keyboard.press('Enter');
        await page.keyboard.press('Escape');
        await settings.waitFor({ state: 'hidden' });
        await until(async () => expect([await theme(page), await motion(page)]).toEqual(['light', 'less']));
        await page.getByText('grid 50').waitFor();
        await page.reload();
        await canvas.fit(file('01'));
        expect([await theme(page), await motion(page)]).toEqual(['light', 'less']);
        await canvas.drag({ x: 400, y: 200 }, { to: [{ x: 441, y: 268 }] });
        await until(() => expect(file('01').asteroids?.[0]).toMatchObject({ x: 450, y: 250 }));
        await command(page, 'Switch between light and dark');
        await until(async () => expect(await theme(page)).toBe('dark'));
        await page.keyboard.press('Shift+g');
        await page.getByText('grid off').waitFor();
      },
      { context: { colorScheme: 'light', reducedMotion: 'reduce' } },
    ),
  );

  it(
    'on a phone, a finger pans, two pinch, a tap selects and places, and panels appear one at a time',
    on(
      { '01': garden() },
      async ({ page, canvas, file }) => {
        await canvas.fit(file('01'));
        // the whole toolbar is there in two rows, with the palette
        const rows = new Set<number>();
        for (const item of await page.locator('.topbar > *:visible').all()) {
          const box = await item.boundingBox();
          if (box !== null && box.width > 0) rows.add(Math.round((box.y + box.height / 2) / 30));
        }
        expect(rows.size).toBe(2);
        await page.getByRole('button', { name: 'Search all commands' }).tap();
        await page
          .getByRole('dialog', { name: 'Commands' })
          .getByRole('option', { name: /^Shortcuts and gestures/ })
          .tap();
        await page.getByRole('dialog', { name: 'Shortcuts and gestures' }).getByRole('button', { name: 'Close' }).tap();
        const touch = await page.context().newCDPSession(page);
        const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: { x: number; y: number }[]) =>
          touch.send('Input.dispatchTouchEvent', { type, touchPoints: points.map((point, id) => ({ ...point, id })) });
        const zoom = async () =>
          Number.parseInt(
            await page
              .getByText(/^\d+ %$/)
              .textContent()
              .then(String),
            10,
          );
        const before = await zoom();
        const middle = canvas.at({ x: 560, y: 360 });
        await send('touchStart', [
          { x: middle.x - 20, y: middle.y },
          { x: middle.x + 20, y: middle.y },
        ]);
        for (let by = 25; by <= 60; by += 5)
          await send('touchMove', [
            { x: middle.x - by, y: middle.y },
            { x: middle.x + by, y: middle.y },
          ]);
        await send('touchEnd', []);
        await until(async () => expect(await zoom()).toBeGreaterThan(2 * before));
        await canvas.fit(file('01'));
        // a finger on empty space moves the view
        const from = canvas.at({ x: 560, y: 360 });
        await send('touchStart', [from]);
        for (let by = 10; by <= 40; by += 10) await send('touchMove', [{ x: from.x, y: from.y + by }]);
        await send('touchEnd', []);
        const rock = canvas.at({ x: 400, y: 200 });
        await page.touchscreen.tap(rock.x, rock.y + 40);
        await page.keyboard.press('ArrowDown');
        await until(() => expect(file('01').asteroids?.[0]).toMatchObject({ x: 400, y: 201 }));
        await tool(page, 'Mineral').tap();
        await page.touchscreen.tap(from.x, from.y + 40);
        await until(() => expect(file('01').minerals).toHaveLength(2));

        const panels = page.getByRole('navigation', { name: 'Panels' });
        await panels.getByRole('button', { name: 'Levels' }).tap();
        await page.getByRole('tree', { name: 'Levels' }).waitFor();
        await panels.getByRole('button', { name: 'Timeline' }).tap();
        await page.getByRole('tree', { name: 'Levels' }).waitFor({ state: 'hidden' });
        await page.getByRole('slider', { name: 'Time' }).waitFor();
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );

  it(
    'the keyboard alone can select, place, move, fix the run, play and save',
    on({ '01': straight({ runs: [{ name: 'try', holds: [[0, 460]] }] }) }, async ({ page, file, saved }) => {
      await verdict(page, 'broken');
      const outline = page.getByRole('tree', { name: 'Objects of the level' });
      for (let i = 0; i < 40 && !(await outline.evaluate((tree) => tree.contains(document.activeElement))); i++)
        await page.keyboard.press('Tab');
      await page.keyboard.press('End');
      await page.keyboard.press('Home');
      await page.keyboard.press('ArrowDown');
      const release = page.getByRole('slider', { name: 'Release of hold 1' });
      for (let i = 0; i < 60 && !(await release.evaluate((edge) => edge === document.activeElement)); i++)
        await page.keyboard.press('Tab');
      for (let i = 0; i < 5; i++) await page.keyboard.press('Shift+ArrowRight');
      await verdict(page, 'completable');
      await until(() => expect(file('01').runs?.[0].holds).toEqual([[0, 510]]));
      await page.keyboard.press('Control+s');
      await saved();
    }),
  );

  it(
    'the tour is shown once, and takes under a minute',
    on(
      { '01': garden() },
      async ({ page }) => {
        const tour = page.getByRole('dialog', { name: /^Tour/ });
        await tour.waitFor();
        const steps = Number(/of (\d+)/.exec((await tour.getAttribute('aria-label')) ?? '')?.[1]);
        expect(steps).toBeLessThan(12);
        for (let i = 1; i < steps; i++) await tour.getByRole('button', { name: /^Next/ }).click();
        await tour.getByRole('button').last().click();
        await tour.waitFor({ state: 'hidden' });
        await page.reload();
        await page.getByRole('application', { name: 'Level canvas' }).waitFor();
        await verdict(page, 'broken');
        expect(await tour.isVisible()).toBe(false);
      },
      { firstTime: true },
    ),
  );
});
