import process from 'node:process';
import { type Browser, chromium } from 'playwright-core';
import { inject } from 'vitest';

export const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
const ARGUMENTS = [
  ...['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking'],
  ...['--disable-component-update', '--disable-sync', '--mute-audio'],
  // without this, Chromium loads pages for the address bar of every window, which cost more processor time than the editor
  '--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup,SpareRendererForSitePerProcess',
  // without a graphics card, the processor renders WebGL
  '--enable-unsafe-swiftshader',
];

let running: Browser | undefined;

async function launch(): Promise<Browser> {
  const { TMPDIR } = process.env;
  // Playwright reads the folder for temporary files when it makes a profile
  process.env.TMPDIR = inject('profiles');
  try {
    return await chromium.launch({ executablePath: CHROMIUM, headless: true, args: ARGUMENTS, handleSIGTERM: false });
  } finally {
    if (TMPDIR === undefined) delete process.env.TMPDIR;
    else process.env.TMPDIR = TMPDIR;
    // vitest ends a worker by SIGTERM, and soon by SIGKILL. Playwright would first ask Chromium to close; on exit it kills it.
    process.once('SIGTERM', () => process.exit());
  }
}

/**
 * The Chromium of this worker, shared by all its test files, since the project `browser` does not isolate them. It ends with
 * the worker. Each test needs its own context, and closes it.
 */
export async function sharedChromium(): Promise<Browser> {
  if (running?.isConnected() !== true) running = await launch();
  return running;
}
