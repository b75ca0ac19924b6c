import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { type Browser, chromium, type Page } from 'playwright-core';
import type { LevelFile } from '../../schema/index.ts';
import { TRACED } from './trace.ts';

const MAIN = fileURLToPath(new URL('../../cli/main.js', import.meta.url));
const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';

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

/**
 * Starts `gq edit` on a folder.
 * @returns its address, and a function that stops it
 */
export async function startEdit(folder: string): Promise<{ address: string; stop: () => void }> {
  const server = spawn(process.execPath, [MAIN, 'edit', folder, '--port', '0'], { stdio: ['ignore', 'pipe', 'inherit'] });
  const address = await new Promise<string>((resolve, reject) => {
    let said = '';
    server.stdout.on('data', (data: Buffer) => {
      said += data.toString();
      const found = /http:\S+#token=\S+/.exec(said);
      if (found !== null) resolve(found[0]);
    });
    server.on('close', (code) => reject(new Error(`gq edit ended with ${code}`)));
  });
  return { address, stop: () => server.kill('SIGTERM') };
}

/** Opens the editor on levels given by their ids; the first one is open. */
export async function openStage(levels: Readonly<Record<string, LevelFile>>): Promise<Stage> {
  const folder = mkdtempSync(join(tmpdir(), 'gq-bench-'));
  for (const [id, level] of Object.entries(levels)) writeFileSync(join(folder, `${id}.level.json`), JSON.stringify(level));
  const { address, stop } = await startEdit(folder);
  const browser: Browser = await chromium.launch({
    executablePath: CHROMIUM,
    headless: true,
    args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--mute-audio'],
  });
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  // the tour would cover the canvas
  await page.addInitScript(`localStorage.setItem('gravity-quest-editor-settings', '{"tourSeen":true}')`);
  page.setDefaultTimeout(60_000);
  await page.goto(address);
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
      stop();
      rmSync(folder, { recursive: true, force: true });
    },
  };
}
