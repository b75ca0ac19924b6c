import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { LOOKS } from '../../editor/features/compare/racers.ts';
import { compile, createSimulation, playScript, STATE_SIZE, simulate } from '../../engine/index.ts';
import { type Hold, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { complaintsAbout } from './axe.ts';
import { command, verdict } from './commands.ts';
import { straight } from './levels.ts';
import { countColour } from './screen-colours.ts';
import { inChromium, type Stage } from './stage.ts';
import { until } from './until.ts';

const LATE: Hold[] = [[40, 600]];

/** Two runs that complete the level and one that drifts; she falls along one line, so the later run is behind. */
const level = (changes = {}) =>
  straight({
    runs: [
      { name: 'solution', holds: [[0, 600]] },
      { name: 'late', holds: LATE },
      { name: 'never', holds: [] },
    ],
    ...changes,
  });

const lanes = (page: Page) => page.getByRole('list', { name: 'Compared runs' });
const lane = (page: Page, name: RegExp) => lanes(page).getByRole('button', { name });
const shownIs = (page: Page, name: string) =>
  until(async () => expect(await page.getByRole('combobox', { name: 'Run' }).inputValue()).toBe(name));
const difference = (page: Page) => page.getByRole('region', { name: 'Difference of two runs' });
const tickIs = (page: Page, tick: number) =>
  until(async () => expect(await page.getByRole('slider', { name: 'Time' }).getAttribute('aria-valuenow')).toBe(String(tick)));

/** Where she is at a tick of a run, px. */
function placeAt(file: LevelFile, holds: readonly Hold[], tick: number): { x: number; y: number } {
  const simulation = createSimulation(compile(resolveLevel(file), 'precise'));
  const state = new Float64Array(STATE_SIZE);
  playScript(simulation, holds, tick);
  simulation.readState(state);
  return { x: state[0], y: state[1] };
}

const endOf = (file: LevelFile, holds: readonly Hold[]) => simulate(compile(resolveLevel(file), 'precise'), holds).time;

/** Pixels of the look of a slot at a place of the level, at a tick. */
const racing = async ({ page, canvas }: Stage, slot: number, at: { x: number; y: number }) =>
  countColour(page, canvas.at(at), 22, LOOKS[slot].dark);

/** The bottom of the ring around a ghost, where neither its path nor its label is. */
const ring = async ({ page, canvas }: Stage, slot: number, at: { x: number; y: number }) => {
  const { x, y } = canvas.at(at);
  return countColour(page, { x, y: y + 21 }, 5, LOOKS[slot].dark);
};

inChromium('runs side by side, in Chromium', ({ on }) => {
  it(
    'by keys: a run gets a lane and a ghost that races; their difference is said; they change places and part',
    on(
      { '01': level() },
      async (stage) => {
        const { page, canvas, file } = stage;
        await verdict(page, 'completable');
        await canvas.fit(file('01'));
        await page.getByRole('application', { name: 'Level canvas' }).focus();
        await page.keyboard.press('c');
        const time = endOf(file('01'), LATE).toFixed(2);
        await lane(page, new RegExp(`^1 late: reaches the black hole at ${time} s, 1 hold`)).waitFor();

        // the ghost is where the engine says, and moves along with the time
        await page.getByRole('slider', { name: 'Time' }).focus();
        for (let second = 0; second < 10; second++) await page.keyboard.press('PageUp');
        await tickIs(page, 600);
        const [start, there] = [placeAt(file('01'), LATE, 0), placeAt(file('01'), LATE, 600)];
        await until(async () => expect(await ring(stage, 0, there)).toBeGreaterThan(3));
        expect(await ring(stage, 0, start)).toBe(0);
        await page.keyboard.press('Home');
        await until(async () => expect(await ring(stage, 0, start)).toBeGreaterThan(3));
        expect(await ring(stage, 0, there)).toBe(0);

        await page.getByRole('tab', { name: 'Runs' }).focus();
        await page.keyboard.press('Enter');
        await difference(page).getByRole('status').getByText('Their holds differ from tick 0 (0.00 s) on.').waitFor();
        const row = (name: string) => difference(page).getByRole('row', { name: new RegExp(`^${name}`) });
        await row('time').getByText('better').waitFor();
        await row('0-600').getByText('+40').waitFor();
        await row('slack').getByText(/tick/).first().waitFor();

        await page.getByRole('application', { name: 'Level canvas' }).focus();
        await page.keyboard.press('p');
        await until(async () => {
          const now = Number(await page.getByRole('slider', { name: 'Time' }).getAttribute('aria-valuenow'));
          const apart = (tick: number) => {
            const [a, b] = [placeAt(file('01'), [[0, 600]], tick), placeAt(file('01'), LATE, tick)];
            return Math.hypot(a.x - b.x, a.y - b.y);
          };
          expect(apart(now)).toBeGreaterThan(1);
          expect(apart(now - 1)).toBeLessThanOrEqual(1);
        });

        await page.keyboard.press('x');
        await shownIs(page, 'late');
        await lane(page, /^1 solution: /).waitFor();
        await page.keyboard.press('Shift+c');
        await lanes(page).waitFor({ state: 'hidden' });
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );

  it(
    'by pointer: from the list, with a click on the lane, and away again; live while the level changes',
    on({ '01': level() }, async (stage) => {
      const { page, canvas, file } = stage;
      await canvas.fit(file('01'));
      await page.getByRole('tab', { name: 'Runs' }).click();
      await page.getByRole('button', { name: 'Compare late with the shown run' }).click();
      await page.getByRole('button', { name: 'Compare never with the shown run' }).click();
      await lane(page, /^1 late: reaches the black hole/).waitFor();
      await lane(page, /^2 never: /).waitFor();
      await shownIs(page, 'solution');
      await page.getByRole('button', { name: 'Show the difference to never' }).click();
      await difference(page).getByRole('heading', { name: 'solution and never' }).waitFor();
      const outcome = difference(page).getByRole('row', { name: /^outcome/ });
      expect(await outcome.textContent()).toMatch(/completes ▲better.* ▼worse/);

      // she falls past the rock once it is moved aside
      await canvas.drag({ x: 448, y: 304 }, { to: [{ x: 448, y: 360 }] });
      await until(() => expect(file('01').asteroids?.[0].y).toBe(360));
      const time = endOf(file('01'), LATE).toFixed(2);
      await lane(page, new RegExp(`^1 late: .* at ${time} s`)).waitFor();
      await page.keyboard.press('Control+z');

      await lane(page, /^2 never: /).click();
      await shownIs(page, 'never');
      await lane(page, /^2 solution: /).waitFor();
      await lanes(page).getByRole('button', { name: 'Stop comparing solution' }).click();
      await lanes(page).getByRole('button', { name: 'Stop comparing late' }).click();
      await lanes(page).waitFor({ state: 'hidden' });
      await until(async () => expect(await difference(page).count()).toBe(0));
    }),
  );

  it(
    'from the palette and from a row of the list; the shown run and a fifth one are refused in words',
    on(
      { '01': level({ runs: ['a', 'b', 'c', 'd', 'e', 'f'].map((name, i) => ({ name, holds: [[10 * i, 600]] })) }) },
      async ({ page }) => {
        await command(page, 'Compare with b');
        await lane(page, /^1 b: /).waitFor();
        await page.getByRole('tab', { name: 'Runs' }).click();
        const tree = page.getByRole('tree', { name: 'Runs of the level' });
        for (let i = 0; i < 3; i++) await command(page, 'Compare with the next run');
        await until(async () => expect(await lanes(page).getByRole('listitem').count()).toBe(4));
        await command(page, 'Compare with f');
        await page.getByText('4 runs are compared already. Stop comparing one of them, then add f.').waitFor();
        await tree.focus();
        await page.keyboard.press('Home');
        await page.keyboard.press('c');
        await page.getByText('a is the shown run: compare it with another one.').waitFor();
        await page.keyboard.press('ArrowDown');
        await shownIs(page, 'b');
        await lane(page, /^1 a: /).waitFor();
      },
    ),
  );

  it(
    'in a playtest: attempts race the player, runs only where the shown run may be seen',
    on(
      { '01': level({ minerals: [] }) },
      async (stage) => {
        const { page, canvas, file } = stage;
        await verdict(page, 'completable');
        await canvas.fit(file('01'));
        await page.getByRole('application', { name: 'Level canvas' }).focus();
        await page.keyboard.press('c');
        await lane(page, /^1 late: reaches/).waitFor();
        // the path ends there, whatever the moment
        const end = { x: 690, y: 304 };
        const seen = () => racing(stage, 0, end);
        await until(async () => expect(await seen()).toBeGreaterThan(5));
        await page.keyboard.press('Space');
        await page.getByRole('application', { name: /^Playtest/ }).waitFor();
        await until(async () => expect(await seen()).toBe(0));
        await page.keyboard.press('w');
        await until(async () => expect(await seen()).toBeGreaterThan(5));
        await page.keyboard.press('w');
        await until(async () => expect(await seen()).toBe(0));
        await page.keyboard.press('Escape');
        await until(async () => expect(await seen()).toBeGreaterThan(5));
        // the attempt that was left is compared in its own look
        await command(page, 'Compare with the last attempt');
        await lane(page, /^2 attempt 1: /).waitFor();
        await lane(page, /^2 attempt 1: /).click();
        await page.getByText('attempt 1 is not a run of the level. Keep it as one to show and edit it.').waitFor();
        await page.getByRole('button', { name: 'Keep as a run' }).click();
        await until(() => expect(file('01').runs?.length).toBe(4));
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );

  for (const colorScheme of ['dark', 'light'] as const) {
    it(
      `has no barrier that axe knows, in ${colorScheme} colours`,
      on(
        { '01': level() },
        async ({ page }) => {
          await page.getByRole('tab', { name: 'Runs' }).click();
          await page.getByRole('application', { name: 'Level canvas' }).focus();
          await page.keyboard.press('c');
          await page.keyboard.press('c');
          await lane(page, /^2 never: is not over after 60 s/).waitFor();
          await difference(page)
            .getByRole('row', { name: /^slack/ })
            .waitFor();
          expect(await complaintsAbout(page, colorScheme)).toEqual([]);
        },
        { context: { colorScheme } },
      ),
    );
  }

  it(
    'by touch on a phone: lanes and buttons are large enough',
    on(
      { '01': level() },
      async ({ page }) => {
        const panel = (name: string) => page.getByRole('navigation', { name: 'Panels' }).getByRole('button', { name }).tap();
        await panel('Runs');
        await page.getByRole('button', { name: 'Compare late with the shown run' }).tap();
        await page.getByRole('button', { name: 'Compare never with the shown run' }).tap();
        await panel('Timeline');
        await lane(page, /^1 late: reaches/).waitFor();
        for (const name of [/^1 late/, /^Stop comparing late/, /^Show the difference to never/]) {
          const box = await lane(page, name).first().boundingBox();
          expect([String(name), (box?.height ?? 0) >= 43.5, (box?.width ?? 0) >= 44]).toEqual([String(name), true, true]);
        }
        expect(await complaintsAbout(page, 'a phone')).toEqual([]);
        await lane(page, /^1 late/).tap({ position: { x: 150, y: 20 } });
        await shownIs(page, 'late');
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );
});
