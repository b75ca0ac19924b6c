import { chmodSync, existsSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { verdict } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

/** The browser logs every request without an answer or with a refusal. */
const OUTAGE = /Failed to load resource|ERR_/;

const A = { x: 400, y: 200 };

/** Where a tab keeps the key of the folder. */
const KEY = 'gravity-quest-editor-key';
const hasKey = (page: Page) => page.waitForFunction((name) => sessionStorage.getItem(name) !== null, KEY);

const saving = (page: Page, text: RegExp) => page.getByRole('status', { name: 'Saving' }).filter({ hasText: text }).waitFor();
const placeOf = (file: LevelFile, id: string) => file.asteroids?.find((one) => one.id === id);

inChromium('work is not lost, in Chromium', ({ on }) => {
  it(
    'changes by another program appear at once; separate changes by both are merged',
    on(
      { '01': garden() },
      async ({ page, canvas, file, open, write, saved, endServer, startServer }) => {
        await canvas.fit(file('01'));
        write('01', garden({ name: 'From outside' }));
        await page.getByRole('heading', { level: 1, name: 'From outside' }).waitFor();
        await page.keyboard.press('Control+z');
        await page.getByRole('heading', { level: 1, name: 'Garden' }).waitFor();
        await saved();
        await until(() => expect(file('01').name).toBe('Garden'));

        // while writing is paused, both change a different asteroid
        await endServer();
        await canvas.click(A);
        await page.keyboard.press('ArrowDown');
        await saving(page, /disconnected, kept in this browser/);
        const theirs = file('01');
        write('01', formatLevel({ ...theirs, blackHole: { ...theirs.blackHole, y: 320 } }));
        await page.close();
        await startServer();
        const again = await open();
        await saving(again.page, /^saved$/);
        await until(() => expect(file('01').blackHole.y).toBe(320));
        await until(() => expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y: 201 }));
      },
      { complaints: OUTAGE },
    ),
  );

  it(
    'unsaved changes are reported as kept once they are, with the place; a page that dies recovers them, and undo reverts them',
    on(
      { '01': garden() },
      async ({ page, canvas, file, open, saved, endServer, startServer, server }) => {
        await canvas.fit(file('01'));
        await saved();
        const { port } = server();
        await endServer();
        await canvas.click(A);
        for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowDown');
        await saving(page, /disconnected, kept in this browser/);
        await page
          .getByRole('list', { name: 'Messages' })
          .getByText(new RegExp(`kept in this browser for 127.0.0.1:${port}.*--port ${port}`))
          .waitFor();
        expect(placeOf(file('01'), 'a1')).toMatchObject(A);
        await page.close();
        await startServer(port);
        const again = await open();
        await until(() => expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y: 203 }));
        await saving(again.page, /^saved$/);
        await again.page.getByRole('button', { name: /^Undo: Recovered/ }).click();
        await until(() => expect(placeOf(file('01'), 'a1')).toMatchObject(A));
      },
      { complaints: OUTAGE },
    ),
  );

  it(
    'a page that alone has a change asks before it is left',
    on(
      { '01': garden() },
      async ({ page: first, file, open, endServer, context }) => {
        await first.close();
        await context.addInitScript("Object.defineProperty(window, 'indexedDB', { value: undefined })");
        const { page, canvas } = await open();
        await saving(page, /^saved$/);
        await canvas.fit(file('01'));
        await endServer();
        await canvas.click(A);
        await page.keyboard.press('ArrowDown');
        await saving(page, /disconnected, in this tab only/);
        const asked = page.waitForEvent('dialog');
        await page.close({ runBeforeUnload: true });
        const dialog = await asked;
        expect(dialog.type()).toBe('beforeunload');
        await dialog.dismiss();
        await saving(page, /disconnected, in this tab only/);
      },
      { complaints: OUTAGE },
    ),
  );

  it(
    'no address contains the token after the page has read it or was reloaded; without it the page says what to open',
    on(
      { '01': garden() },
      async ({ page, saved, context, server }) => {
        await saved();
        const bare = new URL('/', server().address).href;
        expect(page.url()).toBe(bare);
        await page.reload();
        await saved();
        expect(page.url()).toBe(bare);
        // a bookmark or a new tab
        const other = await context.newPage();
        await other.goto(bare);
        await other
          .getByRole('main')
          .getByText(/lacks the key.*Open the address that gq edit printed last, or start gq edit again/)
          .waitFor();
        expect(await other.getByRole('treeitem').count()).toBe(0);
        await other.goto(server().address);
        // only the fragment differs, so the page reloads itself
        await saving(other, /^read-only$/);
      },
      { complaints: OUTAGE },
    ),
  );

  it(
    'changes of a level that is not opened again are listed with their place, and can be saved as a file',
    on(
      { '01': garden(), '02': straight() },
      async ({ page, canvas, file, open, saved, endServer, startServer, server, context }) => {
        await canvas.fit(file('01'));
        await saved();
        const { port } = server();
        await endServer();
        await canvas.click(A);
        await page.keyboard.press('ArrowDown');
        await saving(page, /disconnected, kept in this browser/);
        await page.close();
        await startServer(port);
        await context.addInitScript("sessionStorage.setItem('gravity-quest-last-level', '02')");
        const again = await open();
        await saving(again.page, /^saved$/);
        await again.page.getByText(`Unsaved changes to 01 are kept in this browser for 127.0.0.1:${port}.`).waitFor();
        await again.page.getByRole('button', { name: 'Review' }).click();
        const dialog = again.page.getByRole('dialog', { name: 'Unsaved changes' });
        const [download] = await Promise.all([
          again.page.waitForEvent('download'),
          dialog.getByRole('button', { name: 'Download' }).click(),
        ]);
        expect(placeOf(JSON.parse(readFileSync(await download.path(), 'utf8')), 'a1')).toMatchObject({ x: 400, y: 201 });
        expect(placeOf(file('01'), 'a1')).toMatchObject(A);
        await dialog.getByRole('button', { name: 'Open' }).click();
        await until(() => expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y: 201 }));
      },
      { complaints: OUTAGE },
    ),
  );

  it(
    'a page whose server was restarted is let in again, and what was changed in between is saved',
    on(
      { '01': garden() },
      async ({ page, canvas, file, saved, endServer, startServer, server }) => {
        await canvas.fit(file('01'));
        await saved();
        await hasKey(page);
        const notices = page.getByRole('list', { name: 'Messages' });
        for (const y of [201, 202]) {
          const { port } = server();
          await endServer();
          await notices.getByText(/gq edit does not answer/).waitFor();
          await canvas.click(A);
          await page.keyboard.press('ArrowDown');
          await saving(page, /disconnected, kept in this browser/);
          expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y: y - 1 });
          await startServer(port);
          await saving(page, /^saved$/);
          expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y });
          await until(async () => expect(await notices.getByRole('listitem').count()).toBe(0));
        }
        // the tab has the new token, too
        await page.reload();
        await saved();
        await page.getByRole('heading', { level: 1, name: 'Garden' }).waitFor();
      },
      { complaints: OUTAGE, ownProcess: true },
    ),
  );

  it(
    'a page whose server was restarted with another key says so, and its unsaved changes move to the new page',
    on(
      { '01': garden() },
      async ({ page, canvas, file, open, saved, endServer, startServer, server }) => {
        await canvas.fit(file('01'));
        await saved();
        await hasKey(page);
        await page.evaluate((name) => sessionStorage.setItem(name, 'k'.repeat(43)), KEY);
        const { port } = server();
        const notices = page.getByRole('list', { name: 'Messages' });
        await endServer();
        await notices.getByText(/gq edit does not answer/).waitFor();
        await startServer(port);
        await notices.getByText(/belongs to the previous start.*Open the address that gq edit prints now/).waitFor();
        expect(await notices.getByText(/does not answer/).count()).toBe(0);
        await canvas.click(A);
        await page.keyboard.press('ArrowDown');
        await saving(page, /^not saved$/);
        expect(placeOf(file('01'), 'a1')).toMatchObject(A);
        await page.reload();
        await page
          .getByRole('main')
          .getByText(/belongs to another run of gq edit. Open the address/)
          .waitFor();
        const again = await open();
        await saving(again.page, /^saved$/);
        await until(() => expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y: 201 }));
      },
      { complaints: OUTAGE },
    ),
  );

  it(
    'a file that is not writable says so, and once it is, changes are saved automatically',
    on(
      { '01': garden() },
      async ({ page, canvas, file, folder }) => {
        await saving(page, /^read-only$/);
        await canvas.fit(file('01'));
        await canvas.click(A);
        await page.keyboard.press('ArrowDown');
        await saving(page, /^read-only$/);
        expect(placeOf(file('01'), 'a1')).toMatchObject(A);
        chmodSync(join(folder, '01.level.json'), 0o666);
        chmodSync(folder, 0o777);
        await saving(page, /^saved$/);
        expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y: 201 });
      },
      { readOnly: true, complaints: OUTAGE },
    ),
  );

  it(
    'of two tabs, one writes; the other follows and can take over',
    on({ '01': garden() }, async ({ page, canvas, file, open, saved }) => {
      await saved();
      // a page that starts while another is still opening the level asks before it opens it, too
      await page.waitForFunction(() => !localStorage.getItem('gravity-quest-editor-opening')?.includes('"'));
      const other = await open();
      await saving(other.page, /^read-only$/);
      await canvas.fit(file('01'));
      await canvas.click(A);
      await page.keyboard.press('Shift+ArrowDown');
      await until(() => expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y: 208 }));
      await other.page.bringToFront();
      await other.page.getByRole('button', { name: 'Take over' }).click();
      await saving(page, /^read-only$/);
      await saving(other.page, /^saved$/);
      await other.canvas.fit(file('01'));
      await other.canvas.click({ x: 400, y: 208 });
      await other.page.keyboard.press('Shift+ArrowDown');
      await until(() => expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y: 216 }));
      // the reader shows the change
      await other.page.close();
      await saving(page, /^saved$/);
      await page.bringToFront();
      await canvas.click({ x: 400, y: 216 });
      await page.keyboard.press('ArrowDown');
      await until(() => expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 400, y: 217 }));
    }),
  );

  it(
    'if both changed the same property, the user chooses',
    on({ '01': garden() }, async ({ page, canvas, file, write, saved }) => {
      await canvas.fit(file('01'));
      await saved();
      // the file changes during a drag: either the drag wins or the user is asked
      const { x, y } = canvas.at(A);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 3, y + 60, { steps: 4 });
      const before = file('01');
      const moved = (before.asteroids ?? []).map((one) => (one.id === 'a1' ? { ...one, x: 300, y: 120 } : one));
      write('01', formatLevel({ ...before, asteroids: moved }));
      await saving(page, /^conflict$/);
      await page.mouse.up();
      expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 300, y: 120 });
      const dialog = page.getByRole('dialog', { name: 'Two versions of this level' });
      await page.getByRole('button', { name: 'Resolve' }).click();
      await dialog
        .getByRole('button', { name: /theirs|disk/i })
        .first()
        .click();
      await dialog.getByRole('button', { name: /^Merge|^Write/ }).click();
      await saved();
      expect(placeOf(file('01'), 'a1')).toMatchObject({ x: 300, y: 120 });
      await page.keyboard.press('Control+z');
      await until(() => expect(placeOf(file('01'), 'a1')?.y).toBeGreaterThan(200));
    }),
  );

  it(
    'a file with errors is listed, can be fixed as text, and is not written before it is valid',
    on({ '01': garden(), '02': '{ "version": 1, "name": "Torn", ' }, async ({ page, text, file, saved }) => {
      await saved();
      const torn = text('02');
      await page.getByRole('tree', { name: 'Levels' }).getByRole('treeitem', { name: /02/ }).click();
      const dialog = page.getByRole('dialog', { name: '02.level.json' });
      await dialog.getByRole('list', { name: 'Problems' }).getByRole('button').first().waitFor();
      const area = dialog.getByRole('textbox', { name: 'Text of the level' });
      expect(await area.inputValue()).toBe(torn);
      expect(text('02')).toBe(torn);
      await area.fill(JSON.stringify(straight({ name: 'Mended' })));
      await dialog.getByText('A valid level.', { exact: true }).waitFor();
      await dialog.getByRole('button', { name: 'Save' }).click();
      await until(() => expect(file('02').name).toBe('Mended'));
      await page.getByRole('heading', { level: 1, name: 'Mended' }).waitFor();
      await verdict(page, 'completable');
    }),
  );

  it(
    'a file that vanishes is reported, and can be written again',
    on(
      { '01': garden(), '02': straight() },
      async ({ page, folder, file, saved }) => {
        await saved();
        rmSync(join(folder, '01.level.json'));
        await saving(page, /^deleted on disk$/);
        const dialog = page.getByRole('dialog', { name: 'The file was deleted' });
        await page.getByRole('button', { name: 'Resolve' }).click();
        expect(existsSync(join(folder, '01.level.json'))).toBe(false);
        await dialog
          .getByRole('button', { name: /^(Write|Keep|Put|Restore)/ })
          .first()
          .click();
        await saved();
        expect(file('01').name).toBe('Garden');
      },
      { complaints: OUTAGE },
    ),
  );
});
