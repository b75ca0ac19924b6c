import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import type { Page } from 'playwright-core';
import type { LevelFile } from '../../schema/index.ts';
import { ADDRESS, GQ, launch, NO_TOUR, QUIET, started } from '../harness/index.ts';
import { TRACED } from './trace.ts';

/** A page of `gq edit` in a real browser, on levels of its own. */
export interface Stage {
  readonly page: Page;
  readonly folder: string;
  /**
   * Runs a function and traces what happens meanwhile.
   * @returns the trace as JSON
   */
  traced(act: () => Promise<void>): Promise<string>;
  close(): Promise<void>;
}

/** Opens the editor on levels given by their ids; the first one is open. */
export async function openStage(levels: Readonly<Record<string, LevelFile>>): Promise<Stage> {
  const folder = mkdtempSync(join(tmpdir(), 'gq-bench-'));
  for (const [id, level] of Object.entries(levels)) writeFileSync(join(folder, `${id}.level.json`), JSON.stringify(level));
  const server = await started([process.execPath, GQ, 'edit', folder, '--port', '0'], ADDRESS, 'stdout', {
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  const browser = await launch(QUIET);
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  await page.addInitScript(NO_TOUR);
  page.setDefaultTimeout(60_000);
  await page.goto(server.found);
  await page.getByRole('application', { name: 'Level canvas' }).waitFor();
  return {
    page,
    folder,
    async traced(act) {
      await browser.startTracing(page, { categories: TRACED });
      await act();
      return (await browser.stopTracing()).toString();
    },
    async close() {
      await browser.close();
      server.child.kill('SIGTERM');
      rmSync(folder, { recursive: true, force: true });
    },
  };
}
