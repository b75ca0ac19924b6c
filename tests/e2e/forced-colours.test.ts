import type { Locator, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { tool, verdict } from './commands.ts';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

/** The painted colours of an element, with forced colours applied. */
const look = (locator: Locator): Promise<string> =>
  locator.evaluate((element) => {
    const { backgroundColor, backgroundImage, borderBottom, color, outline, textDecoration } = getComputedStyle(element);
    return JSON.stringify({ backgroundColor, backgroundImage, borderBottom, color, outline, textDecoration });
  });

/** Pairs of a selected and an unselected element. */
const pairs = (page: Page): Readonly<Record<string, readonly [Locator, Locator]>> => ({
  tab: [page.getByRole('tab', { name: 'Inspector' }), page.getByRole('tab', { name: 'Effects' })],
  tool: [tool(page, 'Select'), tool(page, 'Asteroid')],
  speed: [
    page.getByRole('toolbar', { name: 'Speed' }).getByRole('button', { name: '1×', exact: true }),
    page.getByRole('toolbar', { name: 'Speed' }).getByRole('button', { name: '2×' }),
  ],
  level: [page.getByRole('treeitem', { name: /Straight/ }), page.getByRole('treeitem', { name: /Second/ })],
  segment: [
    page.locator('.segments__one', { has: page.getByRole('radio', { name: 'off' }) }).locator('span'),
    page.locator('.segments__one', { has: page.getByRole('radio', { name: 'on', exact: true }) }).locator('span'),
  ],
  hold: [page.locator('.hold'), page.locator('.lane')],
  'hold that is selected': [page.locator('.hold--selected'), page.locator('.hold:not(.hold--selected)')],
  slack: [page.locator('.hold__slack').first(), page.locator('.lane')],
  'end of a way': [
    page.getByRole('button', { name: 'Play from the start' }).or(page.locator('.topbar__play')),
    tool(page, 'Hot asteroid'),
  ],
});

inChromium('system colours in Chromium', ({ on }) => {
  it(
    'selected, held and remaining parts are distinguishable with forced colours and with more contrast',
    on(
      {
        '01': straight({
          runs: [
            {
              name: 'solution',
              holds: [
                [0, 300],
                [310, 600],
              ],
            },
          ],
        }),
        '02': straight({ name: 'Second' }),
      },
      async ({ page }) => {
        await verdict(page, 'completable');
        await page.locator('.hold__slack').first().waitFor();
        const holds = page.getByRole('button', { name: /^Hold 2: / });
        await holds.click({ position: { x: 10, y: 10 } });
        await page.locator('.hold--selected').waitFor();
        const all = pairs(page);
        for (const [media, matches] of [
          [{ forcedColors: 'active', contrast: 'no-preference' }, '(forced-colors: active)'],
          [{ forcedColors: 'none', contrast: 'more' }, '(prefers-contrast: more)'],
        ] as const) {
          for (const colorScheme of ['dark', 'light'] as const) {
            await page.emulateMedia({ ...media, colorScheme });
            await until(async () => expect(await page.evaluate((query) => matchMedia(query).matches, matches)).toBe(true));
            for (const [name, [chosen, other]] of Object.entries(all)) {
              expect([media, name, await look(chosen.first())]).not.toEqual([media, name, await look(other.first())]);
            }
          }
        }
      },
    ),
  );
});
