import process from 'node:process';
import { type Browser, chromium } from 'playwright-core';
import { inject } from 'vitest';

export const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
const ARGUMENTS = [
  ...['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking'],
  ...['--disable-component-update', '--disable-sync', '--mute-audio'],
  // Chromium would load pages of its own for the address bar of every window: more work for the processor than a page of ours
  '--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup,SpareRendererForSitePerProcess',
  // without a graphics card the processor draws what WebGL is asked for
  '--enable-unsafe-swiftshader',
];

let running: Browser | undefined;

async function launch(): Promise<Browser> {
  const { TMPDIR } = process.env;
  // Playwright asks for the folder of temporary files when it makes a profile
  process.env.TMPDIR = inject('profiles');
  try {
    return await chromium.launch({ executablePath: CHROMIUM, headless: true, args: ARGUMENTS, handleSIGTERM: false });
  } finally {
    if (TMPDIR === undefined) delete process.env.TMPDIR;
    else process.env.TMPDIR = TMPDIR;
    // vitest ends a worker by SIGTERM, and soon after by SIGKILL. Playwright would ask Chromium to close first; on exit it kills it.
    process.once('SIGTERM', () => process.exit());
  }
}

/**
 * The Chromium of this worker: all of its test files share it, since the project `browser` does not isolate them.
 * It ends with the worker. A test needs a context of its own, and closes it.
 */
export async function sharedChromium(): Promise<Browser> {
  if (running?.isConnected() !== true) running = await launch();
  return running;
}
