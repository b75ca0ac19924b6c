import { existsSync } from 'node:fs';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { atMost, publish, spread } from './harness.ts';

/** How often the page is opened. */
const TIMES = 11;

const site = fileURLToPath(new URL('../site/index.html', import.meta.url));
if (!existsSync(site)) throw new Error(`expected the built example at ${site}, found nothing: run npm run build`);

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu', '--mute-audio', '--no-first-run'],
});
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
  const { median, q1, q3 } = spread(values);
  return [what, median, `${q1.toFixed(0)} - ${q3.toFixed(0)}`, Math.max(...values)];
};

publish({
  title: 'Time until the example game can be used',
  columns: ['', 'ms', 'quartiles', 'longest'],
  rows: [row('from the navigation to the menu', menu), row('from the menu to a level', level)],
  claims: [atMost('navigation to menu, ms', spread(menu).median, 2000)],
  notes: [`${TIMES} visits in contexts of their own, from the disk, without a graphics card.`],
});
