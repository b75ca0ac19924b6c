// Takes the picture of what keeps a level in order: node docs/take-order-picture.mjs, after npm run build.
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const root = fileURLToPath(new URL('..', import.meta.url));
const LEVEL = '16-firewalk';

/** The level with a group, a locked and named asteroid, a hidden one and a note. */
function marked() {
  const file = JSON.parse(readFileSync(join(root, 'levels', `${LEVEL}.level.json`), 'utf8'));
  const [first, second, third, ...others] = file.asteroids;
  const [nova, ...novae] = file.novae ?? [];
  return {
    ...file,
    asteroids: [
      { ...first, 'x-group': 'entrance' },
      { ...second, 'x-group': 'entrance' },
      { ...third, 'x-name': 'Gate', 'x-locked': true },
      ...others,
    ],
    ...(nova !== undefined && { novae: [{ ...nova, 'x-hidden': true }, ...novae] }),
    'x-notes': { gate: { x: third.x, y: third.y - 60, text: 'Too narrow?' } },
  };
}

const levels = mkdtempSync(join(tmpdir(), 'gq-order-'));
writeFileSync(join(levels, `${LEVEL}.level.json`), JSON.stringify(marked()));
const server = spawn(process.execPath, [join(root, 'dist/gq/main.js'), 'edit', levels, '--port', '0']);
const address = new Promise((resolve) => {
  for (const stream of [server.stdout, server.stderr]) {
    createInterface({ input: stream }).on('line', (line) => {
      const found = /http:\/\/\S+/.exec(line);
      if (found !== null) resolve(found[0]);
    });
  }
});
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
try {
  const context = await browser.newContext({ viewport: { width: 1100, height: 700 }, colorScheme: 'dark' });
  const page = await context.newPage();
  await page.addInitScript(() => {
    localStorage.setItem('gravity-quest-editor-settings', JSON.stringify({ tourSeen: true, rulers: true }));
  });
  await page.goto(await address);
  await page.locator('.canvas canvas').waitFor();
  await page.getByRole('treeitem', { name: /^entrance/ }).waitFor();
  await page.getByRole('treeitem', { name: /^entrance/ }).click({ button: 'right' });
  await page.getByRole('menuitem', { name: 'Select all of the group' }).click();
  await page.getByRole('application', { name: 'Level canvas' }).focus();
  for (let i = 0; i < 2; i++) await page.keyboard.press('Equal');
  await page.locator('.minimap').waitFor();
  await page.waitForTimeout(1000);
  await page.screenshot({ path: join(root, 'docs', 'editor-order.png'), clip: { x: 0, y: 36, width: 800, height: 430 } });
} finally {
  await browser.close();
  server.kill('SIGTERM');
  rmSync(levels, { recursive: true, force: true });
}
