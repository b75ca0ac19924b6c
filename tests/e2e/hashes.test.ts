import { existsSync } from 'node:fs';
import puppeteer from 'puppeteer-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { bundleEngine } from '../browsers/bundle.ts';
import { committedTable, questions, tableOf } from '../browsers/hash-table.ts';
import { hashedRuns } from '../browsers/scenes.ts';
import { declareMissing } from '../missing.ts';
import { CHROMIUM, sharedChromium } from './chromium.ts';

const committed = committedTable();
const runs = hashedRuns();
const asked = questions(runs);

const FIREFOX = process.env.FIREFOX ?? '/usr/bin/firefox-esr';

/** Runs in a page with the bundle. */
const answersInPage = (list: typeof asked): string[] =>
  list.map(([level, holds, accuracy]) =>
    // biome-ignore lint/suspicious/noExplicitAny: the bundle's global
    (globalThis as any).gravityQuest.hashOf(level, holds, accuracy),
  );

// Node, Bun and QuickJS are tested in tests/browsers
describe('hashes of runs', () => {
  let bundle = '';
  beforeAll(async () => {
    bundle = await bundleEngine();
  });

  if (existsSync(CHROMIUM)) {
    it('in Chromium are the committed ones', async () => {
      const context = await (await sharedChromium()).newContext();
      try {
        const page = await context.newPage();
        await page.addScriptTag({ content: bundle });
        const answers = await page.evaluate(answersInPage, asked);
        expect(tableOf(runs, answers)).toEqual(committed);
      } finally {
        await context.close();
      }
    });
  } else {
    declareMissing('hashes in Chromium', `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
  }

  if (existsSync(FIREFOX)) {
    it('in Firefox are the committed ones', async () => {
      const browser = await puppeteer.launch({ browser: 'firefox', executablePath: FIREFOX, headless: true });
      try {
        const page = await browser.newPage();
        await page.addScriptTag({ content: bundle });
        const answers = await page.evaluate(answersInPage, asked);
        expect(tableOf(runs, answers)).toEqual(committed);
      } finally {
        await browser.close();
      }
    });
  } else {
    declareMissing('hashes in Firefox', `no browser at ${FIREFOX}: install Firefox or name it in FIREFOX`);
  }
});
