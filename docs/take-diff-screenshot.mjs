// Takes the screenshot of the page of `gq diff`: node docs/take-diff-screenshot.mjs, after npm run build.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const root = fileURLToPath(new URL('..', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'gq-screenshot-'));
const before = readFileSync(join(root, 'levels/16-firewalk.level.json'), 'utf8');
const level = JSON.parse(before);
level.asteroids[1].x += 12;
level.asteroids[1].radius = 20;
level.novae.splice(0, 1);
level.runs[0].holds[1][0] += 4;
writeFileSync(join(folder, 'before.level.json'), before);
writeFileSync(join(folder, 'after.level.json'), JSON.stringify(level));
const args = ['diff', '--format', 'html', '-o', 'page.html', 'before.level.json', 'after.level.json'];
spawnSync(process.execPath, [join(root, 'dist/gq/main.js'), ...args], { cwd: folder, stdio: 'inherit' });
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
try {
  const page = await browser.newPage({ viewport: { width: 1240, height: 860 }, colorScheme: 'light' });
  await page.goto(pathToFileURL(join(folder, 'page.html')).href);
  await page.getByRole('slider').fill('400');
  await page.screenshot({ path: join(root, 'docs/diff-page.png') });
} finally {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
}
