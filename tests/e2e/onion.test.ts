import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { compile, simulate } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import { SWING } from '../editor/swing-level.ts';
import { complaintsAbout } from './axe.ts';
import { command } from './commands.ts';
import { nextFrames } from './frames.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const LEVEL: LevelFile = { ...SWING, novae: [{ id: 'nova', x: 400, y: 700, radius: 16 }] };
const moved = (x: number, y = 620): LevelFile => ({ ...LEVEL, asteroids: [{ id: 'bjzg', x, y, radius: 32 }] });
const timeOf = (file: LevelFile): string => simulate(compile(resolveLevel(file)), file.runs?.[0].holds ?? []).time.toFixed(2);

const card = (page: Page) => page.getByRole('note', { name: 'Before and after the change' });
const spoken = (page: Page) => page.getByRole('status', { name: 'Before and after' });
/** A figure of the card. */
const figure = (page: Page, label: string) => card(page).locator('.onion__row').filter({ hasText: label });

/** The ticks that the tightest press or release may slip in both directions, as the Solver panel shows them. */
async function leastSlack(page: Page): Promise<number> {
  const table = page.getByRole('table', { name: /^How many ticks/ });
  await table.waitFor();
  const cells = await table.getByRole('cell').allTextContents();
  return Math.min(...cells.map((text) => [...text.matchAll(/\d+/g)].reduce((sum, [ticks]) => sum + Number(ticks), 0)));
}

const isInside = async (page: Page): Promise<boolean> => {
  const box = await card(page).boundingBox();
  const size = page.viewportSize();
  if (box === null || size === null) return false;
  return box.x >= 0 && box.y >= 0 && box.x + box.width <= size.width && box.y + box.height <= size.height;
};

inChromium('before and after a change in Chromium', ({ on }) => {
  it(
    'a drag shows the former way, outline and figures beside the pointer; they stay until something is pressed',
    on(
      { '01': LEVEL },
      async ({ page, canvas, file, saved }) => {
        await saved();
        await canvas.fit(file('01'));
        await page.getByRole('tab', { name: 'Solver' }).click();
        const slackBefore = await leastSlack(page);
        const rim = canvas.at({ x: 600, y: 588 });
        expect(await countColour(page, rim, 6, COLOURS.dark.onion)).toBe(0);
        await canvas.drag(
          { x: 600, y: 620 },
          {
            to: [{ x: 601, y: 625 }],
            before: async () => {
              const now = timeOf(moved(600, 624));
              await figure(page, 'time')
                .filter({ hasText: `${timeOf(LEVEL)} s → ${now} s` })
                .waitFor();
              // the former outline lies where nothing else is in this colour, and the former way has a mark at its end
              await until(async () => expect(await countColour(page, rim, 6, COLOURS.dark.onion)).toBeGreaterThan(4));
              const { final } = simulate(compile(resolveLevel(LEVEL)), [[150, 435]]);
              await until(async () =>
                expect(await countColour(page, canvas.at(final), 12, COLOURS.dark.onion)).toBeGreaterThan(10),
              );
              // the slack is found while the button is still down
              await figure(page, 'least slack')
                .filter({ hasText: `${slackBefore} ticks →` })
                .waitFor();
              await until(async () => expect(await figure(page, 'least slack').textContent()).not.toContain('…'));
              await until(async () => expect(await isInside(page)).toBe(true));
              expect(await spoken(page).textContent()).toBe('');
              // it must not lie under the pointer, nor catch it
              const at = canvas.at({ x: 601, y: 625 });
              const box = await card(page).boundingBox();
              if (box === null) throw new Error('no card');
              expect(at.x > box.x && at.x < box.x + box.width && at.y > box.y && at.y < box.y + box.height).toBe(false);
              const hit = await page.evaluate(
                ([x, y]) => document.elementFromPoint(x, y)?.closest('.onion') !== null,
                [box.x + 5, box.y + 5],
              );
              expect(hit).toBe(false);
            },
          },
        );
        await spoken(page)
          .filter({ hasText: /^Before and after: run completes.*time .*least slack \d+ ticks/ })
          .waitFor();
        // the same numbers as in the panel
        const slack = await leastSlack(page);
        await figure(page, 'least slack')
          .filter({ hasText: `→ ${slack} ticks` })
          .waitFor();
        await until(() => expect(file('01').asteroids?.[0].y).toBe(624));
        expect(await complaintsAbout(page, 'before and after', 'main')).toEqual([]);
        await canvas.click({ x: 700, y: 900 });
        await card(page).waitFor({ state: 'detached' });
        await until(async () => expect(await countColour(page, rim, 6, COLOURS.dark.onion)).toBe(0));
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );

  it(
    'keys do the same: nudges, a drag at the crosshair, holds; Shift B shows the last one again',
    on({ '01': LEVEL }, async ({ page, canvas, file, saved }) => {
      await saved();
      await canvas.fit(file('01'));
      await canvas.click({ x: 600, y: 620 });
      await page.keyboard.down('ArrowRight');
      await figure(page, 'time')
        .filter({ hasText: `${timeOf(LEVEL)} s → ${timeOf(moved(601))} s` })
        .waitFor();
      await until(async () => expect(await isInside(page)).toBe(true));
      await page.keyboard.up('ArrowRight');
      await spoken(page).filter({ hasText: /time/ }).waitFor();
      await page.keyboard.press('ArrowRight');
      // the same step: still compared with its beginning
      await figure(page, 'time')
        .filter({ hasText: `${timeOf(LEVEL)} s → ${timeOf(moved(602))} s` })
        .waitFor();
      await page.keyboard.press('Escape');
      await card(page).waitFor({ state: 'detached' });

      await page.keyboard.press('Shift+B');
      await figure(page, 'time')
        .filter({ hasText: `${timeOf(LEVEL)} s → ${timeOf(moved(602))} s` })
        .waitFor();
      // until it is pressed again
      await canvas.click({ x: 700, y: 900 });
      await nextFrames(page);
      expect(await card(page).count()).toBe(1);
      await page.keyboard.press('Shift+B');
      await card(page).waitFor({ state: 'detached' });

      // a drag at the crosshair: it begins at the selected object
      await canvas.click({ x: 602, y: 620 });
      await page.keyboard.press('Enter');
      await page.keyboard.press('d');
      await page.keyboard.press('Alt+ArrowLeft');
      await figure(page, 'time')
        .filter({ hasText: `${timeOf(moved(602))} s → ${timeOf(moved(601))} s` })
        .waitFor();
      await page.keyboard.press('d');
      expect(await card(page).count()).toBe(1);
      await until(() => expect(file('01').asteroids?.[0].x).toBe(601));
      await page.keyboard.press('Escape');

      // what breaks the run is told by a sign and a word
      const press = page.getByRole('slider', { name: 'Press of hold 1' });
      await press.focus();
      const fails = (tens: number) =>
        simulate(compile(resolveLevel(moved(601))), [[150 - 10 * tens, 435]]).outcome !== 'completed';
      const tens = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14].find(fails) ?? 0;
      expect(tens).toBeGreaterThan(0);
      for (let i = 0; i < tens; i++) await page.keyboard.press('Shift+ArrowLeft');
      await figure(page, 'run')
        .filter({ hasText: /completes → .*, worse/ })
        .waitFor();
      expect(await figure(page, 'run').locator('.onion__sign').textContent()).toBe('▼');
      await until(async () => expect(await isInside(page)).toBe(true));
      expect(await complaintsAbout(page, 'before and after by keys', 'main')).toEqual([]);
    }),
  );

  it(
    'on a phone it keeps clear of the finger; the layer turns all of it off',
    on(
      { '01': LEVEL },
      async ({ page, canvas, context, file }) => {
        await canvas.fit(file('01'));
        const devtools = await context.newCDPSession(page);
        const from = canvas.at({ x: 600, y: 620 });
        const touch = (type: string, points: { x: number; y: number }[]) =>
          devtools.send('Input.dispatchTouchEvent', { type, touchPoints: points } as never);
        const drag = async (look: () => Promise<void>) => {
          await touch('touchStart', [from]);
          for (let i = 1; i <= 6; i++) await touch('touchMove', [{ x: from.x + 3 * i, y: from.y }]);
          await look();
          await touch('touchEnd', []);
        };
        await drag(async () => {
          await card(page).waitFor();
          await figure(page, 'time').waitFor();
          await until(async () => expect(await isInside(page)).toBe(true));
          const box = await card(page).boundingBox();
          const finger = { x: from.x + 18, y: from.y };
          const away = Math.max(
            (box?.x ?? 0) - finger.x,
            finger.x - ((box?.x ?? 0) + (box?.width ?? 0)),
            (box?.y ?? 0) - finger.y,
            finger.y - ((box?.y ?? 0) + (box?.height ?? 0)),
          );
          expect(away).toBeGreaterThanOrEqual(44);
        });
        await page.getByRole('button', { name: /^Undo: Move/ }).tap();
        await command(page, 'Show or hide the run before and after a change');
        await canvas.fit(file('01'));
        await drag(async () => {
          await until(async () => expect(await page.getByRole('button', { name: /^Undo: / }).count()).toBe(0));
          await nextFrames(page);
          expect(await card(page).count()).toBe(0);
        });
        await page.getByRole('button', { name: /^Undo: Move/ }).waitFor();
        expect(await spoken(page).textContent()).toBe('');
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );
});
