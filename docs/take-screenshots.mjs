// Takes the README's screenshots of the editor: node docs/take-screenshots.mjs, after npm run build.
import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const root = fileURLToPath(new URL('..', import.meta.url));
const LEVEL = '16-firewalk';
const SHOTS = [
  { name: 'editor-dark', width: 1440, height: 900, theme: 'dark' },
  { name: 'editor-light', width: 1440, height: 900, theme: 'light' },
  { name: 'editor-phone-dark', width: 390, height: 844, theme: 'dark' },
  { name: 'editor-phone-light', width: 390, height: 844, theme: 'light' },
];

const folder = mkdtempSync(join(tmpdir(), 'gq-screenshots-'));
cpSync(join(root, 'levels'), join(folder, 'levels'), { recursive: true });
// the page shows the path as it is given here
const server = spawn(process.execPath, [join(root, 'dist/cli/main.js'), 'edit', 'levels', '--port', '0'], {
  cwd: folder,
  stdio: ['ignore', 'pipe', 'pipe'],
});
const address = new Promise((resolve) => {
  for (const stream of [server.stdout, server.stderr]) {
    createInterface({ input: stream }).on('line', (line) => {
      const found = /http:\/\/\S+/.exec(line);
      if (found !== null) resolve(found[0]);
    });
  }
});

/** The view of all levels, with the grades of all: measuring them takes minutes. */
async function takePack() {
  const context = await browser.newContext({ viewport: { width: 1060, height: 700 }, colorScheme: 'dark' });
  const page = await context.newPage();
  await page.addInitScript(() => localStorage.setItem('gravity-quest-editor-settings', JSON.stringify({ tourSeen: true })));
  await page.goto(await address);
  await page.locator('.canvas canvas').waitFor();
  await page.keyboard.press('Shift+P');
  await page.getByRole('button', { name: 'Measure', exact: true }).click();
  await page.getByRole('button', { name: 'Measured' }).waitFor({ timeout: 1_200_000 });
  await page.screenshot({ path: join(root, 'docs', 'pack.png') });
  await context.close();
}

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
try {
  for (const { name, width, height, theme } of SHOTS) {
    const context = await browser.newContext({ viewport: { width, height }, colorScheme: theme, hasTouch: width < 800 });
    const page = await context.newPage();
    await page.addInitScript((level) => {
      sessionStorage.setItem('gravity-quest-last-level', level);
      localStorage.setItem('gravity-quest-editor-settings', JSON.stringify({ tourSeen: true }));
    }, LEVEL);
    await page.goto(await address);
    await page.locator('.canvas canvas').waitFor();
    // all verdicts and thumbnails of the list are there, and what the shown run forgives
    await page.getByText('checking').first().waitFor({ state: 'detached', timeout: 120_000 });
    await page.locator('.hold__slack').first().waitFor({ timeout: 120_000 });
    const time = page.getByRole('slider', { name: 'Time' });
    if (width >= 800) {
      const asteroid = page.getByRole('treeitem', { name: /Hot asteroid 2/ }).first();
      if (await asteroid.isVisible()) await asteroid.click();
    }
    await page
      .getByRole('status', { name: 'Slack' })
      .filter({ hasText: /slack \d/ })
      .waitFor({ timeout: 120_000 });
    await time.focus();
    for (let second = 0; second < 4; second++) await page.keyboard.press('PageUp');
    await page.waitForTimeout(500);
    await page.screenshot({ path: join(root, 'docs', `${name}.png`) });
    await context.close();
  }
  await takePack();
} finally {
  await browser.close();
  server.kill('SIGTERM');
  rmSync(folder, { recursive: true, force: true });
}
