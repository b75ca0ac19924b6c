import { type Browser, chromium } from 'playwright-core';

export const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';

/** Arguments with which Chromium does nothing but what it is told. */
export const QUIET = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--mute-audio'];

/** What a page of the editor runs first: the tour would cover the canvas. */
export const NO_TOUR = `localStorage.setItem('gravity-quest-editor-settings', '{"tourSeen":true}')`;

export const launch = (args: readonly string[]): Promise<Browser> =>
  chromium.launch({ executablePath: CHROMIUM, headless: true, args: [...args] });
