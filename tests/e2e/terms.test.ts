// The page judges levels under the terms of their folder, as gq check does. GQ_SHOTS names a folder for pictures of the page.
import type { Locator, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { gq } from '../cli/gq.ts';
import { GRAZE, SLOW } from '../editor/terms-levels.ts';
import { put } from '../server/running.ts';
import { complaintsAbout } from './axe.ts';
import { command, verdict } from './commands.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const shots = process.env.GQ_SHOTS;
const CONFIG = 'gq.config.json';
const config = (terms: object): string => `${JSON.stringify(terms)}\n`;

const listed = (page: Page, name: RegExp): Promise<void> =>
  page.getByRole('tree', { name: 'Levels' }).getByRole('treeitem', { name }).waitFor();
const badge = (page: Page): Locator => page.getByRole('status', { name: /^Verdict: / });
const status = (page: Page): Locator => page.locator('.statusbar');

async function byCommand(folder: string): Promise<string[]> {
  const { stdout } = await gq(['check', '.', '--format', 'json'], { cwd: folder });
  return (JSON.parse(stdout) as { levels: { verdict: string }[] }).levels.map((level) => level.verdict);
}

async function shot(page: Page, name: string): Promise<void> {
  if (shots === undefined) return;
  const before = page.viewportSize();
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
    await until(async () => expect(await page.locator('html').getAttribute('data-theme')).toBe(colorScheme));
    for (const [width, height] of [
      [1440, 900],
      [1024, 700],
      [390, 844],
    ] as const) {
      await page.setViewportSize({ width, height });
      await page.screenshot({ path: `${shots}/${name}-${colorScheme}-${width}.png` });
    }
  }
  if (before !== null) await page.setViewportSize(before);
}

inChromium('terms in Chromium', ({ on }) => {
  it(
    'a level is judged at the accuracy of its folder; another one is chosen by hand, is named, and is left again',
    on(
      { '01': GRAZE },
      async ({ page, folder }) => {
        await verdict(page, 'broken');
        await listed(page, /Graze broken/);
        await status(page).getByText('arcade:').waitFor();
        expect(await byCommand(folder)).toEqual(['broken']);
        await command(page, 'Show problems');
        await page.getByText('collided with nova 1').first().waitFor();
        await shot(page, '1-as-checked');

        // by hand: the verdict says at which accuracy, and what gq check takes; the list still says what that says
        await command(page, 'Show accuracy');
        const accuracy = page.getByRole('radiogroup', { name: 'Accuracy' });
        await accuracy.getByRole('radio', { name: /^precise/ }).check();
        await until(async () =>
          expect(await badge(page).getAttribute('aria-label')).toBe('Verdict: completable, at precise; gq check here: arcade'),
        );
        await status(page).getByRole('button', { name: 'at precise; gq check here: arcade' }).waitFor();
        await listed(page, /Graze broken/);
        await shot(page, '2-by-hand');
        for (const colorScheme of ['dark', 'light'] as const) {
          await page.emulateMedia({ colorScheme, reducedMotion: 'reduce' });
          await until(async () => expect(await page.locator('html').getAttribute('data-theme')).toBe(colorScheme));
          expect(await complaintsAbout(page, colorScheme, '.topbar')).toEqual([]);
        }

        // it is kept, and so is what it says
        await page.reload();
        await until(async () =>
          expect(await badge(page).getAttribute('aria-label')).toBe('Verdict: completable, at precise; gq check here: arcade'),
        );
        await status(page).getByRole('button', { name: 'at precise; gq check here: arcade' }).click();
        await until(async () => expect(await badge(page).getAttribute('aria-label')).toBe('Verdict: broken'));
        expect(await status(page).getByRole('button').count()).toBe(0);
      },
      { others: { [CONFIG]: config({ accuracy: 'arcade' }) } },
    ),
  );

  it(
    'a change of the configuration on disk changes the verdict of the open page',
    on(
      { '01': GRAZE },
      async ({ page, folder }) => {
        await verdict(page, 'broken');
        for (const [accuracy, said] of [
          ['precise', 'completable'],
          ['arcade', 'broken'],
          ['fast', 'completable'],
        ] as const) {
          put(folder, CONFIG, config({ accuracy }));
          await verdict(page, said);
          await listed(page, new RegExp(`Graze ${said}`));
          await page
            .getByRole('list', { name: 'Messages' })
            .getByText(`gq.config.json has changed: levels are now judged at ${accuracy}.`)
            .waitFor();
          expect(await byCommand(folder)).toEqual([said]);
        }
      },
      { others: { [CONFIG]: config({ accuracy: 'arcade' }) } },
    ),
  );

  it(
    'a run lasts as long as the configuration lets it, on the timeline and in the verdict; and a level costs no more work',
    on(
      { '01': SLOW },
      async ({ page, folder }) => {
        await verdict(page, 'completable');
        await listed(page, /Slow completable/);
        await status(page).getByText('reaches the black hole at 77.58 s').waitFor();
        expect(await byCommand(folder)).toEqual(['completable']);
        await shot(page, '3-long');
        put(folder, CONFIG, config({ maxTime: 50 }));
        await verdict(page, 'broken');
        await listed(page, /Slow broken/);
        await status(page).getByText('is not over after 50 s').waitFor();
        expect(await byCommand(folder)).toEqual(['broken']);
        put(folder, CONFIG, config({ maxTime: 120, maxWork: 3 }));
        await verdict(page, 'unproven');
        await listed(page, /Slow unproven/);
        expect(await byCommand(folder)).toEqual(['unproven']);
      },
      { others: { [CONFIG]: config({ maxTime: 120 }) } },
    ),
  );

  it(
    'the accuracy that an earlier page stored for everybody does not hide that of the folder',
    on(
      { '01': GRAZE },
      async ({ page }) => {
        await verdict(page, 'broken');
        const store = (accuracy: string) =>
          page.evaluate((name) => {
            window.localStorage.setItem('gravity-quest-editor-settings', JSON.stringify({ accuracy: name, tourSeen: true }));
          }, accuracy);
        await store('precise');
        await page.reload();
        await until(async () => expect(await badge(page).getAttribute('aria-label')).toBe('Verdict: broken'));
        await store('fast');
        await page.reload();
        await until(async () =>
          expect(await badge(page).getAttribute('aria-label')).toBe('Verdict: completable, at fast; gq check here: arcade'),
        );
      },
      { others: { [CONFIG]: config({ accuracy: 'arcade' }) } },
    ),
  );
});
