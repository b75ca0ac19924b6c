import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { compile, STATE_SIZE, simulate, TICK } from '../../engine/index.ts';
import { type Hold, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { recordedPlay } from '../editor/recorded-play.ts';
import { complaintsAbout } from './axe.ts';
import { command } from './commands.ts';
import { drop } from './drop.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

/** She drifts into the black hole unless the weak gun bends her way; past it she is too fast to come back. */
const past = (changes: Partial<LevelFile> = {}): LevelFile => ({
  version: 1,
  name: 'Past it',
  astronaut: { x: 0, y: 0, vx: 60 },
  blackHole: { x: 150, y: 30 },
  range: 160,
  rules: { pull: 10 },
  asteroids: [{ id: 'rock', x: 60, y: -100, radius: 16 }],
  // so that the view reaches far enough to the right
  minerals: [{ id: 'gem', x: 330, y: 60, radius: 7 }],
  runs: [
    { name: 'hold', holds: [[0, 600]] },
    { name: 'drift', holds: [] },
  ],
  ...changes,
});

const HELD: readonly Hold[] = [[0, 600]];
const ATTEMPT: readonly Hold[] = [[10, 300]];
const endOf = (file: LevelFile, holds: readonly Hold[]): number => simulate(compile(resolveLevel(file)), holds).time;

const legend = (page: Page) => page.getByRole('figure', { name: 'Lost states' });
const mark = (page: Page) => page.getByRole('img', { name: /^lost from / });
/** Since when the shown run is lost, as the legend says it, s. */
async function lostFrom(page: Page): Promise<number> {
  const text = await legend(page)
    .getByText(/lost from \d/)
    .textContent();
  return Number(/lost from ([\d.]+) s/.exec(text ?? '')?.[1]);
}
/** The proved states that the legend counts. */
const proved = async (page: Page): Promise<number> =>
  Number(
    /\d+/.exec(
      (await legend(page)
        .getByText(/^proved lost/)
        .textContent()) ?? '',
    )?.[0],
  );

inChromium('lost states in Chromium', ({ on }) => {
  it(
    'a key shades them: the shown run says since when it is lost, on the canvas, in the timeline and in words; a change throws it away',
    on(
      { '01': past() },
      async ({ page, canvas, file, saved, text }) => {
        await saved();
        const before = text('01');
        await canvas.fit(file('01'));
        expect(await legend(page).count()).toBe(0);
        await page.keyboard.press('l');
        await legend(page).waitFor();
        await legend(page)
          .getByText(/hold: lost from/)
          .waitFor();
        // the same moment at all places; it may still become an earlier one
        const from = await until(async () => {
          const seconds = await lostFrom(page);
          const note = page.getByRole('note', { name: 'Where the run is lost' });
          expect(await note.textContent()).toContain(`lost from ${seconds.toFixed(2)} s`);
          expect(await mark(page).getAttribute('aria-label')).toContain(`lost from ${seconds.toFixed(2)} s on (proved)`);
          return seconds;
        });
        const end = endOf(past(), HELD);
        expect(from).toBeGreaterThan(0);
        expect(from).toBeLessThan(end - 1);
        await legend(page)
          .getByText(`ends at ${end.toFixed(2)} s`, { exact: false })
          .waitFor();

        const { x, y } = stateAt(from);
        await until(async () => expect(await countColour(page, canvas.at({ x, y }), 8, COLOURS.dark.lost)).toBeGreaterThan(10));

        // the shade is refined while one waits
        await until(async () => expect(await proved(page)).toBeGreaterThan(0));
        expect(await complaintsAbout(page, 'lost states')).toEqual([]);
        expect(text('01')).toBe(before);

        // a run that completes the level is not lost
        await page.getByRole('combobox', { name: 'Run' }).selectOption('drift');
        await until(async () => expect(await mark(page).count()).toBe(0));
        await page.getByRole('combobox', { name: 'Run' }).selectOption('hold');
        await mark(page).waitFor();

        // after a change nothing of it is left until it is found anew
        await canvas.drag(
          { x: 60, y: -100 },
          {
            to: [{ x: 60, y: -120 }],
            before: () => until(async () => expect(await mark(page).count()).toBe(0)),
          },
        );
        await until(() => expect(file('01').asteroids?.[0].y).toBe(-120));
        await mark(page).waitFor();

        await page.getByRole('application', { name: 'Level canvas' }).focus();
        await page.keyboard.press('l');
        await legend(page).waitFor({ state: 'hidden' });
        expect(await mark(page).count()).toBe(0);
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );

  it(
    'buttons do the same; an attempt that fails says since when it was lost; places lead there',
    on(
      { '01': past({ runs: [{ name: 'drift', holds: [] }] }) },
      async ({ page, saved }) => {
        await saved();
        await page.getByRole('tab', { name: 'Attempts' }).click();
        await drop(page, { 'ann.gqr': recordedPlay(past(), ATTEMPT) });
        const row = page.getByRole('treeitem').filter({ hasText: 'ann.gqr' });
        await row.click();
        await page.getByRole('tab', { name: 'Solver' }).click();
        const part = page.getByRole('region', { name: 'Lost states' });
        await part.getByRole('button', { name: 'Show' }).click();
        const said = row.getByText(/^lost from [\d.]+ s$/);
        await said.waitFor();
        const from = Number(/[\d.]+/.exec((await said.textContent()) ?? '')?.[0]);
        expect(from).toBeGreaterThan(ATTEMPT[0][0] * TICK);
        expect(from).toBeLessThan(endOf(past(), ATTEMPT));

        const place = part.getByRole('list', { name: 'Places where it is lost' }).getByRole('button', { name: /^proved at/ });
        await place.first().waitFor();
        await part.getByRole('button', { name: 'Stop' }).click();
        await part.getByText(/^Stopped\. Of \d+ states \d+ can still reach the black hole/).waitFor();
        await place.first().focus();
        await page.keyboard.press('Enter');
        const box = await page.getByRole('application', { name: 'Level canvas' }).boundingBox();
        const centre = { x: (box?.x ?? 0) + (box?.width ?? 0) / 2, y: (box?.y ?? 0) + (box?.height ?? 0) / 2 };
        await until(async () => expect(await countColour(page, centre, 16, COLOURS.dark.lost)).toBeGreaterThan(10));
        await part.getByRole('button', { name: 'Go on' }).click();
        await part.getByRole('button', { name: 'Stop' }).waitFor();
        await legend(page).getByRole('button', { name: 'Hide the lost states' }).click();
        await part.getByRole('button', { name: 'Show' }).waitFor();
        await said.waitFor({ state: 'hidden' });
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );

  it(
    'a level that no run completes says so, on a phone as well',
    on(
      { '01': past({ runs: [{ name: 'hold', holds: [[0, 600]] }] }) },
      async ({ page }) => {
        await command(page, 'Show or hide the states that are already lost');
        await legend(page).getByText('No run completes the level yet').waitFor();
        const [box, size] = [await legend(page).boundingBox(), page.viewportSize()];
        expect((box?.x ?? -1) >= 0 && (box?.x ?? 0) + (box?.width ?? 999) <= (size?.width ?? 0)).toBe(true);
        expect(await complaintsAbout(page, 'lost states on a phone')).toEqual([]);
        await legend(page).getByRole('button', { name: 'Hide the lost states' }).tap();
        await legend(page).waitFor({ state: 'hidden' });
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );
});

/** Where she is on the run `hold`, px. */
function stateAt(seconds: number): { x: number; y: number } {
  const state = new Float64Array(STATE_SIZE);
  simulate(compile(resolveLevel(past())), HELD).trajectory.at(seconds, state);
  return { x: state[0], y: state[1] };
}
