// Takes the screenshots of the editor: node docs/take-screenshots.mjs [NAME ...], after npm run build.
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
  { name: 'editor-history', width: 1280, height: 860, theme: 'dark', show: showHistory },
  {
    name: 'runs-side-by-side',
    width: 1280,
    height: 760,
    theme: 'dark',
    compared: true,
    clip: { x: 251, y: 262, width: 729, height: 473 },
  },
];
const wanted = process.argv.slice(2);
const isWanted = (name) => wanted.length === 0 || wanted.includes(name);

/** Makes some versions of the level, and shows what has changed since one of them. */
async function showHistory(page) {
  const edit = async (object, ...keys) => {
    await page.getByRole('treeitem', { name: object }).first().click();
    const saved = page.getByRole('status', { name: 'Saving' });
    await page.getByRole('application', { name: 'Level canvas' }).focus();
    for (const key of keys) await page.keyboard.press(key);
    await page.waitForTimeout(500);
    await saved.filter({ hasText: 'saved' }).waitFor();
  };
  await edit(/^Hot asteroid 2/, 'Shift+ArrowRight');
  await page.keyboard.press('Shift+Y');
  await page.getByRole('textbox', { name: 'Name', exact: true }).fill('First playtest');
  await page.keyboard.press('Enter');
  const kept = page.getByText('This version is kept as "First playtest".');
  await kept.waitFor();
  await edit(/^Hot asteroid 2/, ...Array(6).fill('Shift+ArrowDown'));
  await edit(/^Hot asteroid 1/, ...Array(8).fill('Shift+ArrowLeft'));
  await edit(/^Hot asteroid 3/, 'Delete');
  await kept.waitFor({ state: 'hidden' });
  await page.keyboard.press('y');
  const dialog = page.getByRole('dialog', { name: 'History' });
  await dialog.getByRole('treeitem', { name: /First playtest/ }).click();
  await dialog.getByRole('checkbox', { name: /Hot asteroid 3 removed/ }).check();
  await dialog.getByRole('img', { name: 'Both versions of the level' }).waitFor();
  await page.setViewportSize({ width: 980, height: 620 });
  await page.waitForTimeout(3000);
  return dialog;
}

/** The line over the canvas that says how a run was kept alive. */
const ALIVE = { level: '15-three-swings', width: 1280, height: 800, clip: { x: 251, y: 37, width: 729, height: 603 } };

const folder = mkdtempSync(join(tmpdir(), 'gq-screenshots-'));
cpSync(join(root, 'levels'), join(folder, 'levels'), { recursive: true });
/** The level with another run, and a note. */
function withRuns() {
  const path = join(folder, 'levels', `${LEVEL}.level.json`);
  const file = JSON.parse(readFileSync(path, 'utf8'));
  file.runs[0].notes = [{ tick: 110, text: 'first swing' }];
  file.runs.push(EARLY);
  writeFileSync(path, JSON.stringify(file));
}

// the page shows the path as it is given here
const server = spawn(process.execPath, [join(root, 'dist/gq/main.js'), 'edit', 'levels', '--port', '0'], {
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

/** A run that is kept alive while an asteroid is nudged. */
async function takeAlive() {
  const context = await browser.newContext({ viewport: ALIVE, colorScheme: 'dark' });
  const page = await context.newPage();
  await page.addInitScript((level) => {
    sessionStorage.setItem('gravity-quest-last-level', level);
    localStorage.setItem('gravity-quest-editor-settings', JSON.stringify({ tourSeen: true, keepAlive: true }));
  }, ALIVE.level);
  await page.goto(await address);
  await page.locator('.canvas canvas').waitFor();
  await page
    .getByRole('treeitem', { name: /Hot asteroid 2/ })
    .first()
    .click();
  await page.getByRole('application', { name: 'Level canvas' }).focus();
  for (let px = 0; px < 8; px++) {
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowDown');
  }
  await page
    .locator('.alive--alive')
    .filter({ hasText: /certified.*runs complete/ })
    .waitFor({ timeout: 120_000 });
  await page.locator('.hold__slack').first().waitFor({ timeout: 120_000 });
  await page.screenshot({ path: join(root, 'docs', 'keep-alive-dark.png'), clip: ALIVE.clip });
  await context.close();
}

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
  for (const { name, width, height, theme, show, compared = false, clip } of SHOTS) {
    if (!isWanted(name)) continue;
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
    const shown = (await show?.(page)) ?? page;
    await shown.screenshot({ path: join(root, 'docs', `${name}.png`), clip });
    await context.close();
  }
  if (isWanted('keep-alive-dark')) await takeAlive();
  if (isWanted('pack')) await takePack();
} finally {
  await browser.close();
  server.kill('SIGTERM');
  rmSync(folder, { recursive: true, force: true });
}
