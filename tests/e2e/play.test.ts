import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { gq } from '../cli/gq.ts';
import { verdict } from './commands.ts';
import { hurry, nextFrames } from './frames.ts';
import { near, straight } from './levels.ts';
import { type Heard, listenToSound } from './sound.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const playtest = (page: Page) => page.getByRole('application', { name: /^Playtest/ });
const theEnd = (page: Page) => playtest(page).getByRole('status');
/** The speed relative to real time: 0.25 s of the game per frame. */
const FAST = 8;

/** Nobody has played it yet. */
const quick = () => near({ runs: undefined });
/** She flies towards an asteroid that ends it. */
const deadly = () =>
  straight({
    astronaut: { x: 200, y: 304, vx: 60 },
    asteroids: [{ id: 'rock', x: 448, y: 304, radius: 16, hot: true }],
    minerals: [],
    runs: undefined,
  });
/** The end of an attempt as shown on the page: its kind and time. */
const ending = /She (reaches the black hole|collides with .*|is lost) at ([\d.]+) s/;

inChromium('playing in Chromium', ({ on }) => {
  it(
    'an attempt played with the mouse becomes a run, and gq check and gq simulate agree',
    on({ '01': quick() }, async ({ page, canvas, file, folder, saved }) => {
      await verdict(page, 'unproven');
      await canvas.fit(file('01'));
      // she would reach the black hole without the gun, too
      await hurry(page, 0);
      await page.keyboard.press('Space');
      await playtest(page).waitFor();
      const { x, y } = canvas.at({ x: 448, y: 400 });
      await page.mouse.move(x, y);
      await page.mouse.down();
      await hurry(page, FAST);
      await theEnd(page).waitFor();
      await page.mouse.up();
      const said = ending.exec((await theEnd(page).textContent()) ?? '');
      expect(said?.[1]).toBe('reaches the black hole');
      await playtest(page).getByRole('button', { name: 'Keep as a run' }).click();
      await playtest(page).waitFor({ state: 'hidden' });
      await verdict(page, 'completable');
      await until(() => expect(file('01').runs).toHaveLength(1));
      await saved();

      const path = join(folder, '01.level.json');
      const check = await gq(['check', path, '--format', 'json']);
      expect([check.code, JSON.parse(check.stdout).levels[0].verdict]).toEqual([0, 'completable']);
      const holds = (file('01').runs?.[0].holds ?? []).map(([press, release]) => `${press}-${release}`).join();
      const replay = await gq(['simulate', path, '--holds', holds, '--accuracy', 'precise', '--format', 'json']);
      const { outcome, time, tick, hash } = JSON.parse(replay.stdout);
      expect(outcome).toBe('completed');
      expect(time.toFixed(2)).toBe(said?.[2]);
      await page.getByRole('button', { name: 'To the end' }).click();
      await page.getByText(new RegExp(`tick ${tick} of|tick ${tick - 1} of|tick ${tick + 1} of`)).waitFor();
      const named = await gq(['simulate', path, '--format', 'json']);
      expect(JSON.parse(named.stdout).hash).toBe(hash);
      await page.getByRole('tab', { name: 'Runs' }).click();
      const shown = page.getByRole('status', { name: 'Hash of the run' });
      await until(async () => expect(await shown.textContent()).toBe(hash));
      await page.getByRole('button', { name: 'Copy the hash of the run' }).click();
      await until(async () => expect(await page.evaluate('navigator.clipboard.readText()')).toBe(hash));
      // another run has another hash
      await page.getByRole('button', { name: 'New empty run' }).click();
      await until(async () => expect(await shown.textContent()).not.toBe(hash));
      const drift = await gq(['simulate', path, '--holds', 'none', '--format', 'json']);
      await until(async () => expect(await shown.textContent()).toBe(JSON.parse(drift.stdout).hash));
    }),
  );

  it(
    'after a death a key restarts, and Esc returns to editing with the same view',
    on({ '01': deadly() }, async ({ page, canvas, file, saved, text }) => {
      await saved();
      await hurry(page, FAST);
      const before = text('01');
      await canvas.fit(file('01'));
      const zoom = await page.getByText(/^\d+ %$/).textContent();
      await page.getByRole('button', { name: 'Play', exact: true }).click();
      await page.keyboard.down('x');
      await theEnd(page).waitFor();
      await page.keyboard.up('x');
      expect(await theEnd(page).textContent()).toContain('She collides with hot asteroid 1');
      await page.keyboard.press('r');
      await theEnd(page).waitFor({ state: 'hidden' });
      await page.keyboard.down('Space');
      await theEnd(page).waitFor();
      await page.keyboard.up('Space');
      await page.keyboard.press('Escape');
      await playtest(page).waitFor({ state: 'hidden' });
      expect(await page.getByText(/^\d+ %$/).textContent()).toBe(zoom);
      // attempts do not change the file, and a click still selects objects
      expect(text('01')).toBe(before);
      await canvas.click({ x: 448, y: 304 });
      await page.keyboard.press('ArrowUp');
      await until(() => expect(file('01').asteroids?.[0]).toMatchObject({ x: 448, y: 303 }));
    }),
  );

  it(
    'Space and Enter press the buttons at the end; elsewhere Space is the gun and Enter keeps the attempt',
    on({ '01': quick() }, async ({ page, file, saved }) => {
      await saved();
      await hurry(page, FAST);
      await page.getByRole('button', { name: 'Play', exact: true }).click();
      await page.keyboard.down('Space');
      await theEnd(page).waitFor();
      await page.keyboard.up('Space');
      const again = playtest(page).getByRole('button', { name: 'Again' });
      // by herself she reaches it in three seconds, so the clock stands still until that is seen
      await hurry(page, 0);
      await again.focus();
      await page.keyboard.press('Space');
      await theEnd(page).waitFor({ state: 'hidden' });
      await hurry(page, FAST);
      // the same key is the gun again
      await page.keyboard.down('Space');
      await theEnd(page).waitFor();
      await page.keyboard.up('Space');
      expect(await theEnd(page).textContent()).toContain('She reaches the black hole');
      await hurry(page, 0);
      await again.focus();
      await page.keyboard.press('Enter');
      await theEnd(page).waitFor({ state: 'hidden' });
      await playtest(page).waitFor();
      await page.keyboard.press('Escape');
      await playtest(page).waitFor({ state: 'hidden' });
      expect(file('01').runs).toBeUndefined();
    }),
  );

  it(
    'the gun sounds while it is held, and so does the end; with the sound off there is no sound',
    on(
      { '01': quick() },
      async ({ page, saved }) => {
        await saved();
        // by herself she reaches the hole in three seconds
        await hurry(page, 0);
        const heard = () => page.evaluate(() => (window as unknown as { heard: Heard }).heard);
        await page.keyboard.press('Space');
        await playtest(page).waitFor();
        // no audio context exists before the first sound
        expect(await heard()).toEqual({ contexts: 0, oscillators: 0, levels: [] });
        await page.keyboard.down('Space');
        await until(async () => expect((await heard()).levels.at(-1)).toBeGreaterThan(0));
        expect(await heard()).toMatchObject({ contexts: 1, oscillators: 1 });
        await page.keyboard.up('Space');
        await until(async () => expect((await heard()).levels.at(-1)).toBe(0));
        await hurry(page, FAST);
        await page.keyboard.down('Space');
        await theEnd(page).waitFor();
        await page.keyboard.up('Space');
        // a mineral has two tones, the black hole four
        await until(async () => expect(await heard()).toMatchObject({ contexts: 1, oscillators: 7 }));
        await page.keyboard.press('u');
        await page.getByText('Sound is off.').waitFor();
        await hurry(page, 0);
        await page.keyboard.press('r');
        await theEnd(page).waitFor({ state: 'hidden' });
        const before = await heard();
        await hurry(page, FAST);
        await page.keyboard.down('Space');
        await theEnd(page).waitFor();
        await page.keyboard.up('Space');
        const after = await heard();
        expect(after.oscillators).toBe(before.oscillators);
        expect(after.levels.slice(before.levels.length).filter((level) => level > 0)).toEqual([]);
      },
      { before: listenToSound },
    ),
  );

  it(
    'attempts stay on the canvas as ghosts, which can be hidden, kept as runs and deleted',
    on(
      { '01': deadly() },
      async ({ page, canvas, file, saved }) => {
        await saved();
        await hurry(page, FAST);
        await canvas.fit(file('01'));
        // between her start and the asteroid that ends it
        const middle = canvas.at({ x: 330, y: 304 });
        const look = () => page.screenshot({ clip: { x: middle.x - 20, y: middle.y - 20, width: 40, height: 40 } });
        await nextFrames(page);
        const empty = await look();
        await page.keyboard.press('Space');
        await page.keyboard.down('x');
        await theEnd(page).waitFor();
        await page.keyboard.up('x');
        await page.keyboard.press('Escape');
        await playtest(page).waitFor({ state: 'hidden' });
        await until(async () => expect(empty.equals(await look())).toBe(false));
        await page.getByRole('tab', { name: 'Runs' }).click();
        const attempts = page.getByRole('region', { name: 'Attempts' });
        await attempts.getByText(/collides · \d/).waitFor();
        await attempts.getByRole('button', { name: 'Hide attempt 1 on the canvas' }).click();
        await until(async () => expect(empty.equals(await look())).toBe(true));
        await attempts.getByRole('button', { name: 'Show all attempts on the canvas' }).click();
        await until(async () => expect(empty.equals(await look())).toBe(false));
        expect(file('01').runs).toBeUndefined();
        await attempts.getByRole('button', { name: 'Keep attempt 1 as a run' }).click();
        await until(() => expect(file('01').runs?.map(({ name }) => name)).toEqual(['attempt 1']));
        await page.keyboard.press('Control+z');
        await until(() => expect(file('01').runs).toBeUndefined());
        await attempts.getByRole('button', { name: 'Discard all attempts' }).click();
        await attempts.waitFor({ state: 'hidden' });
        await until(async () => expect(empty.equals(await look())).toBe(true));
      },
      { context: { reducedMotion: 'reduce' } },
    ),
  );

  it(
    'a playtest starts at the scrubbed tick and keeps the run before it',
    on(
      {
        '01': straight({
          blackHole: { x: 400, y: 304 },
          runs: [
            {
              name: 'try',
              holds: [
                [0, 40],
                [50, 60],
              ],
            },
          ],
        }),
      },
      async ({ page, file }) => {
        await verdict(page, 'broken');
        await hurry(page, FAST);
        await page.getByRole('slider', { name: 'Time' }).focus();
        await page.keyboard.press('Home');
        for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+ArrowRight');
        await page.keyboard.press('Shift+Space');
        await playtest(page).waitFor();
        await page.keyboard.down('Space');
        await theEnd(page).waitFor();
        await page.keyboard.up('Space');
        expect(await theEnd(page).textContent()).toContain('She reaches the black hole');
        await page.keyboard.press('Enter');
        await verdict(page, 'completable');
        // the attempt replaces the run that did not complete the level
        const runs = await until(() => {
          const found = file('01').runs ?? [];
          expect(found[0].holds[0][1]).not.toBe(40);
          return found;
        });
        expect(runs.map(({ name }) => name)).toEqual(['try']);
        expect(runs[0].holds[0]).toEqual([0, expect.any(Number)]);
        expect(runs[0].holds[0][1]).toBeGreaterThanOrEqual(30);
      },
    ),
  );

  it(
    'an attempt is there again after a reload right at its end, and at its level only',
    on({ '01': quick(), '02': straight() }, async ({ page, saved }) => {
      await saved();
      await hurry(page, FAST);
      await page.getByRole('button', { name: 'Play', exact: true }).click();
      await theEnd(page).waitFor();
      await page.reload();
      await saved();
      const attempts = page.getByRole('tree', { name: 'Attempts at the level' });
      const listed = async () => {
        await page.getByRole('tab', { name: 'Attempts' }).click();
        await until(async () => expect(await attempts.getByRole('treeitem').count()).toBe(1));
      };
      await listed();
      // another level has none
      const levels = page.getByRole('tree', { name: 'Levels' });
      await levels
        .getByRole('treeitem', { name: /Straight/ })
        .nth(1)
        .click();
      await until(async () => expect(await attempts.count()).toBe(0));
      await levels
        .getByRole('treeitem', { name: /Straight/ })
        .nth(0)
        .click();
      await listed();
    }),
  );
});
