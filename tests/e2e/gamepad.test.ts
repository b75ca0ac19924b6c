import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { hurry } from './frames.ts';
import { near, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const A = 0;
const B = 1;
const SELECT = 8;
const START = 9;
const [UP, DOWN, LEFT, RIGHT] = [12, 13, 14, 15];

/** Runs in the page before its own scripts: a gamepad of the standard layout whose buttons the test presses. */
function plugIn(): void {
  const down = new Set<number>();
  const pad = {
    index: 0,
    axes: [0, 0, 0, 0],
    get buttons() {
      return Array.from({ length: 17 }, (_, i) => ({ pressed: down.has(i), touched: down.has(i), value: down.has(i) ? 1 : 0 }));
    },
  };
  Object.defineProperty(navigator, 'getGamepads', { value: () => [null, pad] });
  Object.assign(window, { padDown: (i: number) => down.add(i), padUp: (i: number) => down.delete(i) });
}

/** Waits until the page has looked at the gamepad, which it does once a frame. */
const frames = (page: Page) =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

async function hold(page: Page, button: number): Promise<() => Promise<void>> {
  await page.evaluate(`padDown(${button})`);
  await frames(page);
  return async () => {
    await page.evaluate(`padUp(${button})`);
    await frames(page);
  };
}

async function press(page: Page, button: number): Promise<void> {
  const release = await hold(page, button);
  await release();
}

const playtest = (page: Page) => page.getByRole('application', { name: /^Playtest/ });
const theEnd = (page: Page) => playtest(page).getByRole('status');

inChromium('a gamepad in Chromium', ({ on }) => {
  it(
    'starts a playtest, holds the gun, changes the speed, restarts, keeps the attempt and goes back',
    on(
      { '01': near({ runs: undefined }) },
      async ({ page, file, saved }) => {
        await saved();
        await hurry(page, 8);
        await press(page, START);
        await playtest(page).waitFor();
        await page.getByText('gamepad: A: gun · Select: again · Start: edit').waitFor();
        const speed = (name: string) => playtest(page).getByRole('button', { name: `Speed ${name}` });
        await press(page, DOWN);
        await speed('½×').waitFor();
        await press(page, UP);
        await speed('1×').waitFor();
        await press(page, START);
        await playtest(page).waitFor({ state: 'hidden' });

        await press(page, START);
        await playtest(page).waitFor();
        const release = await hold(page, B);
        await theEnd(page).waitFor();
        await release();
        // a button that is pressed as the gun when the end comes does nothing else
        await press(page, A);
        expect(await theEnd(page).textContent()).toContain('She reaches the black hole');
        // without a press she is there within a second, so the clock stands still until the gun is held
        await hurry(page, 0);
        await press(page, SELECT);
        await theEnd(page).waitFor({ state: 'hidden' });
        const again = await hold(page, A);
        await hurry(page, 8);
        await theEnd(page).waitFor();
        await again();
        const focused = (name: string) =>
          until(async () =>
            expect(
              await playtest(page)
                .getByRole('button', { name })
                .evaluate((one) => one === document.activeElement),
            ).toBe(true),
          );
        await press(page, RIGHT);
        await focused('Again');
        await press(page, LEFT);
        await focused('Edit');
        await press(page, LEFT);
        await focused('Keep as a run');
        await press(page, A);
        await playtest(page).waitFor({ state: 'hidden' });
        await until(() => expect(file('01').runs).toHaveLength(1));
        const holds = file('01').runs?.[0].holds ?? [];
        expect(holds).toHaveLength(1);
        expect(holds[0][1]).toBeGreaterThan(holds[0][0]);
      },
      { before: plugIn },
    ),
  );

  it(
    'does nothing while a dialog is open, and its buttons are on the sheet of shortcuts',
    on(
      { '01': straight() },
      async ({ page, saved }) => {
        await saved();
        await page.keyboard.press('?');
        const sheet = page.getByRole('dialog', { name: 'Shortcuts and gestures' });
        await sheet.getByText('gamepad Start').first().waitFor();
        await press(page, START);
        await frames(page);
        expect(await playtest(page).count()).toBe(0);
        await page.keyboard.press('Escape');
        await sheet.waitFor({ state: 'hidden' });
        await press(page, START);
        await playtest(page).waitFor();
      },
      { before: plugIn },
    ),
  );
});
