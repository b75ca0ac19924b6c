import process from 'node:process';
import { type BrowserContext, chromium } from 'playwright-core';
import { CHROMIUM, QUIET, started } from '../harness/index.ts';

/** A browser whose profile outlives it. */
export interface KillableBrowser {
  readonly context: BrowserContext;
  /** Ends all of its processes at once, as a power failure does. */
  kill(): Promise<void>;
}

/** Starts Chromium on a profile and waits until it can be controlled. */
export async function startBrowser(profile: string): Promise<KillableBrowser> {
  const looks = ['--headless', '--disable-gpu', '--window-size=1280,800'];
  const { child, found, ended } = await started(
    [CHROMIUM, ...QUIET, ...looks, '--remote-debugging-port=0', `--user-data-dir=${profile}`, 'about:blank'],
    /ws:\/\/\S+/,
    'stderr',
    // a process group of its own: its helpers are killed with it, and nothing else
    { detached: true, stdio: ['ignore', 'ignore', 'pipe'] },
  );
  const browser = await chromium.connectOverCDP(found);
  return {
    context: browser.contexts()[0],
    async kill() {
      process.kill(-(child.pid as number), 'SIGKILL');
      await ended;
      await browser.close().catch(() => undefined);
    },
  };
}
