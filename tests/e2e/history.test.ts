import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { formatLevel, type LevelFile } from '../../schema/index.ts';
import { complaintsAbout } from './axe.ts';
import { command, verdict } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const A = { x: 400, y: 200 };
const dialog = (page: Page): Locator => page.getByRole('dialog', { name: 'History', exact: true });
const rows = (page: Page): Locator => dialog(page).getByRole('treeitem', { level: 2 });
/** The first lines of all versions. */
const labels = async (page: Page): Promise<(string | null)[]> =>
  rows(page).locator('.history__steps, .history__name').allTextContents();
/** Their second lines. */
const steps = (page: Page): Promise<string[]> => rows(page).locator('.history__about-line').allTextContents();
const asteroid = (file: LevelFile, id: string) => file.asteroids?.find((one) => one.id === id);

/** Opens the history and waits until it shows as many versions. */
async function openHistory(page: Page, count: number): Promise<void> {
  await page.keyboard.press('y');
  await until(async () => expect(await rows(page).count()).toBe(count));
}

/** Moves the asteroid A to the right by as many px, in one step each, and waits until each is on disk. */
async function nudge(page: Page, read: () => LevelFile, to: readonly number[]): Promise<void> {
  for (const x of to) {
    await page.keyboard.press('ArrowRight');
    // the next key belongs to another step
    await page.keyboard.up('ArrowRight');
    await until(() => expect(asteroid(read(), 'a1')?.x).toBe(x));
  }
}

/** From now on, this page never gets around to recording anything: its history can't be used in these ways. */
const dies = (page: Page, modes: readonly string[]): Promise<void> =>
  page.evaluate((refused) => {
    const { transaction } = IDBDatabase.prototype;
    IDBDatabase.prototype.transaction = function (this: IDBDatabase, names, mode, ...rest) {
      if (this.name.endsWith('-versions') && refused.includes(mode ?? 'readonly')) throw new DOMException('dying', 'AbortError');
      return transaction.call(this, names, mode, ...rest);
    };
  }, modes);

inChromium('the history of a level in Chromium', ({ on }) => {
  it(
    'by pointer: what changed since a version is shown, one object is taken back, the version is restored, and undo reverts both',
    on({ '01': garden() }, async ({ page, canvas, file, saved }) => {
      await canvas.fit(file('01'));
      await saved();
      const original = file('01');
      await canvas.drag({ x: 400, y: 440 }, { to: [{ x: 440, y: 440 }] });
      await until(() => expect(file('01').novae?.[0].x).toBe(440));
      await canvas.click({ x: 560, y: 160 });
      await page.keyboard.press('Delete');
      await until(() => expect(asteroid(file('01'), 'b1')).toBeUndefined());
      await canvas.drag({ x: 560, y: 480 }, { to: [{ x: 520, y: 480 }] });
      await until(() => expect(file('01').minerals?.[0].x).toBe(520));
      const changed = file('01');

      await page.getByRole('button', { name: 'History of this level' }).click();
      await until(async () => expect(await rows(page).count()).toBe(4));
      expect(await labels(page)).toEqual([
        'Mineral 1 moved 40 px left',
        'Asteroid 2 removed at (560, 160)',
        'Nova 1 moved 40 px right',
        'Found when the level was opened',
      ]);
      expect(await steps(page)).toEqual([
        expect.stringMatching(/^Move/),
        expect.stringMatching(/^Delete/),
        expect.stringMatching(/^Move/),
      ]);
      await rows(page).nth(3).click();
      const detail = dialog(page).getByRole('region', { name: /^Version of / });
      await detail.getByRole('heading', { name: 'Changed since then' }).waitFor();
      const boxes = detail.getByRole('checkbox');
      await until(async () => expect(await boxes.count()).toBe(3));
      await detail.getByRole('img', { name: 'Both versions of the level' }).waitFor();
      await detail
        .getByText(/^broken: run "solution"|^completable/)
        .first()
        .waitFor();

      // the asteroid comes back with its id, between its neighbours; the others stay as they are
      await detail.getByRole('checkbox', { name: /^Asteroid 2 removed/ }).check();
      await detail.getByRole('button', { name: 'Take back 1 change' }).click();
      await detail.getByText('Taken back. Undo brings it again.').waitFor();
      await until(() => expect(file('01').asteroids?.map(({ id }) => id)).toEqual(['a1', 'b1', 'c1']));
      expect(file('01')).toEqual({ ...changed, asteroids: original.asteroids });
      await until(async () => expect(await boxes.count()).toBe(2));
      await page.keyboard.press('Escape');
      await page.getByRole('button', { name: /^Undo: Take back: Asteroid 2 removed/ }).click();
      await until(() => expect(file('01')).toEqual(changed));

      // the whole version, as one step
      await openHistory(page, 6);
      await rows(page).nth(5).click();
      await detail.getByRole('button', { name: 'Restore', exact: true }).click();
      await dialog(page).waitFor({ state: 'hidden' });
      await until(() => expect(file('01')).toEqual(original));
      await page.getByRole('button', { name: /^Undo: Restore version of \d\d:\d\d$/ }).click();
      await until(() => expect(file('01')).toEqual(changed));
      // both are steps of the history, too
      await openHistory(page, 8);
      expect((await steps(page)).slice(0, 2)).toEqual([
        expect.stringMatching(/^Undo: Restore version of /),
        expect.stringMatching(/^Restore version of /),
      ]);
    }),
  );

  it(
    'by keys: a version is named, found again after the page was closed, compared, copied, and survives a rename and the trash',
    on({ '01': garden(), '02': straight() }, async ({ page, canvas, file, open, folder, saved }) => {
      await canvas.fit(file('01'));
      await saved();
      await canvas.click(A);
      await nudge(page, () => file('01'), [401]);
      await page.keyboard.press('Shift+Y');
      await page.getByRole('dialog', { name: 'Name this version' }).getByRole('textbox', { name: 'Name' }).fill('Good start');
      await page.keyboard.press('Enter');
      await page.getByText('This version is kept as "Good start".').waitFor();
      await nudge(page, () => file('01'), [402]);
      await saved();
      await page.close();

      const again = (await open()).page;
      await again.keyboard.press('y');
      await until(async () => expect(await rows(again).count()).toBeGreaterThanOrEqual(3));
      const tree = dialog(again).getByRole('tree', { name: 'Versions' });
      await until(async () => expect(await tree.evaluate((element) => element === document.activeElement)).toBe(true));
      const index = (await labels(again)).indexOf('Good start');
      expect(index).toBeGreaterThanOrEqual(1);
      for (let i = 0; i <= index; i++) await again.keyboard.press('ArrowDown');
      const detail = dialog(again).getByRole('region', { name: /^Version of / });
      const name = detail.getByRole('textbox', { name: 'Name of this version' });
      await until(async () => expect(await name.inputValue()).toBe('Good start'));
      await detail.getByRole('checkbox', { name: 'Asteroid 1 moved 1 px right' }).waitFor();
      await name.fill('Better start');
      await again.keyboard.press('Enter');
      await until(async () => expect(await labels(again)).toContain('Better start'));
      await dialog(again)
        .getByRole('radio', { name: /^Named 1/ })
        .check();
      await until(async () => expect(await labels(again)).toEqual(['Better start']));

      await detail.getByRole('button', { name: 'Open as a copy' }).focus();
      await again.keyboard.press('Enter');
      await dialog(again).waitFor({ state: 'hidden' });
      await again.getByRole('heading', { level: 1, name: 'Garden copy' }).waitFor();
      const copies = ['03-copy', '01-copy', '03'].filter((id) => existsSync(join(folder, `${id}.level.json`)));
      expect(copies).toHaveLength(1);
      expect(asteroid(file(copies[0]), 'a1')?.x).toBe(401);
      // a copy begins anew
      await openHistory(again, 1);
      await again.keyboard.press('Escape');

      // the first level in another place of the list: its file has another number
      const levels = again.getByRole('tree', { name: 'Levels' });
      await levels.getByRole('treeitem').filter({ hasText: 'Garden' }).first().click();
      await again.getByRole('heading', { level: 1, name: 'Garden', exact: true }).waitFor();
      await levels.focus();
      await again.keyboard.press('Alt+ArrowDown');
      await again.getByRole('button', { name: 'Undo: Reorder levels' }).waitFor();
      await command(again, 'History of this level');
      await until(async () => expect(await labels(again)).toContain('Better start'));
      await again.keyboard.press('Escape');
      // deleted and restored
      await command(again, 'Delete this level');
      await again.getByText('"Garden" is deleted.').waitFor();
      await command(again, 'Deleted levels');
      await again.getByRole('dialog', { name: 'Deleted levels' }).getByRole('button', { name: 'Restore' }).click();
      await again.getByRole('heading', { level: 1, name: 'Garden', exact: true }).waitFor();
      await command(again, 'History of this level');
      await until(async () => expect(await labels(again)).toContain('Better start'));
    }),
  );

  it(
    'has what a page has saved that was closed at once, before it could record or describe it',
    on({ '01': garden() }, async ({ page, canvas, file, open, saved }) => {
      await canvas.fit(file('01'));
      await saved();
      await openHistory(page, 1);
      await page.keyboard.press('Escape');
      await dies(page, ['readonly']);
      await canvas.click(A);
      await nudge(page, () => file('01'), [401]);
      await canvas.click({ x: 560, y: 160 });
      await page.keyboard.press('Delete');
      await until(() => expect(asteroid(file('01'), 'b1')).toBeUndefined());
      await saved();
      await page.close();
      const again = (await open()).page;
      await again.getByRole('heading', { level: 1, name: 'Garden' }).waitFor();
      await openHistory(again, 3);
      expect(await labels(again)).toEqual([
        'Asteroid 2 removed at (560, 160)',
        'Asteroid 1 moved 1 px right',
        'Found when the level was opened',
      ]);
    }),
  );

  it(
    'says which versions another program wrote; while another tab writes, it can be looked at only',
    on({ '01': garden() }, async ({ page, canvas, file, write, open, saved }) => {
      await canvas.fit(file('01'));
      await saved();
      const first = file('01');
      write('01', formatLevel({ ...first, name: 'From outside' }));
      await page.getByRole('heading', { level: 1, name: 'From outside' }).waitFor();
      await openHistory(page, 2);
      await rows(page).first().click();
      await dialog(page).getByText('Written by another program.').waitFor();
      await dialog(page).getByRole('radio', { name: 'With the one before' }).check();
      await dialog(page).getByRole('listitem').filter({ hasText: 'Renamed "Garden" -> "From outside"' }).waitFor();
      await page.keyboard.press('Escape');

      const reader = (await open()).page;
      await reader.getByRole('button', { name: 'Take over' }).waitFor();
      await openHistory(reader, 2);
      await rows(reader).nth(1).click();
      await dialog(reader).getByRole('button', { name: 'Restore', exact: true }).click();
      await dialog(reader).getByText('Another tab has this level open. Take over there first.').waitFor();
      await dialog(reader).getByRole('checkbox').first().check();
      await dialog(reader).getByRole('button', { name: 'Take back 1 change' }).click();
      await dialog(reader).getByText('Another tab has this level open. Take over there first.').waitFor();
      expect(file('01').name).toBe('From outside');
    }),
  );

  it(
    'finds what changed while the page was closed, and survives a page that dies between the save and its record',
    on({ '01': garden() }, async ({ page, canvas, file, write, open, saved }) => {
      await canvas.fit(file('01'));
      await saved();
      await openHistory(page, 1);
      await page.keyboard.press('Escape');
      await dies(page, ['readonly', 'readwrite']);
      await canvas.click(A);
      await nudge(page, () => file('01'), [401, 402]);
      await saved();
      await page.close();
      write('01', formatLevel({ ...file('01'), name: 'Pulled' }));
      const again = (await open()).page;
      await again.getByRole('heading', { level: 1, name: 'Pulled' }).waitFor();
      await again.keyboard.press('y');
      const changed = 'Renamed "Garden" -> "Pulled"; asteroid 1 moved 2 px right';
      await until(async () => expect((await labels(again))[0]).toBe(changed));
      expect((await steps(again))[0]).toBe('Found when the level was opened');
      await rows(again).first().click();
      await dialog(again)
        .getByText(/^It was there when the level was opened/)
        .waitFor();
      await until(async () => expect(await rows(again).count()).toBe(2));
    }),
  );

  it(
    'has hundreds of versions, of which only the visible ones are in the page; they come from a file and go into one',
    on({ '01': garden() }, async ({ page, file, folder }) => {
      const text = (x: number) => formatLevel({ ...file('01'), blackHole: { x, y: 304 } });
      const start = Date.now() - 50 * 60_000;
      const versions = Array.from({ length: 300 }, (_, i) => ({
        ...{ time: start + i * 1000, by: 'page', labels: [`Step ${i}`], more: 0, name: i === 100 ? 'Kept' : null },
        text: text(905 + i),
      }));
      const content = JSON.stringify({ gravityQuestHistory: 1, level: '01', versions: [...versions, { time: 'x' }] });
      await openHistory(page, 1);
      const [chooser] = await Promise.all([
        page.waitForEvent('filechooser'),
        dialog(page).getByRole('button', { name: 'Import' }).click(),
      ]);
      await chooser.setFiles({ name: 'old.history.json', mimeType: 'application/json', buffer: Buffer.from(content) });
      await dialog(page).getByText('300 versions added (1 unreadable).').waitFor();
      await dialog(page).getByRole('radio', { name: 'All 301' }).waitFor();
      expect(await rows(page).count()).toBeLessThan(60);
      await page.keyboard.press('Escape');
      await openHistoryAgain(page);
      await dialog(page)
        .getByRole('radio', { name: /^Named 1/ })
        .check();
      await rows(page).filter({ hasText: 'Kept' }).click();
      await dialog(page).getByText('Black hole moved 101 px left').waitFor();
      const [download] = await Promise.all([
        page.waitForEvent('download'),
        dialog(page).getByRole('button', { name: 'Export' }).click(),
      ]);
      const path = join(folder, '..', `${Date.now()}.history.json`);
      await download.saveAs(path);
      const exported = JSON.parse(readFileSync(path, 'utf8')) as { versions: { text: string; name: string | null }[] };
      expect(exported.versions).toHaveLength(301);
      expect(exported.versions.slice(0, 300).map((version) => version.text)).toEqual(versions.map((version) => version.text));
      expect(exported.versions[100].name).toBe('Kept');
    }),
  );

  it(
    'is accessible, in both themes and on a phone, where the list gives way to the version',
    on(
      { '01': garden() },
      async ({ page, canvas, file, saved }) => {
        await canvas.fit(file('01'));
        await saved();
        await canvas.click(A);
        await page.keyboard.press('ArrowRight');
        await until(() => expect(asteroid(file('01'), 'a1')?.x).toBe(401));
        await page.keyboard.press('Shift+Y');
        await page.getByRole('dialog', { name: 'Name this version' }).waitFor();
        const complaints = await complaintsAbout(page, 'the name', '[role=dialog]');
        await page.getByRole('textbox', { name: 'Name' }).fill('One');
        await page.keyboard.press('Enter');
        await page.getByText('This version is kept as "One".').waitFor();
        await openHistory(page, 2);
        complaints.push(...(await complaintsAbout(page, 'the list', '[role=dialog]')));
        await rows(page).nth(1).click();
        await dialog(page).getByRole('img', { name: 'Both versions of the level' }).waitFor();
        await dialog(page).getByRole('checkbox').first().check();
        for (const theme of ['dark', 'light']) {
          await page.evaluate((name) => document.documentElement.setAttribute('data-theme', name), theme);
          await dialog(page).getByRole('img', { name: 'Both versions of the level' }).waitFor();
          complaints.push(...(await complaintsAbout(page, `a version, ${theme}`, '[role=dialog]')));
        }
        await page.setViewportSize({ width: 390, height: 844 });
        await until(async () => expect(await dialog(page).getByRole('tree').isVisible()).toBe(false));
        complaints.push(...(await complaintsAbout(page, 'a version on a phone', '[role=dialog]')));
        await dialog(page).getByRole('button', { name: 'Back to the list' }).click();
        await dialog(page).getByRole('tree').waitFor();
        complaints.push(...(await complaintsAbout(page, 'the list on a phone', '[role=dialog]')));
        expect(complaints).toEqual([]);
        await page.keyboard.press('Escape');
        await dialog(page).waitFor({ state: 'hidden' });
      },
      { context: { hasTouch: true } },
    ),
  );

  it(
    'without a database lasts as long as the page, and says so',
    on(
      { '01': garden() },
      async (next) => {
        const { file } = next;
        await next.canvas.fit(file('01'));
        await next.canvas.click(A);
        await nudge(next.page, () => file('01'), [401]);
        await openHistory(next.page, 2);
        await dialog(next.page)
          .getByText(/^This browser stores no data for this page/)
          .waitFor();
        await rows(next.page).nth(1).click();
        await dialog(next.page).getByRole('button', { name: 'Restore', exact: true }).click();
        await until(() => expect(asteroid(file('01'), 'a1')?.x).toBe(400));
        await verdict(next.page, 'broken');
      },
      { before: withoutVersions },
    ),
  );
});

/** Runs in a page before its own scripts: the browser refuses the database of versions. */
function withoutVersions(): void {
  const { open } = IDBFactory.prototype;
  IDBFactory.prototype.open = function (this: IDBFactory, name: string, version?: number) {
    if (name.endsWith('-versions')) throw new DOMException('denied', 'SecurityError');
    return open.call(this, name, version);
  };
}

async function openHistoryAgain(page: Page): Promise<void> {
  await page.keyboard.press('y');
  await dialog(page)
    .getByRole('radio', { name: /^All 301/ })
    .waitFor();
}
