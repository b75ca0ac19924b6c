import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import puppeteer from 'puppeteer-core';
import { describe, expect, it } from 'vitest';
import { EDIT_API } from '../../schema/index.ts';
import { declareMissing } from '../missing.ts';
import { levelText, makeFolder, serve } from '../server/running.ts';
import { CHROMIUM, sharedChromium } from './chromium.ts';

// Requests of real browsers: the page itself gets through, a page of another server on this machine does not.

const FIREFOX = process.env.FIREFOX ?? '/usr/bin/firefox-esr';

/** The part of a page that is used here, common to both drivers. */
interface DriverPage {
  goto(address: string): Promise<unknown>;
  evaluate(script: string): Promise<unknown>;
}

interface BrowserPage {
  goto(address: string): Promise<unknown>;
  evaluate<T, A extends unknown[]>(work: (...args: A) => T, ...args: A): Promise<Awaited<T>>;
}

/** Runs in the page: reads and overwrites a level, as the editor does. */
const save = async (token: string, text: string): Promise<unknown[]> => {
  const headers = { 'x-gq-token': token };
  const read = await fetch('/api/level?id=a', { headers });
  const { etag } = await read.json();
  const body = JSON.stringify({ text, client: 'browser' });
  const send = { 'Content-Type': 'application/json', 'If-Match': etag };
  const written = await fetch('/api/level?id=a', { method: 'PUT', headers: { ...headers, ...send }, body });
  const events = await fetch('/api/events', { headers });
  const first = await events.body?.getReader().read();
  const said = new TextDecoder().decode(first?.value).slice(0, 20);
  return [read.status, written.status, events.status, said, globalThis.crossOriginIsolated];
};

/** Runs in a foreign page: tries everything that a foreign page can try. */
const attack = async (target: string, token: string, text: string): Promise<string[]> => {
  const body = JSON.stringify({ text, client: 'evil' });
  const attempt = (init: RequestInit, path = '/api/level?id=a') =>
    fetch(target + path, init).then(
      (answer) => (answer.type === 'opaque' ? 'opaque' : `read ${answer.status}`),
      () => 'refused',
    );
  const frame = document.createElement('iframe');
  frame.src = target;
  const framed = new Promise<string>((resolve) => {
    frame.onload = () => {
      let seen = 'nothing';
      try {
        seen = String(frame.contentDocument?.title);
      } catch {}
      resolve(seen);
    };
  });
  document.body.append(frame);
  const script = document.createElement('script');
  script.src = `${target}/assets/index-abc.js`;
  const loaded = new Promise<string>((resolve) => {
    script.onload = () => resolve('loaded');
    script.onerror = () => resolve('refused');
  });
  document.body.append(script);
  const headers = { 'x-gq-token': token, 'Content-Type': 'application/json', 'If-Match': '*' };
  const socket = new Promise<string>((resolve) => {
    const open = new WebSocket(`${target.replace('http', 'ws')}/api/events`);
    open.onopen = () => resolve('open');
    open.onerror = () => resolve('refused');
  });
  return [
    await attempt({}, '/api/levels'),
    await attempt({ headers: { 'x-gq-token': token } }, '/api/levels'),
    await attempt({ method: 'PUT', headers, body }),
    await attempt({ method: 'POST', mode: 'no-cors', headers: { 'Content-Type': 'text/plain' }, body }, '/api/delete'),
    await loaded,
    await socket,
    (await framed) === 'page' ? 'framed' : 'refused',
  ];
};

const REFUSED = ['refused', 'refused', 'refused', 'refused', 'refused', 'refused', 'refused'];

async function tryIn(browser: { newPage(): Promise<DriverPage> }): Promise<void> {
  const open = async (): Promise<BrowserPage> => {
    const page = await browser.newPage();
    return {
      goto: (address) => page.goto(address),
      // one of the drivers passes only one argument
      evaluate: (work, ...all) => page.evaluate(`(${work})(...${JSON.stringify(all)})`) as Promise<never>,
    };
  };
  const made = makeFolder({ 'a.level.json': levelText('a') });
  const on = () => readFileSync(join(made.folder, 'a.level.json'), 'utf8');
  const server = await serve(made.folder);
  const evil = createServer((_, answer) => answer.setHeader('Content-Type', 'text/html').end('<!doctype html><body>evil'));
  await new Promise<void>((resolve) => evil.listen(0, '127.0.0.1', resolve));
  const { token } = server.page;
  const address = `http://127.0.0.1:${server.port}`;

  const page = await open();
  await page.goto(server.address);
  expect(await page.evaluate(save, token, levelText('saved'))).toEqual([200, 200, 200, 'data: {"type":"list"', true]);
  expect(on()).toBe(levelText('saved'));

  const foreign = await open();
  for (const name of ['127.0.0.1', 'localhost']) {
    await foreign.goto(`http://${name}:${(evil.address() as AddressInfo).port}/`);
    expect(await foreign.evaluate(attack, address, token, levelText('evil'))).toEqual(REFUSED);
  }
  expect(on()).toBe(levelText('saved'));
  expect(server.crashes).toEqual([]);
  expect(EDIT_API.TOKEN_HEADER).toBe('x-gq-token');
  evil.closeAllConnections();
  evil.close();
  await server.close();
  made.remove();
}

describe('in a real browser the page saves, and a page of another server can not', () => {
  if (existsSync(CHROMIUM)) {
    it('Chromium', async () => {
      const context = await (await sharedChromium()).newContext();
      try {
        await tryIn(context);
      } finally {
        await context.close();
      }
    });
  } else {
    declareMissing('the page in Chromium', `no browser at ${CHROMIUM}: install Chromium or name it in CHROMIUM`);
  }

  if (existsSync(FIREFOX)) {
    it('Firefox', async () => {
      const browser = await puppeteer.launch({ browser: 'firefox', executablePath: FIREFOX, headless: true });
      try {
        await tryIn(browser);
      } finally {
        await browser.close();
      }
    });
  } else {
    declareMissing('the page in Firefox', `no browser at ${FIREFOX}: install Firefox or name it in FIREFOX`);
  }
});
