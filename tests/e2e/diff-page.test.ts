import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { LevelFile } from '../../schema/index.ts';
import { gqProcess, makeFiles } from '../cli/gq.ts';
import { shipped } from '../cli/levels.ts';
import { declareMissing } from '../missing.ts';
import { complaintsAbout } from './axe.ts';
import { CHROMIUM, sharedChromium } from './chromium.ts';

const suite = 'the page of gq diff, in Chromium';
if (!existsSync(CHROMIUM)) declareMissing(suite, `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
else {
  describe(suite, () => {
    let browser: Browser;
    let files: ReturnType<typeof makeFiles>;
    let address: string;
    beforeAll(async () => {
      const level = JSON.parse(readFileSync(shipped('16-firewalk'), 'utf8')) as LevelFile;
      const after = structuredClone(level);
      after.name = '</script><img src=x onerror=alert(1)>';
      after.novae?.splice(0, 1);
      if (after.runs !== undefined) after.runs[0].holds[1][0] += 4;
      files = makeFiles({ 'old.level.json': JSON.stringify(level), 'new.level.json': JSON.stringify(after) });
      const ended = await gqProcess(['diff', '--format', 'html', '-o', 'page.html', 'old.level.json', 'new.level.json'], {
        cwd: files.directory,
      });
      expect(ended.stderr).toBe('wrote page.html\n');
      browser = await sharedChromium();
      address = pathToFileURL(join(files.directory, 'page.html')).href;
    });
    afterAll(() => files.remove());

    it.each([
      [1440, 'dark'],
      [1440, 'light'],
      [390, 'dark'],
      [390, 'light'],
    ] as const)(
      'at %i px, %s: both runs play by keyboard, nothing is loaded, nothing is too wide or illegible',
      async (width, theme) => {
        const context = await browser.newContext({ viewport: { width, height: 844 }, colorScheme: theme });
        try {
          const page = await context.newPage();
          const wrong: string[] = [];
          page.on('console', (message) => wrong.push(message.text()));
          page.on('pageerror', (error) => wrong.push(error.message));
          page.on('dialog', (dialog) => {
            wrong.push('a script of the level ran');
            void dialog.dismiss();
          });
          page.on('request', (request) => {
            if (!request.url().startsWith('data:') && request.url() !== address) wrong.push(request.url());
          });
          await page.goto(address);
          const slider = page.getByRole('slider');
          const places = () => page.locator('.ghost').evaluateAll((ghosts) => ghosts.map((g) => g.getAttribute('transform')));
          const start = await places();
          await slider.focus();
          for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowRight');
          await page.keyboard.press('PageUp');
          expect(await page.locator('output').textContent()).toMatch(/^\d+\.\d\d s \(tick \d{2,}\)$/);
          const later = await places();
          expect(later).toHaveLength(2);
          expect(later[0]).not.toBe(start[0]);
          await page.keyboard.press('End');
          const [before, after] = await places();
          // one completes the level, the other is lost
          expect(before).not.toBe(after);
          await page.getByRole('button', { name: 'Play' }).click();
          await page.getByRole('button', { name: 'Pause' }).click();
          expect(await page.locator('img').evaluateAll((all) => all.every((i) => (i as HTMLImageElement).naturalWidth > 0))).toBe(
            true,
          );
          expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
          expect(wrong).toEqual([]);
        } finally {
          await context.close();
        }
      },
    );

    it('has no barrier that axe knows', async () => {
      for (const colorScheme of ['dark', 'light'] as const) {
        // the policy of the page also keeps out what axe is made of
        const context = await browser.newContext({ viewport: { width: 390, height: 844 }, colorScheme, bypassCSP: true });
        try {
          const page = await context.newPage();
          await page.goto(address);
          expect(await complaintsAbout(page, colorScheme)).toEqual([]);
        } finally {
          await context.close();
        }
      }
    });
  });
}
