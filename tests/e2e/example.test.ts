import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import type { BrowserContextOptions, Page } from 'playwright-core';
import { afterAll, describe, expect, it } from 'vitest';
import type { AccuracyName } from '../../engine/index.ts';
import { createPlayer, encodePlay, playOf, playToText } from '../../game/index.ts';
import { levelFragment } from '../../phaser/links/index.ts';
import { readLevel } from '../../schema/index.ts';
import { declareMissing } from '../missing.ts';
import { complaintsAbout } from './axe.ts';
import { CHROMIUM, sharedChromium } from './chromium.ts';
import { hurry, nextFrames, paceFrames, pass } from './frames.ts';
import { straight } from './levels.ts';
import { type Heard, listenToSound } from './sound.ts';
import { PATIENCE, until } from './until.ts';

// The built game as a page from a file, the strictest place that it must work in.

const SITE = fileURLToPath(new URL('../../dist/site', import.meta.url));
const LEVELS = fileURLToPath(new URL('../../levels', import.meta.url));

const fileOf = (name: string): unknown => JSON.parse(readFileSync(join(LEVELS, `${name}.level.json`), 'utf8'));

/** The text of a play of a level by its own run. */
function playText(file: unknown, run = 0, accuracy: AccuracyName = 'precise'): string {
  const reading = readLevel(Buffer.from(JSON.stringify(file)));
  if (!reading.ok) throw new Error(reading.problems[0].message);
  const player = createPlayer(reading.level, { accuracy, replay: reading.level.runs[run].holds });
  while (player.ending === null) player.advance(100);
  return playToText(encodePlay(playOf(player)));
}

/** She flies through the mineral into the black hole within a second, whatever the gun does. */
const quick = (name: string) =>
  straight({
    name,
    // a level's hash does not cover its name
    astronaut: { x: 200 + name.length, y: 304, vx: name === 'One' ? 190 : 200 },
    blackHole: { x: 340, y: 304 },
    minerals: [{ x: 260, y: 304 }],
    runs: [{ name: 'solution', holds: [[5, 10]] }],
  });

const three = () => ({
  title: 'Three',
  levels: ['One', 'Two', 'Three'].map((name) => ({ id: name.toLowerCase(), level: quick(name) })),
});

/** She starts beside a nova and flies into it. */
const deadly = () =>
  straight({
    name: 'Deadly',
    astronaut: { x: 200, y: 304, vx: 120 },
    novae: [{ x: 300, y: 304, radius: 16 }],
    blackHole: { x: 700, y: 304 },
    minerals: [],
    runs: undefined,
  });

const card = (page: Page, name: string) => page.getByRole('list', { name: 'Levels' }).getByRole('button', { name });
const panel = (page: Page, name: string | RegExp) => page.getByRole('dialog', { name });
const level = (page: Page) => page.locator('main.level');
const clock = (page: Page) => page.locator('.clock').textContent();

const suite = 'the example game in Chromium';
if (!existsSync(CHROMIUM)) declareMissing(suite, `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
else {
  describe(suite, () => {
    const folders: string[] = [];
    afterAll(() => {
      for (const folder of folders) rmSync(folder, { recursive: true, force: true });
    });

    /** The page of a pack; the shipped levels if none is given. */
    function siteOf(pack?: unknown): string {
      const folder = mkdtempSync(join(tmpdir(), 'gq-example-'));
      folders.push(folder);
      cpSync(SITE, folder, { recursive: true });
      if (pack !== undefined) {
        const script = typeof pack === 'string' ? pack : `globalThis.GRAVITY_QUEST_PACK = ${JSON.stringify(pack)};`;
        writeFileSync(join(folder, 'pack.js'), script);
      }
      return pathToFileURL(join(folder, 'index.html')).href;
    }

    interface Visit {
      readonly pack?: unknown;
      readonly query?: string;
      readonly fragment?: string;
      readonly context?: BrowserContextOptions;
      /** Runs in the page before its own scripts. */
      readonly before?: () => void;
    }

    /** Runs a test in a browser of its own; the page must log no error. */
    const on =
      (visit: Visit, play: (page: Page, address: string) => Promise<void>): (() => Promise<void>) =>
      async () => {
        const browser = await sharedChromium();
        const context = await browser.newContext({ viewport: { width: 1024, height: 768 }, ...visit.context });
        await context.addInitScript(paceFrames);
        if (visit.before !== undefined) await context.addInitScript(visit.before);
        const complaints: string[] = [];
        const page = await context.newPage();
        page.setDefaultTimeout(PATIENCE);
        page.on('pageerror', (error) => complaints.push(error.stack ?? error.message));
        page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
        const address = siteOf(visit.pack);
        try {
          await page.goto(`${address}${visit.query ?? ''}${visit.fragment ?? ''}`);
          await play(page, address);
          expect(complaints).toEqual([]);
        } finally {
          await context.close();
        }
      };

    it(
      'plays a level with its stars, opens the next one, and keeps the progress after a reload',
      on({ pack: three(), query: '?replay' }, async (page) => {
        await page.getByRole('heading', { level: 1, name: 'Three' }).waitFor();
        await page.getByText('0 of 3 levels · ★ 0 of 3').waitFor();
        expect(await complaintsAbout(page, 'menu')).toEqual([]);
        const locked = card(page, 'Two');
        expect(await locked.getAttribute('aria-disabled')).toBe('true');
        await locked.dispatchEvent('click');
        expect(await level(page).isVisible()).toBe(false);

        await page.getByRole('button', { name: 'Play · One' }).click();
        await panel(page, 'Completed').locator('.good').getByText('Completed for the first time').waitFor();
        await panel(page, 'Completed').getByRole('img', { name: '1 of 1 star' }).waitFor();
        expect(await complaintsAbout(page, 'completed', 'dialog')).toEqual([]);
        await page.keyboard.press('Enter');
        await page.getByRole('heading', { level: 1, name: '02 Two' }).waitFor();
        await panel(page, 'Completed').getByRole('button', { name: 'Levels' }).click();

        const reached = async () => {
          await page.getByText('2 of 3 levels · ★ 2 of 3').waitFor();
          await card(page, '02 Two').getByRole('img', { name: '1 of 1 star' }).waitFor();
          expect(await card(page, '03 Three').getAttribute('aria-disabled')).toBeNull();
        };
        await reached();
        await page.reload();
        await reached();
      }),
    );

    it(
      'offers no level that is locked as the next one',
      on({ pack: three() }, async (page) => {
        const next = panel(page, 'Paused').getByRole('button', { name: 'Next' });
        // she would be through within a second
        await hurry(page, 0);
        await page.getByRole('button', { name: 'Play · One' }).click();
        await page.locator('[data-state=intro]').waitFor();
        await page.keyboard.press('n');
        await page.keyboard.press('Space');
        await page.keyboard.press('Escape');
        await panel(page, 'Paused').waitFor();
        expect(await page.getByRole('heading', { level: 1 }).allTextContents()).toContain('01 One');
        expect(await next.count()).toBe(0);
        await panel(page, 'Paused').getByRole('button', { name: 'Levels' }).click();
        await page.getByLabel('unlock all levels').check();
        await card(page, 'One').click();
        await page.keyboard.press('Space');
        await page.keyboard.press('Escape');
        await next.click();
        await page.getByRole('heading', { level: 1, name: '02 Two' }).waitFor();
      }),
    );

    it(
      'goes back to the menu, also after the page was loaded again within a level',
      on({ pack: three() }, async (page) => {
        const menu = page.getByRole('heading', { level: 1, name: 'Three' });
        await page.getByLabel('unlock all levels').check();
        await card(page, 'One').click();
        await page.locator('[data-state=intro]').waitFor();
        await page.reload();
        await menu.waitFor();
        await card(page, 'Two').click();
        await page.getByRole('heading', { level: 1, name: '02 Two' }).waitFor();
        await page.keyboard.press('l');
        await level(page).waitFor({ state: 'hidden' });
        await menu.waitFor();
      }),
    );

    it(
      'has the shipped levels, of which a designer can unlock all',
      on({}, async (page) => {
        await page.getByText('0 of 22 levels').waitFor();
        expect(await page.locator('[aria-disabled]').count()).toBe(21);
        await page.getByLabel('unlock all levels').check();
        expect(await page.locator('[aria-disabled]').count()).toBe(0);
        await card(page, 'Vault').click();
        await page.locator('[data-state=intro]').waitFor();
      }),
    );

    it(
      'is played with Space and mouse: the first press starts the time, and R restarts within a frame',
      on({ pack: { title: 'Two', levels: [{ id: 'a', level: deadly() }] } }, async (page) => {
        await hurry(page, 0);
        await page.keyboard.press('Enter');
        await page.locator('[data-state=intro]').waitFor();
        await pass(page, 500);
        await nextFrames(page);
        expect(await clock(page)).toBe('0.0 s');
        await page.keyboard.down('Space');
        await page.locator('[data-state=playing]').waitFor();
        await page.keyboard.up('Space');
        for (let i = 0; i < 3; i++) {
          await nextFrames(page);
          await pass(page, 90);
        }
        await nextFrames(page);
        expect(await clock(page)).toBe('0.2 s');
        // what the next frame shows
        const after = await page.evaluate(
          () =>
            new Promise((resolve) => {
              window.dispatchEvent(new KeyboardEvent('keydown', { key: 'r', code: 'KeyR' }));
              const { attempt } = document.querySelector<HTMLElement>('main.level')?.dataset ?? {};
              requestAnimationFrame(() => setTimeout(() => resolve([attempt, document.querySelector('.clock')?.textContent])));
            }),
        );
        expect(after).toEqual(['2', '0.0 s']);

        // death, and the next attempt by itself
        const flyUntil = async (state: string) => {
          while ((await page.locator(state).count()) === 0) {
            await pass(page, 90);
            await nextFrames(page);
          }
        };
        await flyUntil('[data-attempt="2"][data-state=dead]');
        await page.locator('.toast').getByText('Collided with a nova.').waitFor();
        await flyUntil('[data-attempt="3"][data-state=playing]');
        // the press after a death does not wait for it
        await flyUntil('[data-attempt="3"][data-state=dead]');
        await pass(page, 300);
        await nextFrames(page);
        await page.mouse.move(500, 500);
        await page.mouse.down();
        await page.locator('[data-attempt="4"][data-state=playing]').waitFor();
        await page.mouse.up();

        await page.keyboard.press('Escape');
        await panel(page, 'Paused').waitFor();
        expect(await complaintsAbout(page, 'paused', 'dialog')).toEqual([]);
        await page.keyboard.press('Escape');
        await page.locator('[data-state=playing]').waitFor();
        await page.goBack();
        await page.getByRole('heading', { level: 1, name: 'Two' }).waitFor();
      }),
    );

    it(
      'names a level that is not valid with its file and reason, and plays the others',
      on(
        {
          pack: {
            title: 'Broken',
            levels: [
              { id: 'good', level: fileOf('01-first-pull') },
              { id: 'bad', level: { ...straight(), blackHole: { x: 'far', y: 0 } } },
              { id: 'good', level: straight() },
              7,
              { id: 'last', level: fileOf('02-first-swing') },
            ],
          },
        },
        async (page) => {
          const broken = page.locator('.card.broken');
          await until(async () => expect(await broken.count()).toBe(3));
          const texts = await broken.allTextContents();
          expect(texts[0]).toMatch(/bad\.level\.json: .*expected.*number.*\(at \/blackHole\/x\)/);
          expect(texts[1]).toContain('the id “good” is taken');
          expect(texts[2]).toContain('level-4.level.json: expected { id, level }, found number');
          await page.getByText('0 of 2 levels').waitFor();
          await card(page, 'First Pull').click();
          await page.locator('[data-state=intro]').waitFor();
        },
      ),
    );

    it.each([
      ['missing', '// nothing', /pack\.js was not loaded/],
      ['damaged', { levels: 7 }, /pack\.js is damaged/],
      ['empty', { title: 'None', levels: [] }, /has no levels/],
      ['of an unknown accuracy', { title: 'None', accuracy: 'exact', levels: [] }, /expected one of arcade, .*found "exact"/],
      ['without a time', { title: 'None', maxTime: 0, levels: [] }, /expected seconds, .* as "maxTime", found 0/],
    ])('says that the pack is %s', (_, pack, message) =>
      on({ pack }, (page) => page.getByRole('alert').getByText(message).waitFor())(),
    );

    it(
      'shows the play of a link as a rival, and links to a play',
      on({ pack: three(), query: '?replay', fragment: `#play=${playText(quick('Two'))}` }, async (page, address) => {
        await panel(page, 'Race this play')
          .getByText(/Two: it reaches the black hole, [\d.]+ s with 1 of 1 star/)
          .waitFor();
        await page.keyboard.press('Enter');
        await panel(page, 'Completed').locator('.good').getByText('As fast as the play of the link').waitFor();
        await page.evaluate('navigator.clipboard.writeText = () => Promise.reject(new Error("refused"))');
        await page.getByRole('button', { name: 'Copy a link' }).click();
        const link = await page.getByLabel('Text to copy').inputValue();
        expect(link).toBe(`${address}?replay#play=${playText(quick('Two'))}`);
        const [file] = await Promise.all([
          page.waitForEvent('download'),
          page.getByRole('button', { name: 'Save this play' }).click(),
        ]);
        expect(file.suggestedFilename()).toBe('two.gqr');
        const saved = readFileSync(await file.path());
        expect(saved.toString('base64url')).toBe(playText(quick('Two')));
        // and back in, as a file
        await panel(page, 'Completed').getByRole('button', { name: 'Levels' }).click();
        const [chooser] = await Promise.all([
          page.waitForEvent('filechooser'),
          page.getByRole('button', { name: 'Open a play (.gqr)' }).click(),
        ]);
        await chooser.setFiles({ name: 'mine.gqr', mimeType: 'application/octet-stream', buffer: saved });
        await panel(page, 'Race this play').getByRole('button', { name: 'Watch it' }).click();
        await panel(page, 'She reaches the black hole.').getByRole('button', { name: 'Race it' }).waitFor();
      }),
    );

    it(
      'plays a pack, a link and the plays of others under the terms of the pack',
      on({ pack: { ...three(), accuracy: 'arcade' }, fragment: `#play=${playText(quick('Two'), 0, 'arcade')}` }, async (page) => {
        await panel(page, 'Race this play').getByRole('button', { name: 'Watch it' }).click();
        await panel(page, 'She reaches the black hole.').waitFor();
      }),
    );

    it('plays a level of a link under the terms of the link, and sends them along', async () => {
      const terms = `${await levelFragment(JSON.stringify(quick('Two')))}&accuracy=arcade&max-time=90`;
      const play = `play=${playText(quick('Two'), 0, 'arcade')}`;
      await on({ query: '?replay', fragment: `#${terms}&${play}` }, async (page, address) => {
        await panel(page, 'Race this play').getByRole('button', { name: 'Race it' }).click();
        await panel(page, 'Completed').locator('.good').getByText('As fast as the play of the link').waitFor();
        await page.evaluate('navigator.clipboard.writeText = () => Promise.reject(new Error("refused"))');
        await page.getByRole('button', { name: 'Copy a link' }).click();
        expect(await page.getByLabel('Text to copy').inputValue()).toBe(`${address}?replay#${terms}&${play}`);
      })();
      await on({ fragment: `#${terms.replace('arcade', 'exact')}` }, async (page) => {
        await page
          .getByRole('alert')
          .getByText(/expected one of arcade, .*found "exact"/)
          .waitFor();
      })();
    });

    it.each([
      ['a damaged play', `#play=${playText(fileOf('02-first-swing')).slice(0, -9)}`, /The play can't be shown/],
      ['no play', '#play=???', /The play can't be shown: it is damaged/],
      ['a play of an unknown level', `#play=${playText(straight())}`, /it belongs to a level that is not here/],
      ['a damaged level', '#level=abc', /the level in this link is damaged/],
      [
        'a play at another accuracy',
        `#play=${playText(fileOf('02-first-swing'), 0, 'arcade')}`,
        /expected a play at the accuracy precise, found one at arcade/,
      ],
    ])('says that a link has %s, and stays playable', (_, fragment, message) =>
      on({ fragment }, async (page) => {
        await page.getByRole('alert').getByText(message).waitFor();
        await page.getByRole('button', { name: 'Play · First Pull' }).click();
        await page.locator('[data-state=intro]').waitFor();
      })(),
    );

    it(
      'is playable where the browser refuses storage, and says so',
      on(
        {
          pack: three(),
          query: '?replay',
          before: () => {
            Object.defineProperty(window, 'localStorage', {
              get() {
                throw new DOMException('refused', 'SecurityError');
              },
            });
          },
        },
        async (page) => {
          await page.getByText(/progress lasts until the page is closed/).waitFor();
          await page.getByRole('button', { name: 'Play · One' }).click();
          await panel(page, 'Completed').getByRole('button', { name: 'Levels' }).click();
          await page.getByText('1 of 3 levels').waitFor();
        },
      ),
    );

    it(
      'sounds after a gesture only, and not when muted, also after a reload',
      on({ before: listenToSound }, async (page) => {
        const heard = () => page.evaluate('heard') as Promise<Heard>;
        await page.getByRole('button', { name: 'Play · First Pull' }).waitFor();
        expect((await heard()).contexts).toBe(0);
        await page.keyboard.press('Enter');
        await page.locator('[data-state=intro]').waitFor();
        await page.keyboard.down('Space');
        await until(async () => expect((await heard()).levels.some((one) => one > 0)).toBe(true));
        expect((await heard()).contexts).toBe(1);
        await page.keyboard.press('m');
        await until(async () => expect((await heard()).levels.at(-1)).toBe(0));
        await page.reload();
        await page.getByRole('button', { name: 'Turn the sound on' }).waitFor();
      }),
    );

    it.each([
      [360, 740],
      [740, 360],
      [1024, 768],
    ])('fits a screen of %i x %i px', (width, height) =>
      on({ context: { viewport: { width, height } } }, async (page) => {
        const overflow = () =>
          page.evaluate(() => {
            const wide = document.documentElement.clientWidth;
            return [...document.querySelectorAll('main:not([hidden]) *, dialog[open] *')]
              .filter((one) => one.getClientRects().length > 0 && !one.closest('.unseen'))
              .filter((one) => one.getBoundingClientRect().right > wide + 1 || one.getBoundingClientRect().left < -1)
              .map((one) => one.className);
          });
        await page.getByRole('button', { name: 'Play · First Pull' }).waitFor();
        expect((await overflow()).filter((name) => name !== 'hole')).toEqual([]);
        await page.keyboard.press('Enter');
        await page.locator('[data-state=intro]').waitFor();
        expect(await overflow()).toEqual([]);
        await page.keyboard.press('Space');
        await page.keyboard.press('Escape');
        await panel(page, 'Paused').waitFor();
        expect(await overflow()).toEqual([]);
        const { top, bottom } = await page.evaluate(() => {
          const box = document.querySelector('dialog')?.getBoundingClientRect() as DOMRect;
          return { top: box.top, bottom: box.bottom };
        });
        expect(top).toBeGreaterThanOrEqual(0);
        expect(bottom).toBeLessThanOrEqual(height);
      })(),
    );
  });
}
