import { existsSync } from 'node:fs';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { createPlayer } from '../../game/index.ts';
import { shipped } from '../levels/shipped-pack.ts';
import { declareMissing } from '../missing.ts';
import { CHROMIUM, sharedChromium } from './chromium.ts';
import { paceFrames } from './frames.ts';
import { MAJORS, type Major, scriptsOf, WAYS, type Way } from './phaser/pages.ts';
import { PATIENCE } from './until.ts';

// A game with both majors of Phaser, bundled by Vite and esbuild or by script tags, in a real browser.

/** What the page has; the game is any version of Phaser's. */
interface InPage {
  // biome-ignore lint/suspicious/noExplicitAny: two versions of Phaser, by a page
  readonly gravityQuestTest: any;
  // biome-ignore lint/suspicious/noExplicitAny: see above
  runner: any;
  // biome-ignore lint/suspicious/noExplicitAny: see above
  scene: any;
}

const { text, level } = shipped('watchdog');
const [{ holds }] = level.runs;

/** The run by the player of the game, in this process. */
function expected() {
  const scene = compile(level, 'precise');
  const player = createPlayer(scene, { replay: holds });
  while (player.ending === null) player.advance(1000 / 60);
  const run = simulate(scene, holds);
  expect([run.tick, run.outcome]).toEqual([player.ending.tick, player.ending.outcome]);
  return { hash: player.hash, holds: player.holds, tick: run.tick, outcome: run.outcome, events: run.events };
}

const suite = 'a runner in Phaser, in Chromium';
if (!existsSync(CHROMIUM)) declareMissing(suite, `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
else {
  describe(suite, () => {
    let browser: Browser;
    const scripts = new Map<string, string>();
    beforeAll(async () => {
      browser = await sharedChromium();
    });
    afterAll(() => scripts.clear());

    /** Opens a page with a game of a scene that has begun, and lets a test play with it. */
    async function on(way: Way, major: Major, renderer: string, play: (page: Page) => Promise<void>): Promise<void> {
      const context = await browser.newContext({ viewport: { width: 640, height: 480 }, hasTouch: true });
      const complaints: string[] = [];
      try {
        await context.addInitScript(paceFrames);
        const page = await context.newPage();
        page.setDefaultTimeout(PATIENCE);
        page.on('pageerror', (error) => complaints.push(error.stack ?? error.message));
        page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
        const name = `${way} ${major}`;
        if (!scripts.has(name)) scripts.set(name, await scriptsOf(way, major));
        const style = '<style>html, body { margin: 0; height: 100%; overflow: hidden }</style><link rel="icon" href="data:,">';
        const html = `<!doctype html><meta charset="utf-8">${style}<body>${scripts.get(name)}`;
        await context.route('http://game.test/', (route) => route.fulfill({ contentType: 'text/html', body: html }));
        await page.goto('http://game.test/');
        await page.waitForFunction(() => 'gravityQuestTest' in globalThis);
        await page.evaluate((type) => {
          const here = globalThis as unknown as InPage;
          const { Phaser, makePlugin } = here.gravityQuestTest;
          const plugins =
            makePlugin === undefined
              ? {}
              : { plugins: { scene: [{ key: 'gravityQuest', plugin: makePlugin(Phaser), mapping: 'gravityQuest' }] } };
          return new Promise<void>((resolve) => {
            new Phaser.Game({
              type: Phaser[type],
              scale: { mode: Phaser.Scale.RESIZE },
              banner: false,
              audio: { noAudio: true },
              ...plugins,
              scene: {
                create(this: unknown) {
                  here.scene = this;
                  resolve();
                },
              },
            });
          });
        }, renderer);
        await play(page);
        expect(complaints).toEqual([]);
      } finally {
        await context.close();
      }
    }

    const start = (page: Page, options: object = {}) =>
      page.evaluate(
        ([content, more]) => {
          const here = globalThis as unknown as InPage;
          const { createRunner, readLevel } = here.gravityQuestTest;
          const reading = readLevel(content);
          const { gravityQuest } = here.scene;
          const all = { restartAfter: null, ...(more as object) };
          here.runner = gravityQuest?.run(reading.level, all) ?? createRunner(here.scene, reading.level, all);
        },
        [text, options] as const,
      );

    const played = (page: Page) =>
      page.evaluate(() => {
        const { player } = (globalThis as unknown as InPage).runner;
        const { tick, outcome } = player.ending;
        return { hash: player.hash, holds: player.holds, tick, outcome, events: player.events };
      });

    for (const major of MAJORS) {
      for (const way of WAYS) {
        const renderer = way === 'esbuild' ? 'WEBGL' : 'CANVAS';
        it(`${major} by ${way}: plays a level's own run bit for bit on ${renderer}`, () =>
          on(way, major, renderer, async (page) => {
            await start(page, { replay: holds, maxFrame: 1000, ghosts: [{ name: 'drift', holds: [] }] });
            // the run takes seconds; the page's clock is faster
            await page.evaluate('setRate(8)');
            await page.waitForFunction(() => (globalThis as unknown as InPage).runner.player.ending !== null);
            expect(await played(page)).toEqual(expected());
          }));
      }

      it(`${major}: mouse, finger and keys hold the gun, buttons of the game and of the page do not`, () =>
        on('a script tag', major, 'CANVAS', async (page) => {
          await page.evaluate(() => {
            const { scene } = globalThis as unknown as InPage;
            scene.add.rectangle(40, 40, 60, 60, 0xffffff).setDepth(9).setInteractive();
            const button = document.createElement('button');
            button.style.cssText = 'position: fixed; right: 0; top: 0; width: 60px; height: 60px';
            document.body.append(button);
          });
          await start(page);
          const held = () => page.evaluate(() => (globalThis as unknown as InPage).runner.player.held as boolean);
          const waitFor = (down: boolean) =>
            page.waitForFunction((wanted) => (globalThis as unknown as InPage).runner.player.held === wanted, down);
          const restart = () => page.evaluate(() => (globalThis as unknown as InPage).runner.restart());
          await page.mouse.move(300, 300);
          await page.mouse.down();
          await waitFor(true);
          // it goes up over a button of the page
          await page.mouse.move(630, 10);
          await page.mouse.up();
          await waitFor(false);
          await restart();
          await page.keyboard.down('Space');
          await waitFor(true);
          await page.evaluate(() => window.dispatchEvent(new Event('blur')));
          await waitFor(false);
          await page.keyboard.up('Space');
          await restart();
          await page.touchscreen.tap(200, 300);
          await page.waitForFunction(() => (globalThis as unknown as InPage).runner.player.holds.length > 0);
          await waitFor(false);
          await restart();
          for (const [x, y] of [
            [40, 40],
            [620, 20],
          ]) {
            await page.mouse.move(x, y);
            await page.mouse.down();
            await page.mouse.up();
          }
          await page.waitForFunction(() => (globalThis as unknown as InPage).runner.player.tick > 6);
          expect(await held()).toBe(false);
          expect(await page.evaluate(() => (globalThis as unknown as InPage).runner.player.holds)).toEqual([]);
        }));

      it(`${major}: two runners in a scene, and a second game on the page, play independently`, () =>
        on('a script tag', major, 'CANVAS', async (page) => {
          await page.evaluate(
            async ([content, run]) => {
              const here = globalThis as unknown as InPage;
              const { Phaser, createRunner, readLevel } = here.gravityQuestTest;
              const reading = readLevel(content);
              const second = await new Promise((resolve) => {
                new Phaser.Game({
                  type: Phaser.CANVAS,
                  width: 200,
                  height: 150,
                  banner: false,
                  audio: { noAudio: true },
                  scene: {
                    create(this: unknown) {
                      resolve(this);
                    },
                  },
                });
              });
              const begin = (scene: unknown, options: object) =>
                createRunner(scene, reading.level, { restartAfter: null, maxFrame: 1000, ...options });
              here.runner = [
                begin(here.scene, { replay: run }),
                begin(here.scene, { replay: [], camera: 'none' }),
                begin(second, { replay: run }),
              ];
            },
            [text, holds] as const,
          );
          await page.evaluate('setRate(8)');
          const ended = (i: number) =>
            page.waitForFunction((k) => (globalThis as unknown as InPage).runner[k].player.ending !== null, i);
          const hash = (i: number) => page.evaluate((k) => (globalThis as unknown as InPage).runner[k].player.hash as string, i);
          // one that is removed takes nothing away from the others
          await page.evaluate(() => (globalThis as unknown as InPage).runner[1].destroy());
          await ended(0);
          await ended(2);
          const { hash: right } = expected();
          expect([await hash(0), await hash(2)]).toEqual([right, right]);
          expect(await hash(1)).not.toBe(right);
        }));

      it(`${major}: runners leave nothing behind in the scene, with which the last one ends`, () =>
        on('a script tag', major, 'CANVAS', async (page) => {
          const counts = () =>
            page.evaluate(() => {
              const { scene } = globalThis as unknown as InPage;
              const emitters = [scene.sys.events, scene.input, scene.scale, scene.game.events];
              const listeners = emitters.map((one) =>
                one.eventNames().reduce((sum: number, name: string) => sum + one.listenerCount(name), 0),
              );
              return [...listeners, scene.children.length, scene.sys.updateList.length, scene.textures.getTextureKeys().length];
            });
          const round = (count: number) =>
            page.evaluate(
              ([content, times]) => {
                const { gravityQuestTest, scene } = globalThis as unknown as InPage;
                const reading = gravityQuestTest.readLevel(content);
                for (let i = 0; i < times; i++) gravityQuestTest.createRunner(scene, reading.level).destroy();
              },
              [text, count] as const,
            );
          // the first one draws the textures, which stay
          await round(1);
          const before = await counts();
          await round(100);
          expect(await counts()).toEqual(before);
          await start(page);
          expect(await counts()).not.toEqual(before);
          await page.evaluate(() => (globalThis as unknown as InPage).scene.scene.restart());
          await page.waitForFunction((objects) => (globalThis as unknown as InPage).scene.children.length === objects, before[4]);
          expect((await counts()).slice(4)).toEqual(before.slice(4));
        }));
    }
  });
}
