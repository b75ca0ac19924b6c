// Takes the picture of an asteroid that is dragged in docs/editor.md: node docs/take-leeway-picture.mjs, after npm run build.
import { cpSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { startServer } from '../dist/cli/serve/index.js';

const root = fileURLToPath(new URL('..', import.meta.url));
const LEVEL = '07-nova-lane';
/** The asteroid that is dragged, and by how much, px of the screen. */
const ASTEROID = /^Asteroid 1/;
const BY = { x: 12, y: -14 };

const folder = mkdtempSync(join(tmpdir(), 'gq-leeway-'));
cpSync(join(root, 'levels', `${LEVEL}.level.json`), join(folder, `${LEVEL}.level.json`));
const server = await startServer({
  folder,
  port: 0,
  configFrom: folder,
  page: join(root, 'dist/editor'),
  game: join(root, 'dist/site'),
  onCrash: (error) => console.error(error),
});
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
try {
  const context = await browser.newContext({
    viewport: { width: 1180, height: 740 },
    colorScheme: 'dark',
    reducedMotion: 'reduce',
  });
  const page = await context.newPage();
  await page.addInitScript(() => {
    localStorage.setItem(
      'gravity-quest-editor-settings',
      JSON.stringify({ tourSeen: true, snapToObjects: false, snapToGrid: false }),
    );
  });
  await page.goto(server.address);
  const canvas = page.getByRole('application', { name: 'Level canvas' });
  await canvas.waitFor();
  await page
    .getByRole('status', { name: 'Slack' })
    .filter({ hasText: /slack \d/ })
    .waitFor({ timeout: 120_000 });
  await page.getByRole('treeitem', { name: ASTEROID }).first().click();
  await canvas.focus();
  await page.keyboard.press('Shift+L');
  const legend = page.getByRole('figure', { name: 'Where the selection may stand' });
  await legend.getByText(/edges every 1 px\.$/).waitFor({ timeout: 120_000 });
  // the selection is brought into the middle of the view, so that it can be grabbed there
  const box = await canvas.boundingBox();
  await page.keyboard.press('Shift+2');
  for (let i = 0; i < 2; i++) await page.keyboard.press('Minus');
  // what was found before the view changed is still shown for a moment
  await legend.getByText(/refining…$/).waitFor({ timeout: 120_000 });
  await legend.getByText(/edges every 1 px\.$/).waitFor({ timeout: 120_000 });
  const from = { x: box.x + box.width / 2, y: box.y + box.height / 2 + 12 };
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + BY.x, from.y + BY.y, { steps: 6 });
  await page
    .getByRole('note', { name: 'Before and after the change' })
    .getByText(/\d+ ticks → \d+/)
    .waitFor({ timeout: 120_000 });
  await page.screenshot({ path: join(root, 'docs', 'editor-leeway.png'), clip: { ...box } });
  await page.mouse.up();
} finally {
  await browser.close();
  await server.close();
  rmSync(folder, { recursive: true, force: true });
}
