import { expect, it } from 'vitest';
import { command, verdict } from './commands.ts';
import { straight } from './levels.ts';
import { inChromium } from './stage.ts';
import { until } from './until.ts';

inChromium('fixes of a level in Chromium', ({ on }) => {
  it(
    'are found from the palette, previewed on the page, taken in one step and undone',
    on({ '01': straight({ blackHole: { x: 704, y: 380 } }) }, async ({ page, saved, file }) => {
      await saved();
      await command(page, 'Fix this level');
      const solver = page.getByRole('tabpanel', { name: 'Solver' });
      const proposals = solver.getByRole('list', { name: 'Proposals' }).getByRole('listitem');
      await solver.getByText('Each is the smallest that was found of its kind.').waitFor();
      await until(async () => expect(await proposals.count()).toBe(3));
      await proposals.first().getByRole('button', { name: 'Preview' }).click();
      await verdict(page, 'completable');
      // a preview is not saved
      expect(file('01').blackHole).toEqual({ x: 704, y: 380 });
      await proposals.first().getByRole('button', { name: 'Back' }).click();
      await verdict(page, 'impossible');
      await proposals.first().getByRole('button', { name: 'Preview' }).click();
      await proposals.first().getByRole('button', { name: 'Take' }).click();
      await verdict(page, 'completable');
      await saved();
      await command(page, 'Undo');
      await verdict(page, 'impossible');
    }),
  );
});
