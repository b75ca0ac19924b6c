import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { holding } from './canvas.ts';
import { command, verdict } from './commands.ts';
import { hurry, nextFrames, pass } from './frames.ts';
import { straight } from './levels.ts';
import { inChromium, type Stage } from './stage.ts';
import { until } from './until.ts';

/** She drifts along the asteroids for a long time, so that holds can be moved freely. */
const drifting = () =>
  straight({
    runs: [
      {
        name: 'first',
        holds: [
          [60, 120],
          [180, 240],
          [300, 330],
        ],
      },
      { name: 'second', holds: [[10, 20]] },
    ],
  });

const holdsOf = ({ file }: Stage, run = 'first') => file('01').runs?.find(({ name }) => name === run)?.holds;
const holdsAre = (stage: Stage, holds: number[][], run?: string) => until(() => expect(holdsOf(stage, run)).toEqual(holds));

/** px per tick, computed from the first hold on the screen. */
async function scaleOf(page: Page): Promise<number> {
  const name = (await page.getByRole('button', { name: /^Hold 1:/ }).getAttribute('aria-label')) ?? '';
  const [, press, release] = /tick (\d+) to (\d+)/.exec(name) ?? [];
  const box = await page.getByRole('button', { name: /^Hold 1:/ }).boundingBox();
  // the border of the bar is outside of the button
  return ((box?.width ?? 0) + 2) / (Number(release) - Number(press));
}

/** Zooms in on the beginning, so that holds are wide enough for fingers and the scale does not follow the run any more. */
async function zoomIn(page: Page): Promise<void> {
  const before = await scaleOf(page);
  const ruler = await page.getByRole('slider', { name: 'Time' }).boundingBox();
  if (ruler === null) throw new Error('no ruler');
  await page.mouse.move(ruler.x + 2, ruler.y + ruler.height / 2);
  await page.mouse.wheel(0, -1300);
  await until(async () => expect(await scaleOf(page)).toBeGreaterThan(4 * before));
}

/** Drags an element of the timeline by some ticks. */
async function dragBy(page: Page, role: 'button' | 'slider', name: RegExp, ticks: number, keys: string[] = []): Promise<void> {
  const zoom = await scaleOf(page);
  const box = await page.getByRole(role, { name }).boundingBox();
  if (box === null) throw new Error(`${name} is not seen`);
  // a press of the mouse is at whole px
  const [x, y] = [Math.round(box.x + box.width / 2), Math.round(box.y + box.height / 2)];
  await holding(page, keys, async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + Math.round(ticks * zoom), y, { steps: 4 });
    await page.mouse.up();
  });
}

const tickShown = async (page: Page) =>
  Number((await page.getByRole('slider', { name: 'Time' }).getAttribute('aria-valuenow')) ?? -1);
const tickIs = (page: Page, tick: number) => until(async () => expect(await tickShown(page)).toBe(tick));

inChromium('the timeline in Chromium', ({ on }) => {
  it(
    'drags holds and their edges, with Alt also all later ones; each is one undo step',
    on({ '01': drifting() }, async (stage) => {
      const { page } = stage;
      await zoomIn(page);
      await dragBy(page, 'button', /^Hold 2:/, 20);
      await holdsAre(stage, [
        [60, 120],
        [200, 260],
        [300, 330],
      ]);
      await page.keyboard.press('Control+z');
      await holdsAre(stage, [
        [60, 120],
        [180, 240],
        [300, 330],
      ]);
      // the hold stops before its neighbour
      await dragBy(page, 'button', /^Hold 2:/, 200);
      await holdsAre(stage, [
        [60, 120],
        [239, 299],
        [300, 330],
      ]);
      await page.keyboard.press('Control+z');
      await dragBy(page, 'button', /^Hold 2:/, 40, ['Alt']);
      await holdsAre(stage, [
        [60, 120],
        [220, 280],
        [340, 370],
      ]);
      await page.keyboard.press('Control+z');
      await dragBy(page, 'slider', /^Press of hold 2/, -30);
      await holdsAre(stage, [
        [60, 120],
        [150, 240],
        [300, 330],
      ]);
      await dragBy(page, 'slider', /^Release of hold 2/, 15, ['Alt']);
      await holdsAre(stage, [
        [60, 120],
        [150, 255],
        [315, 345],
      ]);
      for (let i = 0; i < 2; i++) await page.keyboard.press('Control+z');
      await holdsAre(stage, [
        [60, 120],
        [180, 240],
        [300, 330],
      ]);
      await page.getByRole('button', { name: 'Nothing to undo' }).waitFor();
    }),
  );

  it(
    'splits, adds and deletes holds, by mouse and by key',
    on({ '01': drifting() }, async (stage) => {
      const { page } = stage;
      await zoomIn(page);
      await page.getByRole('button', { name: /^Hold 2:/ }).dblclick();
      const split = await until(() => {
        const holds = holdsOf(stage);
        expect(holds).toHaveLength(4);
        return holds ?? [];
      });
      expect(split[1][0]).toBe(180);
      expect(split[2]).toEqual([split[1][1] + 1, 240]);
      expect(Math.abs(split[1][1] - 210)).toBeLessThan(5);
      await page.keyboard.press('Control+z');

      await page.getByRole('button', { name: /^Hold 2:/ }).click();
      await page.keyboard.press('Delete');
      await holdsAre(stage, [
        [60, 120],
        [300, 330],
      ]);
      await page.keyboard.press('Control+z');
      await page.getByRole('button', { name: /^Hold 2:/ }).click();
      await page.keyboard.press('Shift+Delete');
      await holdsAre(stage, [
        [60, 120],
        [240, 270],
      ]);
      await page.keyboard.press('Control+z');

      // a drag on the empty lane adds a hold
      const zoom = await scaleOf(page);
      const lane = await page.getByRole('application', { name: /^Gun of the run first/ }).boundingBox();
      if (lane === null) throw new Error('no lane');
      const first = (await page.getByRole('button', { name: /^Hold 1:/ }).boundingBox())?.x ?? 0;
      await page.mouse.move(first - 40 * zoom, lane.y + lane.height / 2);
      await page.mouse.down();
      await page.mouse.move(first - 10 * zoom, lane.y + lane.height / 2, { steps: 3 });
      await page.mouse.up();
      const added = await until(() => {
        const holds = holdsOf(stage) ?? [];
        expect(holds).toHaveLength(4);
        return holds[0];
      });
      expect(Math.abs(added[0] - 20) + Math.abs(added[1] - 50)).toBeLessThan(4);
      await page.keyboard.press('Control+z');

      // keys move an edge by one and by ten ticks, together one step
      await page.getByRole('slider', { name: 'Release of hold 1' }).focus();
      await page.keyboard.press('ArrowRight');
      await page.keyboard.press('Shift+ArrowRight');
      await holdsAre(stage, [
        [60, 131],
        [180, 240],
        [300, 330],
      ]);
      await page.keyboard.press('Control+z');
      await holdsAre(stage, [
        [60, 120],
        [180, 240],
        [300, 330],
      ]);
      // a hold from the scrubbed tick on
      await page.getByRole('slider', { name: 'Time' }).focus();
      await page.keyboard.press('Home');
      await page.keyboard.press('i');
      await holdsAre(stage, [
        [0, 30],
        [60, 120],
        [180, 240],
        [300, 330],
      ]);
      for (let i = 0; i < 15; i++) await page.keyboard.press('.');
      await page.keyboard.press('s');
      await holdsAre(stage, [
        [0, 15],
        [16, 30],
        [60, 120],
        [180, 240],
        [300, 330],
      ]);
    }),
  );

  it(
    'scrubs, steps, plays in slow motion, and shows the events of the run',
    on({ '01': straight() }, async ({ page }) => {
      await verdict(page, 'completable');
      await nextFrames(page);
      const ruler = page.getByRole('slider', { name: 'Time' });
      const end = Number(await ruler.getAttribute('aria-valuemax'));
      const box = await ruler.boundingBox();
      if (box === null) throw new Error('no ruler');
      const at = async (share: number) => page.mouse.move(box.x + share * box.width, box.y + box.height / 2);
      await at(0.25);
      await page.mouse.down();
      await at(0.5);
      const scrubbed = await until(async () => {
        const tick = await tickShown(page);
        // the run fills nearly the whole ruler
        expect(Math.abs(tick - 0.53 * end)).toBeLessThan(3);
        return tick;
      });
      await page.mouse.up();
      await page.keyboard.press('.');
      await tickIs(page, scrubbed + 1);
      await page.keyboard.press(',');
      await page.keyboard.press(',');
      await tickIs(page, scrubbed - 1);
      await page.getByRole('button', { name: 'To the end' }).click();
      await tickIs(page, end);
      await page.getByText(`tick ${end} of ${end}`).waitFor();
      await page.getByRole('button', { name: 'To the start' }).click();
      await page.getByRole('button', { name: 'Next tick' }).click();
      await tickIs(page, 1);

      // at a quarter of the speed, a second is 15 ticks, not 60
      await page.getByRole('button', { name: 'To the start' }).click();
      await hurry(page, 0);
      for (const [pace, ticks] of [
        ['¼×', 15],
        ['1×', 75],
      ] as const) {
        await page.getByRole('button', { name: pace, exact: true }).click();
        await page.keyboard.press('k');
        await pass(page, 1000);
        await tickIs(page, ticks);
        await page.keyboard.press('k');
      }
      await hurry(page, 1);
      const events = page.getByRole('list', { name: 'Events of the run' });
      await events.getByText('mineral 1 is collected').waitFor({ state: 'attached' });
      await events.getByText('reaches the black hole').waitFor({ state: 'attached' });
      await page.getByRole('img', { name: /^Speed and clearance along the run/ }).waitFor();
    }),
  );

  it(
    'shows her at the tick under the pointer, and one run of several; undo goes across runs',
    on({ '01': drifting() }, async (stage) => {
      const { page, canvas, file } = stage;
      await canvas.fit(file('01'));
      const { x, y } = canvas.at({ x: 200, y: 304 });
      const clip = { x: x - 20, y: y - 30, width: 40, height: 60 };
      const before = await page.screenshot({ clip });
      const ruler = await page.getByRole('slider', { name: 'Time' }).boundingBox();
      if (ruler === null) throw new Error('no ruler');
      await page.mouse.move(ruler.x + ruler.width * 0.6, ruler.y + ruler.height + 40);
      await until(async () => expect((await page.screenshot({ clip })).equals(before)).toBe(false));
      expect(await tickShown(page)).toBe(0);
      await page.mouse.move(x, y);

      await page.getByRole('combobox', { name: 'Run' }).selectOption('second');
      await page.getByRole('application', { name: 'Gun of the run second: 1 hold' }).waitFor();
      await page.getByRole('slider', { name: 'Release of hold 1' }).focus();
      await page.keyboard.press('ArrowRight');
      await holdsAre(stage, [[10, 21]], 'second');
      await page.getByRole('combobox', { name: 'Run' }).selectOption('first');
      await page.getByRole('slider', { name: 'Release of hold 3' }).focus();
      await page.keyboard.press('ArrowRight');
      await holdsAre(stage, [
        [60, 120],
        [180, 240],
        [300, 331],
      ]);
      await page.keyboard.press('Control+z');
      await page.keyboard.press('Control+z');
      await holdsAre(stage, [[10, 20]], 'second');
      await holdsAre(stage, [
        [60, 120],
        [180, 240],
        [300, 330],
      ]);
      await command(page, 'New run');
      await holdsAre(stage, [], 'solution');
    }),
  );
});
