import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { compile, simulate } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import { SWING } from '../editor/swing-level.ts';
import { complaintsAbout } from './axe.ts';
import { command } from './commands.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

const NOVA = { id: 'nova', x: 400, y: 700, radius: 16 };
const LEVEL: LevelFile = {
  ...SWING,
  novae: [NOVA],
  wormholes: [{ id: 'hole', x: 300, y: 500, toX: 380, toY: 500, radius: 16 }],
};

const at = (x: number, y: number, file = LEVEL): LevelFile => ({ ...file, asteroids: [{ id: 'bjzg', x, y, radius: 32 }] });
const completes = (file: LevelFile): boolean =>
  simulate(compile(resolveLevel(file)), file.runs?.[0].holds ?? []).outcome === 'completed';

const legend = (page: Page) => page.getByRole('figure', { name: 'Where the selection may stand' });
const olive = COLOURS.dark.leeway;

/** What the engine says of how far the asteroid may go: px until the first that ends otherwise. */
function reachOf(file: LevelFile, x: number, y: number): number {
  const { x: fromX, y: fromY } = file.asteroids?.[0] ?? { x: 0, y: 0 };
  const now = completes(file);
  for (let by = 1; by <= 400; by++) if (completes(at(fromX + x * by, fromY + y * by, file)) !== now) return by - 1;
  return 400;
}

const inWords = (file: LevelFile): string =>
  (
    [
      ['left', -1, 0],
      ['right', 1, 0],
      ['up', 0, -1],
      ['down', 0, 1],
    ] as const
  )
    .map(([way, x, y]) => [way, reachOf(file, x, y)] as const)
    .map(([way, px]) => (px === 0 ? `${way} not at all` : px === 400 ? `${way} 400 px or more` : `${way} ${px} px`))
    .join(', ');

inChromium('where the selection may stand in Chromium', ({ on }) => {
  it(
    'a key shades it and says how far it may go; it stays while the object is dragged, and follows the selection',
    on(
      { '01': LEVEL },
      async ({ page, canvas, file, saved, text }) => {
        await saved();
        const before = text('01');
        await canvas.fit(file('01'));
        await page.keyboard.press('Shift+L');
        await legend(page).getByText('Select an object').waitFor();
        await canvas.click({ x: 600, y: 620 });
        await legend(page)
          .getByText(`May go ${inWords(LEVEL)}.`)
          .waitFor();
        await legend(page)
          .getByText(/^Sampled at every grid place \(8 px\), at edges every 1 px\.$/)
          .waitFor();
        // a place above where the engine says that it may stand is hatched, one on which it says no is not
        const up = reachOf(LEVEL, 0, -1);
        const edge = canvas.at({ x: 600, y: 620 - up });
        await until(async () => expect(await countColour(page, edge, 5, olive)).toBeGreaterThan(3));
        const far = [1, 2, 3, 4, 5, 6].map((n) => 700 + 8 * n).find((y) => !completes(at(480, y))) ?? 0;
        expect(far).toBeGreaterThan(0);
        expect(await countColour(page, canvas.at({ x: 480, y: far }), 4, olive)).toBe(0);
        expect(await complaintsAbout(page, 'where it may stand', 'main')).toEqual([]);
        expect(text('01')).toBe(before);

        await canvas.drag(
          { x: 600, y: 620 },
          {
            to: [{ x: 600, y: 612 }],
            before: async () => {
              await page.getByRole('note', { name: 'Before and after the change' }).waitFor();
              // the shade of the beginning is still true
              expect(await countColour(page, edge, 5, olive)).toBeGreaterThan(3);
            },
          },
        );
        await until(() => expect(file('01').asteroids?.[0].y).not.toBe(620));
        const moved = file('01');
        await legend(page)
          .getByText(`May go ${inWords(moved)}.`)
          .waitFor();

        await canvas.click({ x: 400, y: 700 });
        await legend(page).getByText('Nova 1 may stand').waitFor();
        await legend(page).getByRole('button', { name: 'Hide where the selection may stand' }).click();
        await legend(page).waitFor({ state: 'hidden' });
        await until(async () => expect(await countColour(page, edge, 5, olive)).toBe(0));
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );

  it(
    'by keys alone: of a run that fails it says where it would complete; one mouth of a wormhole moves alone',
    on({ '01': { ...LEVEL, asteroids: [{ id: 'bjzg', x: 608, y: 620, radius: 32 }] } }, async ({ page, file }) => {
      expect(completes(at(608, 620))).toBe(false);
      await page.getByRole('tree', { name: 'Objects of the level' }).getByText('Asteroid 1').click();
      await command(page, 'Show or hide the places where the selection may stand');
      await legend(page).getByText('It fails as it is: there is no place to keep.').waitFor();
      const left = reachOf(file('01'), -1, 0);
      expect(completes(at(608 - left - 1, 620))).toBe(true);
      await legend(page)
        .getByRole('status')
        .filter({ hasText: `Would complete left by ${left + 1} px` })
        .waitFor();
      await page.getByRole('tree', { name: 'Objects of the level' }).getByText('Wormhole 1').click();
      await legend(page).getByText('Wormhole 1 may stand').waitFor();
      await legend(page).getByRole('radio', { name: 'both' }).focus();
      await page.keyboard.press('ArrowRight');
      await legend(page).getByText('First mouth of wormhole 1 may stand').waitFor();
      expect(await complaintsAbout(page, 'where a mouth may stand', 'main')).toEqual([]);
    }),
  );

  it(
    'fits on a phone',
    on(
      { '01': LEVEL },
      async ({ page, canvas, file }) => {
        await canvas.fit(file('01'));
        const place = canvas.at({ x: 600, y: 620 });
        await page.touchscreen.tap(place.x, place.y);
        await command(page, 'Show or hide the places where the selection may stand');
        await legend(page)
          .getByText(`May go ${inWords(LEVEL)}.`)
          .waitFor();
        const [box, size] = [await legend(page).boundingBox(), page.viewportSize()];
        expect((box?.x ?? -1) >= 0 && (box?.x ?? 0) + (box?.width ?? 999) <= (size?.width ?? 0)).toBe(true);
        expect(await complaintsAbout(page, 'where it may stand, on a phone', 'main')).toEqual([]);
        await legend(page).getByRole('button', { name: 'Hide where the selection may stand' }).tap();
        await legend(page).waitFor({ state: 'hidden' });
      },
      { context: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } },
    ),
  );
});
