import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { complaintsAbout } from './axe.ts';
import { command } from './commands.ts';
import { straight } from './levels.ts';
import { inChromium, type Stage } from './stage.ts';
import { until } from './until.ts';

const drifting = () =>
  straight({
    runs: [
      {
        name: 'first',
        holds: [
          [60, 120],
          [180, 240],
        ],
        notes: [{ tick: 60, text: 'first swing' }],
      },
      { name: 'second', holds: [[10, 20]] },
    ],
  });

/** She completes the level, with holds that are wide on the screen. */
const swinging = () =>
  straight({
    runs: [
      {
        name: 'first',
        holds: [
          [0, 500],
          [700, 1200],
        ],
        notes: [
          { tick: 0, text: 'first swing' },
          { tick: 900, text: 'again' },
        ],
      },
    ],
  });

const field = (page: Page) => page.getByRole('textbox', { name: /^Holds of .* as text$/ });
const fieldSays = (page: Page, text: string) => until(async () => expect(await field(page).inputValue()).toBe(text));
const runOf = ({ file }: Stage, name = 'first') => file('01').runs?.find((run) => run.name === name);
const runIs = (stage: Stage, holds: number[][], notes?: [number, string][]) =>
  until(() => {
    const run = runOf(stage);
    expect(run?.holds).toEqual(holds);
    expect(run?.notes).toEqual(notes?.map(([tick, text]) => ({ tick, text })));
  });
const flag = (page: Page, name: RegExp) =>
  page.getByRole('list', { name: 'Notes of the run first' }).getByRole('button', { name });

inChromium('a run as text, in Chromium', ({ on }) => {
  it(
    'is edited by keys: each letter that can be read changes the run, and all of it is one step of undo',
    on({ '01': drifting() }, async (stage) => {
      const { page } = stage;
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('t');
      await until(() => expect(field(page)).toBeDefined());
      await fieldSays(page, '60-120 # first swing\n180-240');
      await page.keyboard.press('Control+End');
      await page.keyboard.type(', 300 .. 5s');
      const mistake = page.getByText(/expected both in ticks or both in seconds, found 300 and 5s/);
      await mistake.waitFor();
      expect(await field(page).getAttribute('aria-invalid')).toBe('true');
      await page.keyboard.press('Backspace');
      await page.keyboard.press('Backspace');
      await page.keyboard.type('330 # again');
      await runIs(
        stage,
        [
          [60, 120],
          [180, 240],
          [300, 330],
        ],
        [
          [60, 'first swing'],
          [300, 'again'],
        ],
      );
      await fieldSays(page, '60-120 # first swing\n180-240, 300 .. 330 # again');
      // leaving the field lays the text out
      await page.keyboard.press('Tab');
      await fieldSays(page, '60-120 # first swing\n180-240, 300-330 # again');
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('Control+z');
      await runIs(
        stage,
        [
          [60, 120],
          [180, 240],
        ],
        [[60, 'first swing']],
      );
      await fieldSays(page, '60-120 # first swing\n180-240');
    }),
  );

  it(
    'follows the lane, and the lane follows it; a text with a mistake waits for whoever wrote it',
    on({ '01': drifting() }, async (stage) => {
      const { page } = stage;
      await command(page, 'Edit the run as text');
      await field(page).fill('60-120 # first swing\n180-');
      const mistake = page.getByText(/expected the tick of a release here/);
      await mistake.waitFor();
      await field(page).blur();
      await page.getByRole('alert').getByText(/2:5/).waitFor();
      // the lane still edits the run
      await page.getByRole('button', { name: /^Hold 2:/ }).focus();
      await page.keyboard.press('ArrowRight');
      await runIs(
        stage,
        [
          [60, 120],
          [181, 241],
        ],
        [[60, 'first swing']],
      );
      await fieldSays(page, '60-120 # first swing\n180-');
      // another panel, and back
      await page.getByRole('tab', { name: 'Outline' }).click();
      await page.getByRole('tab', { name: 'Runs' }).click();
      await fieldSays(page, '60-120 # first swing\n180-');
      // the place leads to the mistake
      await page.getByRole('button', { name: '2:5' }).click();
      expect(await field(page).evaluate((area: HTMLTextAreaElement) => area.selectionStart)).toBe(25);
      await page.keyboard.press('Escape');
      await fieldSays(page, '60-120 # first swing\n181-241');
      await page.getByRole('button', { name: /^Hold 1:/ }).focus();
      await page.keyboard.press('Shift+ArrowRight');
      await fieldSays(page, '70-130 # first swing\n181-241');
      await runIs(
        stage,
        [
          [70, 130],
          [181, 241],
        ],
        [[70, 'first swing']],
      );
      // holds that overlap are joined, and it is said
      await field(page).fill('10-50, 40-90');
      await page
        .getByRole('status', { name: 'What was done with the text' })
        .getByText('10-50 and 40-90 overlap or touch, and become 10-90')
        .waitFor();
      await field(page).blur();
      await fieldSays(page, '10-90');
      await runIs(stage, [[10, 90]]);
    }),
  );

  it(
    'has notes as flags on the timeline, by keys and by pointer',
    on({ '01': drifting() }, async (stage) => {
      const { page } = stage;
      const holds = [
        [60, 120],
        [180, 240],
      ];
      await page.getByRole('slider', { name: 'Time' }).focus();
      await page.keyboard.press('PageDown');
      for (let i = 0; i < 2; i++) await page.keyboard.press('PageUp');
      await page.keyboard.press('Shift+n');
      const text = page.getByRole('textbox', { name: /^Note at tick 120/ });
      await text.waitFor();
      await page.keyboard.type('lets go');
      await page.keyboard.press('Enter');
      await runIs(stage, holds, [
        [60, 'first swing'],
        [120, 'lets go'],
      ]);
      // by keys: a flag is moved and deleted
      await flag(page, /first swing/).focus();
      await page.keyboard.press('ArrowRight');
      await page.keyboard.press('ArrowRight');
      await runIs(stage, holds, [
        [62, 'first swing'],
        [120, 'lets go'],
      ]);
      await page.keyboard.press('Control+z');
      await runIs(stage, holds, [
        [60, 'first swing'],
        [120, 'lets go'],
      ]);
      await flag(page, /lets go/).focus();
      await page.keyboard.press('Delete');
      await runIs(stage, holds, [[60, 'first swing']]);
      // by pointer: a flag goes to its tick and opens the note
      await flag(page, /first swing/).click();
      await page.getByRole('textbox', { name: /^Note at tick 60/ }).fill('the swing');
      expect(await page.getByRole('slider', { name: 'Time' }).getAttribute('aria-valuenow')).toBe('60');
      await page.keyboard.press('Enter');
      await runIs(stage, holds, [[60, 'the swing']]);
      await flag(page, /the swing/).click();
      await page.keyboard.type('no');
      await page.keyboard.press('Escape');
      await page.getByRole('textbox', { name: /^Note at/ }).waitFor({ state: 'hidden' });
      await runIs(stage, holds, [[60, 'the swing']]);
      await flag(page, /the swing/).click();
      await page.getByRole('button', { name: 'Delete the note' }).click();
      await runIs(stage, holds);
      expect(stage.text('01')).not.toContain('notes');
    }),
  );

  for (const colorScheme of ['dark', 'light'] as const) {
    it(
      `has no barrier that axe knows, in ${colorScheme} colours`,
      on(
        { '01': swinging() },
        async ({ page }) => {
          await page.getByRole('tab', { name: 'Runs' }).click();
          await field(page).fill('0-500 # first swing\n700-1200\n@900 # again\n1300-x');
          await page.getByText(/found "x"/).waitFor();
          expect(await complaintsAbout(page, colorScheme)).toEqual([]);
          await flag(page, /again/).click();
          await page.getByRole('textbox', { name: /^Note at tick 900/ }).waitFor();
          expect(await complaintsAbout(page, `a note, ${colorScheme}`)).toEqual([]);
        },
        { context: { colorScheme } },
      ),
    );
  }

  it(
    'works by touch on a phone',
    on(
      { '01': swinging() },
      async (stage) => {
        const { page } = stage;
        await page.getByRole('navigation', { name: 'Panels' }).getByRole('button', { name: 'Runs' }).tap();
        await field(page).fill('0-500 # first swing, 180-');
        await field(page).blur();
        await runIs(stage, [[0, 500]], [[0, 'first swing, 180-']]);
        await page.getByRole('navigation', { name: 'Panels' }).getByRole('button', { name: 'Timeline' }).tap();
        const one = flag(page, /first swing/);
        const box = await one.boundingBox();
        expect([(box?.width ?? 0) >= 44, (box?.height ?? 0) >= 44]).toEqual([true, true]);
        await one.tap();
        await page.getByRole('textbox', { name: /^Note at tick 0/ }).waitFor();
        expect(await complaintsAbout(page, 'a phone')).toEqual([]);
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );
});
