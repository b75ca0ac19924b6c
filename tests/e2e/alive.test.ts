import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import type { LevelFile } from '../../schema/index.ts';
import { shippedFile } from '../check/shipped-file.ts';
import { outcomeOf } from '../editor/alive-stage.ts';
import { complaintsAbout } from './axe.ts';
import { command, verdict } from './commands.ts';
import { inChromium, type Stage } from './stage.ts';
import { until } from './until.ts';

/** One swing, so that little is to be sought; its run fails when its asteroid is moved by about (10, 10). */
const SWING = shippedFile('12-detour');
const RUN = SWING.runs?.[0].name ?? '';
const rock = ({ asteroids }: LevelFile) => asteroids?.[0] ?? { x: 0, y: 0 };
const from = { x: rock(SWING).x, y: rock(SWING).y };
const beside = { x: from.x + 10, y: from.y + 10 };

/** Where a drag without snapping ends, to the px of the screen. */
const isBeside = (file: LevelFile): boolean => Math.abs(rock(file).x - beside.x) < 2 && Math.abs(rock(file).y - beside.y) < 2;

/** Control turns snapping off. */
const DRAG = { to: [{ x: from.x + 30, y: from.y + 30 }, beside], keys: ['Control'] };

const toggle = (page: Page) => page.getByRole('button', { name: 'Keep the run alive' });
const said = (page: Page) => page.getByRole('status').filter({ hasText: /kept alive/ });
const seen = (page: Page) => page.locator('.alive--alive');

/** Turns it on with the button. */
async function turnOn({ page }: Stage): Promise<void> {
  await toggle(page).click();
  expect(await toggle(page).getAttribute('aria-pressed')).toBe('true');
}

inChromium('a run that is kept alive in Chromium', ({ on }) => {
  it(
    'completes the level while the object is still dragged, and one undo takes back the move and the holds',
    on({ '01': SWING }, async (stage) => {
      const { page, canvas, saved, file, text } = stage;
      await saved();
      const before = text('01');
      await turnOn(stage);
      await canvas.fit(file('01'));
      await canvas.drag(from, {
        ...DRAG,
        before: async () => {
          await seen(page).filter({ hasText: 'kept alive' }).waitFor();
          await verdict(page, 'completable');
          // nothing is read out while the object is dragged, and nothing is saved
          expect(await said(page).count()).toBe(0);
          expect(text('01')).toBe(before);
        },
      });
      await said(page).filter({ hasText: 'certified' }).waitFor();
      await said(page).filter({ hasText: '2 of 2 runs complete the level' }).waitFor();
      await saved();
      await until(() => {
        const now = file('01');
        expect(isBeside(now)).toBe(true);
        expect(outcomeOf(now, RUN)).toBe('completed');
        expect(now.runs?.[0].holds).not.toEqual(SWING.runs?.[0].holds);
      });
      expect(await complaintsAbout(page, 'kept alive', '.survival')).toEqual([]);
      expect(await complaintsAbout(page, 'its button', '.transport')).toEqual([]);
      await command(page, 'Undo');
      await saved();
      await until(() => expect(file('01')).toEqual(JSON.parse(before)));
      await until(async () => expect(await seen(page).count()).toBe(0));
    }),
  );

  it(
    'is as it was after Escape in a drag',
    on({ '01': SWING }, async (stage) => {
      const { page, canvas, saved, file, text } = stage;
      await saved();
      const before = text('01');
      await turnOn(stage);
      await canvas.fit(file('01'));
      await canvas.drag(from, {
        ...DRAG,
        before: async () => {
          await seen(page).filter({ hasText: 'kept alive' }).waitFor();
          await page.keyboard.press('Escape');
          await until(async () => expect(await seen(page).count()).toBe(0));
        },
      });
      await verdict(page, 'completable');
      await saved();
      expect(text('01')).toBe(before);
    }),
  );

  it(
    'is turned on and used by keys, and stays on for the next visit',
    on({ '01': SWING }, async ({ page, canvas, saved, file, text }) => {
      await saved();
      const before = text('01');
      await canvas.fit(file('01'));
      await page.keyboard.press('Shift+K');
      await until(async () => expect(await toggle(page).getAttribute('aria-pressed')).toBe('true'));
      await page.getByRole('treeitem', { name: /asteroid 1/i }).click();
      const field = page.getByRole('textbox', { name: 'x', exact: true });
      await field.fill(String(from.x + 16));
      await page.keyboard.press('Enter');
      await said(page).filter({ hasText: 'certified' }).waitFor();
      await saved();
      await until(() => {
        const now = file('01');
        expect(rock(now).x).toBe(from.x + 16);
        expect(outcomeOf(now, RUN)).toBe('completed');
      });
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('Control+z');
      await saved();
      await until(() => expect(file('01')).toEqual(JSON.parse(before)));
      await page.reload();
      await until(async () => expect(await toggle(page).getAttribute('aria-pressed')).toBe('true'));
    }),
  );

  it(
    'is not sought while it is turned off',
    on({ '01': SWING }, async ({ page, canvas, saved, file }) => {
      await saved();
      await canvas.fit(file('01'));
      await canvas.drag(from, DRAG);
      await verdict(page, 'broken');
      await saved();
      expect(await page.locator('.alive').count()).toBe(0);
      expect(file('01').runs).toEqual(SWING.runs);
    }),
  );
});

const card = (page: Page) => page.getByRole('region', { name: 'Mend' });
const offer = (page: Page) => page.getByRole('status').filter({ hasText: `Run "${RUN}" no longer completes the level` });
const finds = (page: Page) => card(page).getByRole('list', { name: 'What mends the level' }).getByRole('listitem');

/** Moves the asteroid so that the run fails. */
async function breakIt({ page, canvas, saved, file }: Stage): Promise<void> {
  await saved();
  await canvas.fit(file('01'));
  await canvas.drag(from, DRAG);
  await offer(page).waitFor();
}

inChromium('mending what a change broke in Chromium', ({ on }) => {
  it(
    'is offered quietly, previews what is found, takes it in one step, and is gone then',
    on({ '01': SWING }, async (stage) => {
      const { page, saved, file, text } = stage;
      await breakIt(stage);
      await saved();
      const broken = text('01');
      // the focus stays where it was
      expect(await card(page).evaluate((element) => element.contains(document.activeElement))).toBe(false);
      await card(page).getByRole('button', { name: 'Mend' }).click();
      await finds(page)
        .first()
        .filter({ hasText: /^Move asteroid 1 back/ })
        .waitFor();
      await card(page).getByText('Each is the smallest that was tried of its kind.').waitFor();
      await until(async () => expect(await finds(page).count()).toBeGreaterThanOrEqual(3));
      expect(await complaintsAbout(page, 'mend', '.survival')).toEqual([]);
      for (const label of [/^Move asteroid 1 back/, /^In run/]) {
        const one = finds(page).filter({ hasText: label });
        await one.getByRole('button', { name: 'Preview' }).click();
        await verdict(page, 'completable');
        expect(text('01')).toBe(broken);
        await one.getByRole('button', { name: 'Back' }).click();
        await verdict(page, 'broken');
      }
      const first = finds(page).first();
      await first.getByRole('button', { name: 'Preview' }).click();
      await first.getByRole('button', { name: 'Take' }).click();
      await verdict(page, 'completable');
      await until(async () => expect(await offer(page).count()).toBe(0));
      await saved();
      await until(() => expect(outcomeOf(file('01'), RUN)).toBe('completed'));
      await command(page, 'Undo');
      await saved();
      await until(() => expect(text('01')).toBe(broken));
    }),
  );

  it(
    'works by keys: Shift M, Enter, Escape',
    on({ '01': SWING }, async (stage) => {
      const { page, text, saved, file } = stage;
      await breakIt(stage);
      await saved();
      const broken = text('01');
      await page.keyboard.press('Shift+M');
      await finds(page).first().waitFor();
      await card(page).getByText('Each is the smallest that was tried of its kind.').waitFor();
      expect(await card(page).evaluate((element) => element.contains(document.activeElement))).toBe(true);
      await finds(page).first().getByRole('button', { name: 'Preview' }).focus();
      await page.keyboard.press('Enter');
      await verdict(page, 'completable');
      await page.keyboard.press('Escape');
      await verdict(page, 'broken');
      await finds(page).first().getByRole('button', { name: 'Preview' }).focus();
      await page.keyboard.press('Enter');
      await finds(page).first().getByRole('button', { name: 'Take' }).focus();
      await page.keyboard.press('Enter');
      await verdict(page, 'completable');
      await saved();
      await until(() => expect(text('01')).not.toBe(broken));
      expect(outcomeOf(file('01'), RUN)).toBe('completed');
    }),
  );

  it(
    'is gone with Escape, and after an undo',
    on({ '01': SWING }, async (stage) => {
      const { page } = stage;
      await breakIt(stage);
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('Escape');
      await until(async () => expect(await offer(page).count()).toBe(0));
      await verdict(page, 'broken');
      await page.keyboard.press('Control+z');
      await verdict(page, 'completable');
      await page.keyboard.press('Control+Shift+z');
      await verdict(page, 'broken');
      expect(await offer(page).count()).toBe(0);
    }),
  );
});
