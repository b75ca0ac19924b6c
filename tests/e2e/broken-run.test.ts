import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { verdict } from './commands.ts';
import { straight } from './levels.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const firewalk = () => readFileSync(join(import.meta.dirname, '..', '..', 'levels', '16-firewalk.level.json'), 'utf8');

/** The left and right end of an element on the page, px. */
async function span(page: Page, role: 'button' | 'slider', name: RegExp): Promise<{ left: number; right: number }> {
  const box = await page.getByRole(role, { name }).boundingBox();
  if (box === null) throw new Error(`${name} is not seen`);
  return { left: box.x, right: box.x + box.width };
}

inChromium('a run that breaks, in Chromium', ({ on }) => {
  it(
    'keeps its length on the timeline: the part after its end can be seen and edited, and is marked as not reached',
    on({ '16': firewalk() }, async ({ page, canvas, file }) => {
      await verdict(page, 'completable');
      const transport = page.getByTitle(/^3 holds, /);
      expect(await transport.textContent()).toMatch(/^3 holds, reaches the black hole at/);
      await canvas.fit(file('16'));
      const before = await span(page, 'button', /^Hold 3:/);
      // hot asteroid 2, onto the path; nothing shrinks, not even during the drag
      await canvas.drag(
        { x: 740, y: 640 },
        {
          to: [{ x: 732, y: 600 }],
          before: async () => {
            await verdict(page, 'broken');
            expect((await span(page, 'button', /^Hold 3:/)).right).toBeCloseTo(before.right, 0);
          },
        },
      );
      await verdict(page, 'broken');
      await page.getByTitle(/^3 holds, 1 not reached, collides with hot asteroid 2 at/).waitFor();
      const lane = await page.getByRole('application', { name: 'Gun of the run solution: 3 holds, 1 not reached' }).boundingBox();
      expect(lane).not.toBeNull();
      const after = await span(page, 'button', /^Hold 3:.*not reached$/);
      expect([after.left, after.right]).toEqual([expect.closeTo(before.left, 0), expect.closeTo(before.right, 0)]);
      expect(after.right).toBeLessThan((lane?.x ?? 0) + (lane?.width ?? 0));
      await page.getByRole('button', { name: /^Hold 2:.*reached until \d\.\d\d s$/ }).waitFor();

      // its path does not have the colour of a completing run: it ends in red, with the reason beside it
      const reason = page.getByRole('note', { name: 'Where the run ends' });
      expect(await reason.textContent()).toBe('hits hot asteroid 2');
      const end = await reason.boundingBox();
      const asteroid = canvas.at(file('16').asteroids?.[1] ?? { x: 0, y: 0 });
      expect(Math.hypot((end?.x ?? 0) - asteroid.x, (end?.y ?? 0) - asteroid.y)).toBeLessThan(160);

      // the third hold can still be dragged
      await page.getByRole('button', { name: /^Hold 3:/ }).click();
      await page.keyboard.press('ArrowRight');
      await until(() => expect(file('16').runs?.[0].holds[2]).toEqual([471, 761]));
      await page.keyboard.press('Control+z');
      await page.keyboard.press('Control+z');
      await verdict(page, 'completable');
      await page.getByTitle(/^3 holds, reaches/).waitFor();
      await reason.waitFor({ state: 'hidden' });
    }),
  );

  it(
    'is not drawn in the colour of a completing run, even if the level is proved impossible',
    on(
      { '01': straight({ minerals: [] }) },
      async ({ page, canvas, file }) => {
        await verdict(page, 'completable');
        await canvas.fit(file('01'));
        const count = (x: number, colour: string) => countColour(page, canvas.at({ x, y: 304 }), 12, colour);
        const { way, danger } = COLOURS.dark;
        await until(async () => expect(await count(490, way)).toBeGreaterThan(10));
        // the nova, onto the line that she can not leave
        await canvas.drag({ x: 448, y: 520 }, { to: [{ x: 560, y: 304 }] });
        await verdict(page, 'impossible');
        await page.getByRole('note', { name: 'Where the run ends' }).getByText('hits nova 1').waitFor();
        await until(async () => expect(await count(490, way)).toBe(0));
        expect(await count(510, danger)).toBeGreaterThan(10);
        expect(await count(510, way)).toBe(0);
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );
});
