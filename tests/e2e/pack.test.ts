import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import type { PackFile } from '../../schema/index.ts';
import { gq } from '../cli/gq.ts';
import { complaintsAbout } from './axe.ts';
import { command, verdict } from './commands.ts';
import { nextFrames } from './frames.ts';
import { garden, near, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const pack = (...levels: PackFile['levels']): string => JSON.stringify({ version: 1, name: 'My game', levels });
/** Each has one thing that players may not know yet, the same in all: nothing is wrong with any order. */
const FOUR = {
  a: straight({ name: 'Ann', novae: [] }),
  b: straight({ name: 'Bob', novae: [] }),
  c: straight({ name: 'Cat', novae: [] }),
  d: straight({ name: 'Dog', novae: [] }),
};

/** The view of all levels, opened by its key. */
async function show(page: Page): Promise<Locator> {
  await verdict(page, 'completable');
  await page.getByRole('application', { name: 'Level canvas' }).focus();
  await page.keyboard.press('Shift+P');
  const view = page.getByRole('dialog', { name: 'Pack' });
  await view.waitFor();
  return view;
}

const cards = (view: Locator) => view.locator('[role=option][data-key]');
const card = (view: Locator, name: string) => cards(view).filter({ has: view.page().getByText(name, { exact: true }) });
const namesIn = (view: Locator) => cards(view).locator('.pack__name').allTextContents();
/** Waits until a card says this. */
const says = (view: Locator, name: string, words: RegExp) => card(view, name).filter({ hasText: words }).waitFor();
const hasFocus = (one: Locator) =>
  until(async () => expect(await one.evaluate((it) => it === document.activeElement)).toBe(true));
const shows = (view: Locator, ...names: string[]) => until(async () => expect(await namesIn(view)).toEqual(names));
const entriesOf = (folder: string): PackFile['levels'] | null => {
  const path = join(folder, 'pack.json');
  return existsSync(path) ? (JSON.parse(readFileSync(path, 'utf8')) as PackFile).levels : null;
};
const onDisk = (folder: string, ...levels: PackFile['levels']) => until(() => expect(entriesOf(folder)).toEqual(levels));

inChromium('the pack in Chromium', ({ on }) => {
  it(
    'by keys: levels are moved one by one and several at once, undone, and opened; Esc closes the view',
    on(
      FOUR,
      async ({ page, folder }) => {
        const view = await show(page);
        await shows(view, 'Ann', 'Bob', 'Cat', 'Dog');
        await hasFocus(card(view, 'Ann'));
        await page.keyboard.press('Alt+ArrowRight');
        await shows(view, 'Bob', 'Ann', 'Cat', 'Dog');
        await onDisk(folder, 'b', 'a', 'c', 'd');
        await view.getByRole('status').filter({ hasText: 'Moved "Ann"' }).waitFor({ state: 'attached' });
        // the focus stays on the level, which goes on
        await page.keyboard.press('Alt+End');
        await shows(view, 'Bob', 'Cat', 'Dog', 'Ann');
        await onDisk(folder, 'b', 'c', 'd', 'a');

        // two of them
        await page.keyboard.press('ArrowLeft');
        await page.keyboard.press('Shift+ArrowLeft');
        await view.getByText('2 selected').waitFor();
        await page.keyboard.press('Alt+ArrowUp');
        await shows(view, 'Cat', 'Dog', 'Bob', 'Ann');
        await onDisk(folder, 'c', 'd', 'b', 'a');

        // back to where there was no file
        await page.keyboard.press('Control+z');
        await shows(view, 'Bob', 'Cat', 'Dog', 'Ann');
        await page.keyboard.press('Control+z');
        await shows(view, 'Bob', 'Ann', 'Cat', 'Dog');
        await page.keyboard.press('Control+z');
        await shows(view, 'Ann', 'Bob', 'Cat', 'Dog');
        await until(() => expect(entriesOf(folder)).toBe(null));
        await page.keyboard.press('Control+Shift+z');
        await shows(view, 'Bob', 'Ann', 'Cat', 'Dog');
        await onDisk(folder, 'b', 'a', 'c', 'd');

        await card(view, 'Cat').focus();
        await page.keyboard.press('Enter');
        await view.waitFor({ state: 'hidden' });
        await page.getByRole('heading', { name: 'Cat', level: 1 }).waitFor();
        await command(page, 'Show the pack: all levels as cards');
        await view.waitFor();
        await page.keyboard.press('Escape');
        await view.waitFor({ state: 'hidden' });
        // what lies below can be used again
        await page.getByRole('button', { name: 'All levels as cards' }).click();
        await view.waitFor();
      },
      { complaints: /404/ },
    ),
  );

  it(
    'by the pointer: a level, and several, are dragged; the list of levels has the same order and no file another name',
    on(FOUR, async ({ page, folder }) => {
      const view = await show(page);
      const drag = async (name: string, to: string, side: 'before' | 'after') => {
        const from = await card(view, name).boundingBox();
        const onto = await card(view, to).boundingBox();
        if (from === null || onto === null) throw new Error('not on the screen');
        await page.mouse.move(from.x + from.width / 2, from.y + 40);
        await page.mouse.down();
        await page.mouse.move(from.x + from.width / 2 + 20, from.y + 50);
        await page.mouse.move(onto.x + (side === 'before' ? 20 : onto.width - 20), onto.y + 40, { steps: 4 });
        await until(() => view.locator(`.pack__card--${side}`).waitFor());
      };
      await drag('Dog', 'Bob', 'before');
      await page.mouse.up();
      await shows(view, 'Ann', 'Dog', 'Bob', 'Cat');
      await onDisk(folder, 'a', 'd', 'b', 'c');

      await card(view, 'Ann').click();
      await card(view, 'Bob').click({ modifiers: ['ControlOrMeta'] });
      await drag('Ann', 'Cat', 'after');
      await page.mouse.up();
      await shows(view, 'Dog', 'Cat', 'Ann', 'Bob');
      await onDisk(folder, 'd', 'c', 'a', 'b');

      // Esc gives a drag up, and the view stays
      await drag('Dog', 'Bob', 'after');
      await page.keyboard.press('Escape');
      await page.mouse.up();
      await nextFrames(page);
      await shows(view, 'Dog', 'Cat', 'Ann', 'Bob');
      await view.getByRole('button', { name: 'Close' }).click();

      const list = page.getByRole('tree', { name: 'Levels' });
      const order = (...names: string[]) =>
        until(async () => {
          const rows = await list.getByRole('treeitem').allTextContents();
          expect(rows.map((row) => names.find((name) => row.includes(name)))).toEqual(names);
        });
      await order('Dog', 'Cat', 'Ann', 'Bob');
      await list.focus();
      await page.keyboard.press('Home');
      await page.keyboard.press('Alt+ArrowDown');
      await order('Cat', 'Dog', 'Ann', 'Bob');
      await onDisk(folder, 'c', 'd', 'a', 'b');
      await page.keyboard.press('Control+z');
      await order('Dog', 'Cat', 'Ann', 'Bob');
      for (const id of ['a', 'b', 'c', 'd']) expect(existsSync(join(folder, `${id}.level.json`))).toBe(true);
    }),
  );

  it(
    'a change of pack.json on the disk is shown; a move that was made from the old one is refused in words, and nothing is lost',
    on(
      FOUR,
      async ({ page, folder }) => {
        const view = await show(page);
        await shows(view, 'Dog', 'Ann', 'Bob', 'Cat');
        writeFileSync(join(folder, 'pack.json'), pack('c', { chapter: 'Late' }, 'a', 'd', 'b'));
        await shows(view, 'Cat', 'Ann', 'Dog', 'Bob');
        await view.getByRole('textbox', { name: 'Chapter' }).waitFor();

        // the page has not heard of the next change when it writes
        await page.route(
          '**/api/pack',
          async (route) => {
            writeFileSync(join(folder, 'pack.json'), pack('b', 'a', 'd', 'c'));
            await route.continue();
          },
          { times: 1 },
        );
        await card(view, 'Ann').click();
        await page.keyboard.press('Alt+End');
        await page.getByRole('listitem').filter({ hasText: 'Another program has changed pack.json' }).waitFor();
        await shows(view, 'Bob', 'Ann', 'Dog', 'Cat');
        expect(entriesOf(folder)).toEqual(['b', 'a', 'd', 'c']);

        writeFileSync(join(folder, 'pack.json'), '{ "version": 1, "name": ');
        await view.getByRole('region', { name: 'Problems of the order' }).waitFor();
        await shows(view, 'Ann', 'Bob', 'Cat', 'Dog');
        expect(await view.getByRole('button', { name: 'Move later' }).isDisabled()).toBe(true);
      },
      { others: { 'pack.json': pack('d', 'a', 'b', 'c') }, complaints: /412/ },
    ),
  );

  it(
    'says what gq check says of the order, and goes there; chapters are made, renamed and removed',
    on(
      { ...FOUR, e: garden({ name: 'Eve' }) },
      async ({ page, folder }) => {
        const view = await show(page);
        const problems = view.getByRole('region', { name: 'Problems of the order' });
        const { stdout } = await gq(['check', folder, '--format', 'json', '--no-cache', '--no-config']);
        const wanted = (
          JSON.parse(stdout) as { packs: { problems: { message: string; line: number; column: number; code: string }[] }[] }
        ).packs[0].problems;
        expect(wanted.map(({ code }) => code)).toEqual(['pack-unlisted-level', 'pack-introduction', 'pack-missing-level']);
        await until(async () => {
          const texts = await problems.getByRole('listitem').allTextContents();
          expect(texts).toHaveLength(wanted.length);
          for (const [i, { message, line, column, code }] of wanted.entries()) {
            expect(texts[i]).toContain(message);
            expect(texts[i]).toContain(`pack.json:${line}:${column}`);
            expect(texts[i]).toContain(code);
          }
        });
        await problems.getByRole('button', { name: /^Go to: "e"/ }).click();
        await hasFocus(card(view, 'Eve'));
        await says(view, 'Eve', /new: repulsor.*new: novae/);

        await view.getByRole('button', { name: 'Chapter', exact: true }).click();
        const heading = view.getByRole('textbox', { name: 'Chapter' });
        await hasFocus(heading);
        await page.keyboard.type('All at once');
        await page.keyboard.press('Enter');
        await onDisk(folder, 'a', { chapter: 'All at once' }, 'e', 'gone', 'b', 'c');
        await view.getByRole('region', { name: 'All at once' }).waitFor();
        await view.getByRole('button', { name: 'Remove the heading "All at once"; its levels stay' }).click();
        await onDisk(folder, 'a', 'e', 'gone', 'b', 'c');
        const name = view.getByRole('textbox', { name: 'Name of the pack' });
        await name.fill('Our game');
        await page.keyboard.press('Enter');
        await until(() => expect(readFileSync(join(folder, 'pack.json'), 'utf8')).toContain('"name": "Our game"'));

        // what is not there is taken out
        await card(view, 'gone').click();
        await view.getByRole('button', { name: 'Take the selected levels out of the list; their files stay' }).click();
        await onDisk(folder, 'a', 'e', 'b', 'c');
        await problems.getByText('there is no level "gone"').waitFor({ state: 'hidden' });

        // a level that is not listed is moved into the list
        await card(view, 'Dog').click();
        await page.keyboard.press('Alt+Home');
        await onDisk(folder, 'd', 'a', 'e', 'b', 'c');
      },
      { others: { 'pack.json': pack('a', 'e', 'gone', 'b', 'c') } },
    ),
  );

  it(
    'filters by words, verdict and effect; measures grades one after the other, stops, keeps them, and marks old ones',
    on({ a: near({ name: 'Ann' }), b: near({ name: 'Bob' }), e: garden({ name: 'Eve' }) }, async ({ page, write }) => {
      const view = await show(page);
      const count = view.getByRole('search', { name: 'Levels to show' }).getByRole('status');
      await says(view, 'Ann', /completable/);
      await view.getByRole('searchbox').fill('bo');
      await shows(view, 'Bob');
      await until(async () => expect(await count.textContent()).toBe('1 of 3 levels shown'));
      expect(await view.getByRole('button', { name: 'Move later' }).isDisabled()).toBe(true);
      await view.getByRole('searchbox').fill('');
      await view.getByRole('combobox', { name: 'Effect' }).selectOption('repulsor');
      await shows(view, 'Eve');
      await view.getByRole('combobox', { name: 'Effect' }).selectOption('');
      await view.getByRole('combobox', { name: 'Verdict' }).selectOption('completable');
      await shows(view, 'Ann', 'Bob');
      await view.getByRole('combobox', { name: 'Verdict' }).selectOption('');

      await view.getByRole('button', { name: 'Measure', exact: true }).click();
      await says(view, 'Ann', /grade \d/);
      await says(view, 'Bob', /grade \d/);
      await view.getByRole('button', { name: 'Measured' }).waitFor();
      await view.getByText('The curve as a table').click();
      const rows = await view.getByRole('table').getByRole('row').allTextContents();
      expect(rows.map((row) => /^(\d)(Ann|Bob|Eve)(\d+\.\d \w+|no run completes it)/.exec(row)?.[2])).toEqual([
        undefined,
        'Ann',
        'Bob',
        'Eve',
      ]);

      // the grade of another state of the level is marked as old
      write('b', near({ name: 'Bob', novae: [] }));
      await says(view, 'Bob', /grade \d.*before the last change/);
      await view.getByRole('button', { name: 'Measure', exact: true }).waitFor();

      // they are kept for the next page
      await page.reload();
      const again = await show(page);
      await says(again, 'Ann', /grade \d/);
    }),
  );

  it(
    'keeps pack.json in step when levels are renamed, deleted and brought back',
    on(
      FOUR,
      async ({ page, folder }) => {
        await verdict(page, 'completable');
        const list = page.getByRole('tree', { name: 'Levels' });
        await list.focus();
        await page.keyboard.press('Home');
        await page.keyboard.press('F2');
        const dialog = page.getByRole('dialog', { name: 'Rename' });
        await dialog.getByRole('textbox', { name: /file/i }).fill('z');
        await dialog.getByRole('button', { name: 'Rename' }).click();
        await onDisk(folder, 'z', 'a', { level: 'c', introduces: ['minerals'] }, 'b');
        // the list follows once the answer is there
        await until(async () => expect(await list.getByRole('treeitem').first().textContent()).toContain('Dog'));
        await list.focus();
        await page.keyboard.press('End');
        await page.keyboard.press('ArrowUp');
        await page.keyboard.press('Delete');
        await onDisk(folder, 'z', 'a', 'b');
        await page.keyboard.press('Control+z');
        await onDisk(folder, 'z', 'a', { level: 'c', introduces: ['minerals'] }, 'b');
      },
      { others: { 'pack.json': pack('d', 'a', { level: 'c', introduces: ['minerals'] }, 'b') }, complaints: /404/ },
    ),
  );

  it(
    'on a phone: a finger drags a level by its grip and scrolls elsewhere; buttons move it, too',
    on(
      FOUR,
      async ({ page, folder }) => {
        await page.getByRole('button', { name: 'Levels', exact: true }).tap();
        await page.getByRole('button', { name: 'All levels as cards' }).tap();
        const view = page.getByRole('dialog', { name: 'Pack' });
        await shows(view, 'Ann', 'Bob', 'Cat', 'Dog');
        await card(view, 'Bob').tap();
        await view.getByRole('button', { name: 'Move later' }).tap();
        await shows(view, 'Ann', 'Cat', 'Bob', 'Dog');
        await onDisk(folder, 'a', 'c', 'b', 'd');

        // verdicts may change the height of a card
        for (const name of ['Ann', 'Bob', 'Cat', 'Dog']) await says(view, name, /completable/);
        await card(view, 'Ann').scrollIntoViewIfNeeded();
        const client = await page.context().newCDPSession(page);
        const grip = await card(view, 'Ann').locator('[data-grip]').boundingBox();
        const onto = await card(view, 'Cat').boundingBox();
        if (grip === null || onto === null) throw new Error('not on the screen');
        expect(Math.min(grip.width, grip.height)).toBeGreaterThanOrEqual(44);
        const touch = (type: string, ...touchPoints: { x: number; y: number }[]) =>
          client.send('Input.dispatchTouchEvent', { type: type as 'touchStart', touchPoints });
        await touch('touchStart', { x: grip.x + 22, y: grip.y + 22 });
        await touch('touchMove', { x: grip.x + 22, y: grip.y + 40 });
        await touch('touchMove', { x: onto.x + 100, y: onto.y + onto.height - 10 });
        await view.locator('.pack__card--after').waitFor();
        await touch('touchEnd');
        await shows(view, 'Cat', 'Ann', 'Bob', 'Dog');
        await onDisk(folder, 'c', 'a', 'b', 'd');
        expect(await complaintsAbout(page, 'phone', '[role=dialog]')).toEqual([]);
        // nothing is wider than the screen
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );

  it(
    'has no complaints of axe, in dark and light colours',
    on(
      FOUR,
      async ({ page }) => {
        const view = await show(page);
        await says(view, 'Dog', /completable/);
        for (const colorScheme of ['dark', 'light'] as const) {
          await page.emulateMedia({ colorScheme });
          await until(async () => expect(await page.locator('html').getAttribute('data-theme')).toBe(colorScheme));
          expect(await complaintsAbout(page, colorScheme, '[role=dialog]')).toEqual([]);
        }
      },
      { others: { 'pack.json': pack('a', { chapter: 'C' }, 'b', 'b', { chapter: 'Empty' }) } },
    ),
  );
});
