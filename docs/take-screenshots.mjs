// Takes the README's screenshots of the editor: node docs/take-screenshots.mjs, after npm run build.
import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const root = fileURLToPath(new URL('..', import.meta.url));
const LEVEL = '16-firewalk';
/** A run that is in no shipped level, to compare with. */
const EARLY = {
  name: 'too early',
  holds: [
    [90, 230],
    [290, 420],
    [470, 760],
  ],
};
const SHOTS = [
  { name: 'editor-dark', width: 1440, height: 900, theme: 'dark' },
  { name: 'editor-light', width: 1440, height: 900, theme: 'light' },
  { name: 'editor-phone-dark', width: 390, height: 844, theme: 'dark' },
  { name: 'editor-phone-light', width: 390, height: 844, theme: 'light' },
  {
    name: 'runs-side-by-side',
    width: 1280,
    height: 760,
    theme: 'dark',
    compared: true,
    clip: { x: 251, y: 262, width: 729, height: 473 },
  },
];

const levels = mkdtempSync(join(tmpdir(), 'gq-screenshots-'));
cpSync(join(root, 'levels'), levels, { recursive: true });
/** The level with another run, and a note. */
function withRuns() {
  const path = join(levels, `${LEVEL}.level.json`);
  const file = JSON.parse(readFileSync(path, 'utf8'));
  file.runs[0].notes = [{ tick: 110, text: 'first swing' }];
  file.runs.push(EARLY);
  writeFileSync(path, JSON.stringify(file));
}

const server = spawn(process.execPath, [join(root, 'dist/cli/main.js'), 'edit', levels, '--port', '0'], {
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
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
try {
  for (const { name, width, height, theme, compared = false, clip } of SHOTS) {
    if (compared) withRuns();
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
    if (compared) {
      await page.getByRole('tab', { name: 'Runs' }).click();
      await page.getByRole('application', { name: 'Level canvas' }).focus();
      await page.keyboard.press('c');
      await page.keyboard.press('c');
      await page.getByRole('button', { name: /^1 all-minerals: reaches/ }).waitFor();
      await page.getByRole('button', { name: /^2 too early: / }).waitFor();
      await page.getByRole('row', { name: /^slack .* ticks? .* ticks?/ }).waitFor();
    }
    await time.focus();
    for (let second = 0; second < (compared ? 9 : 4); second++) await page.keyboard.press('PageUp');
    await page.waitForTimeout(500);
    await page.screenshot({ path: join(root, 'docs', `${name}.png`), clip });
    await context.close();
  }
} finally {
  await browser.close();
  server.kill('SIGTERM');
  rmSync(levels, { recursive: true, force: true });
}
