import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { BrowserContext, Page } from 'playwright-core';
import { describe, expect } from 'vitest';
import type { LevelFile } from '../../schema/index.ts';
import { declareMissing } from '../missing.ts';
import { put } from '../server/running.ts';
import type { Canvas } from './canvas.ts';
import { CHROMIUM } from './chromium.ts';
import { type Files, openPlace, type PlaceOptions, type PlaceServer, tellPages } from './place.ts';

export interface StageOptions extends PlaceOptions {
  /** Other files in the folder, by name. */
  readonly others?: Files;
  /** Messages that the browser may log. */
  readonly complaints?: RegExp;
}

/** A folder of levels, a server on it, and its page in a browser. */
export interface Stage {
  readonly folder: string;
  readonly context: BrowserContext;
  readonly page: Page;
  readonly canvas: Canvas;
  /** The current server. */
  server(): PlaceServer;
  /** Opens another page of the same browser and server. */
  open(): Promise<{ page: Page; canvas: Canvas }>;
  /** Reads the text of a level file. */
  text(id: string): string;
  /** Reads a level file. */
  file(id: string): LevelFile;
  /** Writes a file like another program. */
  write(id: string, content: unknown): void;
  /** Waits until the page reports that everything is on disk. */
  saved(): Promise<void>;
  /** Kills the server if it is a process of its own; otherwise cuts its connections and closes it, which the page sees likewise. */
  endServer(): Promise<void>;
  /** Starts it again on the same folder, and on the same port if possible. */
  startServer(port?: number): Promise<void>;
}

export interface Browsers {
  /** Runs a test on a stage that is as new. */
  on(
    levels: Readonly<Record<string, unknown>>,
    play: (stage: Stage) => Promise<void>,
    options?: StageOptions,
  ): () => Promise<void>;
}

const textOf = (content: unknown): string => (typeof content === 'string' ? content : `${JSON.stringify(content, null, 2)}\n`);

/**
 * Declares a suite in the Chromium of the worker. Each test has a folder, a server and a page: new ones, or those that another
 * test has left as new.
 */
export function inChromium(suite: string, declare: (browsers: Browsers) => void): void {
  if (!existsSync(CHROMIUM)) {
    declareMissing(suite, `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
    return;
  }
  describe(suite, () => {
    declare({
      on:
        (levels, play, options = {}) =>
        async () => {
          const { complaints: expected, others = {} } = options;
          const texts = Object.entries(levels).map(([id, content]) => [`${id}.level.json`, textOf(content)] as const);
          const place = await openPlace({ ...others, ...Object.fromEntries(texts) }, options);
          const { folder, page, canvas, complaints, server } = place;
          const text = (id: string) => readFileSync(join(folder, `${id}.level.json`), 'utf8');
          let isGood = false;
          let isTouched = false;
          try {
            await play({
              folder,
              page,
              canvas,
              server,
              get context() {
                // nobody knows what a test does with it
                isTouched = true;
                return place.context;
              },
              open: place.open,
              text,
              file: (id) => JSON.parse(text(id)) as LevelFile,
              write: (id, content) => put(folder, `${id}.level.json`, textOf(content)),
              saved: () =>
                page
                  .getByRole('status', { name: 'Saving' })
                  .filter({ hasText: /^saved$/ })
                  .waitFor(),
              async endServer() {
                await server().end('SIGKILL');
              },
              startServer: place.startServer,
            });
            expect(complaints.filter((complaint) => expected?.test(complaint) !== true)).toEqual([]);
            expect(server().complaints(), 'complaints of the server').toBe('');
            isGood = !isTouched;
          } catch (error) {
            await tellPages(place.context, complaints);
            throw error;
          } finally {
            await place.leave(isGood);
          }
        },
    });
  });
}
