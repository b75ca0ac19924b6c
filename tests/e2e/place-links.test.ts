import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { verdict } from './commands.ts';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

/** She passes the first rock and hits the nova far to the right; the goal is still farther. */
const far = straight({
  name: 'Far',
  range: 5000,
  astronaut: { x: 0, y: 0, vx: 90 },
  blackHole: { x: 60_000, y: 0 },
  asteroids: [{ id: 'rock', x: 300, y: 3000, radius: 16 }],
  novae: [{ id: 'nova', x: 700, y: 0, radius: 32 }],
  minerals: [],
  runs: [
    { name: 'solution', holds: [] },
    { name: 'late', holds: [[400, 420]] },
  ],
});

const goTo = (page: Page, fragment: string): Promise<void> =>
  page.evaluate((hash) => {
    window.location.hash = hash;
  }, fragment);
const isOpen = (page: Page, name: string) => page.getByRole('heading', { level: 1, name, exact: true }).waitFor();
const shownRun = (page: Page) => page.getByRole('combobox', { name: 'Run' }).inputValue();
const zoom = async (page: Page) => Number.parseInt((await page.getByText(/^\d+ %$/).textContent()) ?? '', 10);

inChromium('a link to a place, in Chromium', ({ on }) => {
  it(
    'opens the level, the run and the tick, and brings the place into view; other links may follow',
    on(
      { '01': straight({ name: 'First' }), 'world/02-far': far },
      async ({ page }) => {
        await isOpen(page, 'Far');
        expect(await shownRun(page)).toBe('late');
        const at = (tick: number) => page.getByText(new RegExp(`^tick ${tick} of `)).waitFor();
        await at(412);
        // the whole level is 60,000 px wide: shown whole, nothing could be made out
        await until(async () => expect(await zoom(page)).toBe(50));
        expect(new URL(page.url()).hash).toBe('');

        await goTo(page, 'level=First&tick=30');
        await isOpen(page, 'First');
        await verdict(page, 'completable');
        await at(30);
        // the whole level fits
        await until(async () => expect(await zoom(page)).toBeGreaterThan(50));
        expect(await page.getByRole('alert').count()).toBe(0);

        // the same level again, in other words, with a tick after the end
        await goTo(page, 'level=levels/01.level.json&tick=100000&run=solutoin');
        const notice = page.getByText(/^The link asks for the run “solutoin”/);
        await notice.waitFor();
        expect(await notice.textContent()).toMatch(
          /Did you mean “solution”\? The link asks for tick 100000, but the run “solution” ends at tick \d+\.$/,
        );
        expect(await shownRun(page)).toBe('solution');

        // a level that is not there, and nothing that could do harm
        await goTo(page, `level=${encodeURIComponent('02-fa')}&tick=${encodeURIComponent('<img src=x onerror=alert(1)>')}`);
        await page
          .getByText('The link asks for the level “02-fa”, which is not in this folder. Did you mean “world/02-far”?')
          .waitFor();
        await goTo(page, `level=${encodeURIComponent('<b>../../etc/passwd\u202e')}${'x'.repeat(5000)}`);
        await page
          .getByText(/^The link asks for the level “<b>\.\.\/\.\.\/etc\/passwd\u{fffd}x+…”, which is not in this folder/u)
          .waitFor();
        await isOpen(page, 'First');
        await goTo(page, 'level=01&tick=-1');
        await page.getByText('The link’s tick can’t be used: expected a tick like 412, found "-1".').waitFor();
        await page.reload();
        await isOpen(page, 'First');
      },
      { fragment: 'level=levels/world/02-far.level.json&tick=412&run=late' },
    ),
  );

  const otherStart = async (page: Page, isKnown: boolean) => {
    await isOpen(page, 'First');
    await page.evaluate(() => Object.assign(window, { isOld: true }));
    // a tab that has never been let in has no key of the folder
    if (!isKnown) await page.evaluate(() => sessionStorage.clear());
    await goTo(page, 'token=of-another-start&level=02');
  };

  it(
    'with the token of another start of gq edit reloads the page, which the key of the folder lets in',
    on(
      { '01': straight({ name: 'First' }), '02': straight({ name: 'Second' }) },
      async ({ page }) => {
        await otherStart(page, true);
        await isOpen(page, 'Second');
        expect(await page.evaluate(() => 'isOld' in window)).toBe(false);
      },
      { complaints: /401/ },
    ),
  );

  it(
    'with the token of another start of gq edit, without the key, says that the page belongs to another run',
    on(
      { '01': straight({ name: 'First' }), '02': straight({ name: 'Second' }) },
      async ({ page }) => {
        await otherStart(page, false);
        await page.getByText('this page belongs to another run of gq edit').first().waitFor();
        expect(await page.evaluate(() => 'isOld' in window)).toBe(false);
      },
      { complaints: /401/ },
    ),
  );
});
