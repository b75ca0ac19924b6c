import { expect, it } from 'vitest';
import { command, verdict } from './commands.ts';
import { garden, straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { PATIENCE, until } from './until.ts';

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

inChromium('the first sight in Chromium', ({ on }) => {
  it(
    'the tour mentions fingers on touch screens, and its card is completely visible',
    on(
      { '01': straight() },
      async ({ page }) => {
        await verdict(page, 'completable');
        for (const [width, height] of [
          [390, 844],
          [640, 360],
        ]) {
          await page.setViewportSize({ width, height });
          await command(page, 'Take the tour');
          const tour = page.getByRole('dialog', { name: /^Tour/ });
          await tour.waitFor();
          const steps = Number(/of (\d+)/.exec((await tour.getAttribute('aria-label')) ?? '')?.[1]);
          for (let i = 1; i <= steps; i++) {
            expect(await tour.textContent()).not.toMatch(
              /wheel|button moves|mouse|click|letter|\bSpace\b|\bEsc\b|\bCtrl\b|\bAlt\b|[Kk]eys/,
            );
            await until(async () => {
              const box = await tour.boundingBox();
              if (box === null) throw new Error('the tour is not seen');
              expect([box.x >= 0, box.y >= 0, box.x + box.width <= width, box.y + box.height <= height]).toEqual(
                Array(4).fill(true),
              );
            });
            await tour.getByRole('button').last().tap();
          }
          await tour.waitFor({ state: 'hidden' });
        }
      },
      { context: PHONE },
    ),
  );

  it(
    'a page without its token says once what is missing, and does not search for levels',
    on({ '01': straight() }, async ({ context, server }) => {
      const page = await context.newPage();
      page.setDefaultTimeout(PATIENCE);
      await page.goto(new URL(server().address).origin);
      const said = page.getByRole('alert');
      await said.waitFor();
      expect(await said.count()).toBe(1);
      expect(await said.textContent()).toMatch(/^[A-Z].*\.$/);
      expect(await page.getByText('Loading levels').count()).toBe(0);
      // nothing is offered that does not work
      expect(await page.getByRole('button').allTextContents()).toEqual(['Unsaved changes']);
    }),
  );

  it(
    'the outline of the next level is scrolled to the top',
    on(
      {
        '01': garden({ minerals: Array.from({ length: 60 }, (_, i) => ({ id: `m${i}`, x: 400 + 8 * i, y: 600 })) }),
        '02': garden({ minerals: Array.from({ length: 60 }, (_, i) => ({ id: `q${i}`, x: 400 + 8 * i, y: 600 })) }),
      },
      async ({ page }) => {
        const outline = page.getByRole('tree', { name: 'Objects of the level' });
        await outline.focus();
        await page.keyboard.press('End');
        await until(async () => expect(await outline.evaluate(({ scrollTop }) => scrollTop)).toBeGreaterThan(500));
        await page.keyboard.press('Alt+PageDown');
        await page
          .getByRole('treeitem', { name: /q59/ })
          .or(page.getByRole('treeitem', { name: /^Astronaut/ }))
          .first()
          .waitFor();
        await until(async () => expect(await outline.evaluate(({ scrollTop }) => scrollTop)).toBe(0));
      },
    ),
  );

  it(
    'an empty panel takes one line, runs are described in full, and a requested diagram is in view',
    on(
      {
        '01': straight({
          minerals: Array.from({ length: 12 }, (_, i) => ({ id: `m${i}`, x: 216 + 16 * i, y: 304 })),
          runs: [
            { name: 'solution', holds: [[0, 600]] },
            { name: 'many', holds: Array.from({ length: 12 }, (_, i) => [60 * i, 60 * i + 58]) },
          ],
        }),
        '02': straight({ runs: [] }),
      },
      async ({ page }) => {
        await verdict(page, 'completable');
        const problems = page.locator('#right-side-second');
        const height = async () => (await problems.boundingBox())?.height ?? 0;
        await page.getByText('No errors and no warnings.').waitFor();
        await until(async () => expect(await height()).toBeLessThan(48));
        await page.getByRole('tab', { name: 'Runs' }).click();
        const facts = page.locator('.runs__facts');
        await until(async () => expect(await facts.last().textContent()).toContain('12 holds'));
        await until(async () => {
          const cut = await facts.evaluateAll((all) => all.map(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth));
          expect(cut).toEqual([false, false]);
        });
        for (const [width, height] of [
          [1280, 600],
          [720, 450],
        ]) {
          await page.setViewportSize({ width, height });
          await command(page, 'Show accuracy');
          await page.getByRole('button', { name: /^(Measure|Measure again)$/ }).click();
          const diagram = page.getByRole('img', { name: /^Work-precision/ });
          await diagram.waitFor();
          await until(async () => {
            const box = await diagram.boundingBox();
            expect((box?.y ?? height) + (box?.height ?? 0)).toBeLessThanOrEqual(height);
          });
        }
        await page.setViewportSize({ width: 1280, height: 800 });
        await page.keyboard.press('Alt+PageDown');
        await page.getByRole('list', { name: 'Problems' }).getByRole('listitem').first().waitFor();
        await until(async () => expect(await height()).toBeGreaterThan(100));
      },
    ),
  );

  it(
    'a dragged row shows its target, at either end of its list, and nowhere else',
    on(
      { '01': straight({ runs: ['one', 'two', 'three'].map((name) => ({ name, holds: [[0, 600]] })) }) },
      async ({ page, file }) => {
        await page.getByRole('tab', { name: 'Runs' }).click();
        const runs = page.getByRole('tree', { name: 'Runs of the level' });
        const line = runs.locator('.tree__drop');
        const row = async (name: string) => {
          const box = await runs.getByRole('treeitem', { name: new RegExp(`^${name} `) }).boundingBox();
          if (box === null) throw new Error(`${name} is not seen`);
          return { x: box.x + 60, top: box.y, bottom: box.y + box.height };
        };
        const order = (names: string[]) => until(() => expect(file('01').runs?.map(({ name }) => name)).toEqual(names));
        const take = async (name: string) => {
          const { x, top } = await row(name);
          await page.mouse.move(x, top + 20);
          await page.mouse.down();
          await page.mouse.move(x, top + 34, { steps: 5 });
        };
        /** Moves the mouse to a place and slightly further, as a hand trembles. */
        const over = async (x: number, y: number) => {
          await page.mouse.move(x, y, { steps: 8 });
          await page.mouse.move(x + 2, y, { steps: 2 });
        };
        /** Checks that the line is at that height, and within the list. */
        const lineAt = (y: number) =>
          until(async () => {
            const [box, list] = [await line.boundingBox(), await runs.boundingBox()];
            if (box === null || list === null) throw new Error('no line is seen');
            expect(Math.abs(box.y + box.height / 2 - y)).toBeLessThan(4);
            expect(box.y).toBeGreaterThanOrEqual(list.y);
          });

        await take('three');
        const first = await row('one');
        await over(first.x, first.top + 6);
        await lineAt(first.top);
        // outside of the list there is no target
        await over(700, 300);
        await line.waitFor({ state: 'hidden' });
        await over(first.x, first.top + 6);
        await lineAt(first.top);
        await page.mouse.up();
        await order(['three', 'one', 'two']);

        // the space below counts as the end of the list
        await take('three');
        const last = await row('two');
        await over(last.x, last.bottom + 30);
        await lineAt(last.bottom);
        await page.mouse.up();
        await order(['one', 'two', 'three']);
        expect(await line.count()).toBe(0);
      },
    ),
  );
});
