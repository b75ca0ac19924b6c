import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import puppeteer from 'puppeteer-core';
import { describe, expect, it } from 'vitest';
import { extentOf } from '../../editor/canvas/extent.ts';
import { fitBox, type Point, toScreen } from '../../editor/canvas/view.ts';
import { boxOf } from '../../engine/index.ts';
import { DEFAULT_RULES, type LevelFile } from '../../schema/index.ts';
import { gq } from '../cli/gq.ts';
import { declareMissing } from '../missing.ts';
import { gqEdit } from '../server/command.ts';
import { makeFolder } from '../server/running.ts';
import { straight } from './levels.ts';
import { PATIENCE, until } from './until.ts';

const FIREFOX = process.env.FIREFOX ?? '/usr/bin/firefox-esr';
const CANVAS = '[role=application][aria-label="Level canvas"]';

/** The same core journey as in Chromium, with a driver for Firefox. */
async function journey(): Promise<void> {
  const { folder, remove } = makeFolder({ '01.level.json': JSON.stringify(straight({ runs: undefined })) });
  const server = await gqEdit(['.', '--port', '0'], { cwd: folder });
  const browser = await puppeteer.launch({ browser: 'firefox', executablePath: FIREFOX, headless: true });
  const path = join(folder, '01.level.json');
  const file = () => JSON.parse(readFileSync(path, 'utf8')) as LevelFile;
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(PATIENCE);
    await page.setViewport({ width: 1280, height: 800 });
    await page.evaluateOnNewDocument(() => {
      localStorage.setItem('gravity-quest-editor-settings', '{"tourSeen":true}');
    });
    await page.goto(server.address);
    await page.waitForSelector(CANVAS);
    const verdict = (text: string) => page.waitForSelector(`[aria-label="Verdict: ${text}"]`);
    await verdict('unproven');
    await page.focus(CANVAS);
    await page.keyboard.press('f');
    const box = await (await page.waitForSelector(CANVAS))?.boundingBox();
    const extent = extentOf(file(), boxOf(DEFAULT_RULES));
    if (box == null || extent === null) throw new Error('nothing is to be seen');
    const view = fitBox({ x: 0, y: 0, zoom: 1, width: box.width, height: box.height }, extent);
    const at = (place: Point): [x: number, y: number] => {
      const { x, y } = toScreen(view, place);
      return [box.x + x, box.y + y];
    };

    // a tool, a place, a drag, undo
    await page.click('[role=toolbar][aria-label=Tools] [aria-label=Asteroid]');
    await page.mouse.click(...at({ x: 600, y: 400 }));
    await until(() => expect(file().asteroids?.[1]).toMatchObject({ x: 600, y: 400 }));
    await page.mouse.move(...at({ x: 600, y: 400 }));
    await page.mouse.down();
    await page.mouse.move(...at({ x: 640, y: 448 }), { steps: 4 });
    await page.mouse.up();
    await until(() => expect(file().asteroids?.[1]).toMatchObject({ x: 640, y: 448 }));
    for (let i = 0; i < 2; i++) {
      await page.keyboard.down('Control');
      await page.keyboard.press('z');
      await page.keyboard.up('Control');
    }
    await until(() => expect(file().asteroids).toHaveLength(1));

    // play, and keep the attempt as a run
    await page.keyboard.press(' ');
    await page.waitForSelector('[role=application][aria-label^=Playtest]');
    await page.mouse.move(...at({ x: 448, y: 400 }));
    await page.mouse.down();
    await page.waitForSelector('[role=application][aria-label^=Playtest] [role=status]');
    await page.mouse.up();
    await page.keyboard.press('Enter');
    await verdict('completable');
    await until(() => expect(file().runs).toHaveLength(1));
    await until(async () => {
      const saving = await page.$eval('[aria-label=Saving]', (element) => element.textContent);
      expect(saving).toBe('saved');
    });
    expect((await gq(['check', path])).code).toBe(0);
  } finally {
    await browser.close();
    await server.end('SIGTERM');
    remove();
  }
}

describe('the core journey in Firefox', () => {
  if (existsSync(FIREFOX)) it('place, drag, undo, play, promote, save, check', journey);
  else declareMissing('the core journey in Firefox', `no browser at ${FIREFOX}: install Firefox or name it in FIREFOX`);
});
