import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { createPlayer, playToText, verifyPlay } from '../../game/index.ts';
import { type Hold, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { recordedPlay } from '../editor/recorded-play.ts';
import { command } from './commands.ts';
import { drop } from './drop.ts';
import { hurry } from './frames.ts';
import { straight } from './levels.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

/** She drifts downwards out of range; the gun pulls her towards a hot asteroid and past it into a nova. */
const lane = (changes: Readonly<Record<string, unknown>> = {}): LevelFile =>
  straight({
    astronaut: { x: 200, y: 304, vy: 20 },
    asteroids: [{ id: 'rock', x: 420, y: 304, radius: 24, hot: true }],
    novae: [{ id: 'nova', x: 240, y: 420, radius: 30 }],
    blackHole: { x: 300, y: 304 },
    minerals: [],
    runs: undefined,
    ...changes,
  }) as unknown as LevelFile;

const panel = (page: Page) => page.getByRole('region', { name: 'Attempts and plays' });
const rows = (page: Page) => panel(page).getByRole('treeitem');
const messages = (page: Page) => page.getByRole('list', { name: 'Messages' });
const showAttempts = (page: Page) => page.getByRole('tab', { name: 'Attempts' }).click();
const HOLD: readonly Hold[] = [[20, 200]];

/** Where she is at the end of a play, px. */
function endOf(file: LevelFile, replay: readonly Hold[]): { x: number; y: number } {
  const player = createPlayer(resolveLevel(file), { replay });
  while (player.ending === null) player.advance(100);
  return { x: player.state[0], y: player.state[1] };
}

inChromium('plays in Chromium', ({ on }) => {
  it(
    'a dropped play becomes an attempt: listed with its end, drawn as a ghost, replayed, kept as a run',
    on(
      { '01': lane() },
      async ({ page, canvas, file, saved }) => {
        await saved();
        await showAttempts(page);
        await panel(page).getByText('Nobody has played this level here yet.').waitFor();
        await drop(page, { 'ann.gqr': recordedPlay(lane(), HOLD), 'bob.gqr': recordedPlay(lane(), [], 60) });
        await messages(page).getByText('2 plays were opened').waitFor();
        await rows(page)
          .filter({ hasText: 'ann.gqr' })
          .getByText(/She hits nova 1 at \d/)
          .waitFor();
        await rows(page).filter({ hasText: 'bob.gqr' }).getByText('She was left at 1.00 s.').waitFor();

        // by keys: the list selects, and the selected path is drawn
        await canvas.fit(file('01'));
        const { x, y } = endOf(lane(), HOLD);
        const end = canvas.at({ x, y });
        const blue = () => countColour(page, end, 12, COLOURS.dark.select);
        expect(await blue()).toBe(0);
        await panel(page).getByRole('tree').focus();
        await page.keyboard.press('End');
        await until(async () => expect(await rows(page).last().getAttribute('aria-selected')).toBe('true'));
        await until(async () => expect(await blue()).toBeGreaterThan(10));

        // Enter replays it
        await hurry(page, 0);
        await rows(page).filter({ hasText: 'ann.gqr' }).click();
        await page.keyboard.press('Enter');
        const replay = page.getByRole('application', { name: 'Replay of ann.gqr' });
        await replay.getByText(/She hits nova 1/).waitFor();
        const time = replay.getByRole('slider', { name: 'Time of the replay' });
        await time.focus();
        await page.keyboard.press('End');
        await until(async () => expect(await time.getAttribute('aria-valuetext')).toMatch(/^tick (\d+) of \1,/));
        await page.keyboard.press('Home');
        await until(async () => expect(await time.getAttribute('aria-valuetext')).toMatch(/^tick 0 of/));
        await replay.getByRole('button', { name: 'Keep it in the level as a run' }).click();
        await replay.waitFor({ state: 'hidden' });
        await until(() => expect(file('01').runs?.map(({ name }) => name)).toEqual(['ann']));
        const kept = file('01').runs?.[0].holds ?? [];
        expect(kept[0][0]).toBe(20);
        expect(verifyPlay(resolveLevel(file('01')), recordedPlay(lane(), kept)).verdict).toBe('ok');
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );

  it(
    'a play of another level of the folder offers to open it; others and what is no play are refused by name',
    on({ '01': lane(), '02': lane({ name: 'Second', range: 700 }) }, async ({ page, saved }) => {
      await saved();
      const third = lane({ range: 800 });
      await drop(page, {
        'second.gqr': recordedPlay(lane({ range: 700 }), HOLD),
        'gone.gqr': recordedPlay(third, HOLD),
        'broken.gqr': recordedPlay(lane(), HOLD).subarray(0, 40),
        'photo.gqr': 'no play',
      });
      const refused = messages(page).getByRole('listitem').filter({ hasText: '3 files of 4 were not opened' });
      await refused
        .getByText(/gone\.gqr: stale-level: expected a play of the open level, “Straight”, found one of level/)
        .waitFor();
      await refused.getByText(/broken\.gqr: malformed: byte 13: expected .*cut off/).waitFor();
      await refused.getByText(/photo\.gqr: malformed: byte 0: expected a play/).waitFor();
      await messages(page).getByText('second.gqr is a play of another level of this folder, “Second”.').waitFor();
      await messages(page).getByRole('button', { name: 'Open Second' }).click();
      await page.getByRole('heading', { level: 1, name: 'Second' }).waitFor();
      await rows(page).filter({ hasText: 'second.gqr' }).waitFor();
    }),
  );

  it(
    'plays of a level before a change are named as such, stay until plays of the changed level are opened, and can be closed',
    on(
      { '01': lane() },
      async ({ page, canvas, file, saved }) => {
        await saved();
        await drop(page, { 'before.gqr': recordedPlay(lane(), HOLD) });
        await messages(page).getByText('before.gqr was opened.').waitFor();
        const note = panel(page).getByRole('note');
        expect(await note.count()).toBe(0);
        await canvas.fit(file('01'));
        await canvas.click({ x: 420, y: 304 });
        await page.keyboard.press('ArrowUp');
        await note.getByText(/^The level has changed since these plays\./).waitFor();
        const changed = await until(() => {
          const now = file('01');
          expect(now.asteroids?.[0]).toMatchObject({ x: 420, y: 303 });
          return now;
        });
        await drop(page, { 'after.gqr': recordedPlay(changed, HOLD) });
        await messages(page).getByText('The plays of the level before its change were closed.').waitFor();
        expect(await rows(page).allTextContents()).toEqual([expect.stringContaining('after.gqr')]);
        await note.waitFor({ state: 'hidden' });
        await panel(page)
          .getByText(/^1 play: 0 % complete the level/)
          .waitFor();
        await panel(page).getByRole('button', { name: 'Close all opened plays' }).click();
        await panel(page).getByText('Nobody has played this level here yet.').waitFor();
      },
      { context: { reducedMotion: 'reduce' } },
    ),
  );

  it(
    'hundreds of plays: the list filters and sorts, and the heat map shows where and why she dies',
    on({ '01': lane() }, async ({ page, canvas, file, saved }) => {
      await saved();
      await canvas.fit(file('01'));
      const dead = recordedPlay(lane(), HOLD);
      const place = verifyPlay(resolveLevel(lane()), dead);
      expect(place.ending?.outcome).toBe('collided');
      const files = Object.fromEntries(
        Array.from({ length: 200 }, (_, i) => {
          const left = recordedPlay(lane(), [], 60 + i);
          const played = recordedPlay(lane(), [[20 + (i % 5), 90 + i]]);
          return [`${i}.gqr`, i % 4 === 0 ? left : played];
        }),
      );
      // after her death, other holds are the same play
      const different = [...new Map(Object.values(files).map((bytes) => [playToText(bytes), bytes])).values()];
      const endings = different.map((bytes) => verifyPlay(resolveLevel(lane()), bytes).ending);
      const [all, left] = [different.length, endings.filter((ending) => ending === null).length];
      const novae = endings.filter((ending) => ending?.with?.kind === 'nova').length;
      expect([all > 120, left, novae > 50]).toEqual([true, 50, true]);
      await drop(page, files);
      await messages(page).getByText(`${all} plays were opened`).waitFor();
      await panel(page).getByText(`${all} attempts`).waitFor();
      // only what is seen is rendered
      expect(await rows(page).count()).toBeLessThan(60);
      await panel(page).getByRole('combobox', { name: 'Show' }).selectOption('left');
      await panel(page).getByText(`${left} of ${all} attempts`).waitFor();
      await panel(page).getByRole('combobox', { name: 'Show' }).selectOption('all');
      await panel(page).getByRole('searchbox').fill('nova 1');
      await panel(page).getByText(`${novae} of ${all} attempts`).waitFor();
      await panel(page).getByRole('searchbox').fill('');
      await panel(page).getByRole('combobox', { name: 'Order' }).selectOption('name');
      await until(async () => expect(await rows(page).first().textContent()).toContain('0.gqr'));

      const legend = page.getByRole('figure', { name: 'Heat map of deaths' });
      await legend.getByText(`${all - left} deaths, counted in squares of 24 px`).waitFor();
      const first = panel(page)
        .getByRole('list')
        .getByRole('button', { name: /nova 1/ })
        .first();
      expect(await first.textContent()).toMatch(/^\d+× she hits nova 1 at \d+, \d+$/);
      const [, x, y] = /at (\d+), (\d+)$/.exec((await first.textContent()) ?? '') ?? [];
      const at = canvas.at({ x: Number(x), y: Number(y) });
      await page.mouse.move(at.x, at.y);
      await page
        .getByRole('tooltip')
        .filter({ hasText: /^\d+× she hits nova 1/ })
        .waitFor();
      const look = () => page.screenshot({ clip: { x: at.x - 30, y: at.y - 30, width: 60, height: 60 } });
      await page.mouse.move(5, 5);
      const hot = await look();
      await command(page, 'Show or hide the heat map of deaths');
      await legend.waitFor({ state: 'hidden' });
      await until(async () => expect(hot.equals(await look())).toBe(false));
    }),
  );

  it(
    'an attempt is copied as text and as a link, and both open it again',
    on({ '01': lane() }, async ({ page, saved }) => {
      await saved();
      await hurry(page, 8);
      await page.keyboard.press('Space');
      const playtest = page.getByRole('application', { name: /^Playtest/ });
      await page.keyboard.down('x');
      await playtest.getByRole('status').waitFor();
      await page.keyboard.up('x');
      await page.keyboard.press('Escape');
      await playtest.waitFor({ state: 'hidden' });
      await showAttempts(page);
      await rows(page).filter({ hasText: 'attempt 1' }).click({ button: 'right' });
      await page.getByRole('menuitem', { name: 'Copy as text' }).click();
      await messages(page).getByText('Copied attempt 1 as text.').waitFor();
      const text = await page.evaluate(() => navigator.clipboard.readText());
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('Control+v');
      await messages(page).getByText('the clipboard was opened.').waitFor();
      await rows(page).filter({ hasText: 'the clipboard' }).waitFor();

      await rows(page).filter({ hasText: 'attempt 1' }).click({ button: 'right' });
      await page.getByRole('menuitem', { name: 'Copy a link' }).click();
      await messages(page).getByText('Copied a link to attempt 1.').waitFor();
      const link = await page.evaluate(() => navigator.clipboard.readText());
      expect(link).toContain(`&play=${text}`);
      expect(text).toBe(playToText(Buffer.from(text, 'base64url')));
      // what was opened before does not open it
      await panel(page).getByRole('button', { name: 'Close all opened plays' }).click();
      await rows(page).filter({ hasText: 'the clipboard' }).waitFor({ state: 'hidden' });
      await page.evaluate((hash) => {
        location.hash = hash;
      }, new URL(link).hash);
      await rows(page).filter({ hasText: 'the play of the link' }).waitFor();
      // the folder has the level of the link, so that the page does not ask whether to add it
      expect(await page.getByRole('dialog').count()).toBe(0);
      await until(async () => expect(await page.evaluate(() => location.hash)).not.toMatch(/play=|level=/));
    }),
  );
});
