import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { atMost, define, launch, median, PROJECT, QUIET, spread } from './harness/index.ts';

/** How often the page is opened. */
const TIMES = 11;

export const bench = define({
  what: 'time until the example game can be used, in Chromium',
  options: {},
  claims: { menu: atMost(2000, 'navigation to menu, ms') },
  async run() {
    const site = join(PROJECT, 'dist/site/index.html');
    if (!existsSync(site)) throw new Error(`expected the built example at ${site}, found nothing: run npm run build`);
    const browser = await launch([...QUIET, '--disable-gpu']);
    const menu: number[] = [];
    const level: number[] = [];
    try {
      for (let i = 0; i < TIMES; i++) {
        // nothing is cached
        const context = await browser.newContext({ viewport: { width: 1024, height: 768 } });
        const page = await context.newPage();
        await page.goto(pathToFileURL(site).href, { waitUntil: 'commit' });
        // the clock of the page starts with its navigation; the button takes the focus once everything listens
        await page.waitForFunction('document.activeElement?.matches("button.primary")', undefined, { polling: 'raf' });
        menu.push(await page.evaluate<number>('performance.now()'));
        const before = await page.evaluate<number>('performance.now()');
        await page.keyboard.press('Enter');
        await page.waitForSelector('[data-state=intro]');
        level.push((await page.evaluate<number>('performance.now()')) - before);
        await context.close();
      }
    } finally {
      await browser.close();
    }
    const row = (what: string, values: readonly number[]) => {
      const { median: middle, q1, q3 } = spread(values);
      return [what, middle, `${q1.toFixed(0)} - ${q3.toFixed(0)}`, Math.max(...values)];
    };
    return {
      title: 'Time until the example game can be used',
      columns: ['', 'ms', 'quartiles', 'longest'],
      rows: [row('from the navigation to the menu', menu), row('from the menu to a level', level)],
      measured: { menu: median(menu) },
      notes: [`${TIMES} visits in contexts of their own, from the disk, without a graphics card.`],
    };
  },
});
