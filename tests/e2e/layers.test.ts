import { expect, it } from 'vitest';
import { COLOURS } from '../../editor/canvas/colours.ts';
import { DEFAULT_BOX } from '../../engine/index.ts';
import { command } from './commands.ts';
import { straight } from './levels.ts';
import { countColour } from './screen-colours.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('layers over the level in Chromium', ({ on }) => {
  it(
    'can be hidden and shown one by one by name, without a change of the file',
    on(
      { '01': straight() },
      async ({ page, canvas, file, text, saved }) => {
        await saved();
        const before = text('01');
        await canvas.fit(file('01'));
        // the first frame is drawn
        const way = () => countColour(page, canvas.at({ x: 490, y: 304 }), 12, COLOURS.dark.way);
        await until(async () => expect(await way()).toBeGreaterThan(10));
        const look = (place: { x: number; y: number }) => {
          const { x, y } = canvas.at(place);
          return page.screenshot({ clip: { x: x - 6, y: y - 6, width: 12, height: 12 } });
        };
        /** Within range, and away from everything else. */
        const inRange = { x: 448, y: 430 };
        /** The smallest distance of her centre from the nova. */
        const onMargin = { x: 448 + 32 + DEFAULT_BOX.halfWidth, y: 520 };
        for (const [layer, place, other] of [
          ['range of the gun', inRange, null],
          ['hazard margins', onMargin, inRange],
        ] as const) {
          const shown = await look(place);
          const rest = other === null ? null : await look(other);
          await command(page, `Show or hide the ${layer}`);
          await until(async () => expect(shown.equals(await look(place))).toBe(false));
          if (other !== null) expect(rest?.equals(await look(other))).toBe(true);
          await command(page, `Show or hide the ${layer}`);
          await until(async () => expect(shown.equals(await look(place))).toBe(true));
        }
        expect(text('01')).toBe(before);
      },
      { context: { reducedMotion: 'reduce', colorScheme: 'dark' } },
    ),
  );
});
