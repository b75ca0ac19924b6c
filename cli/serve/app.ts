import { createHash, timingSafeEqual } from 'node:crypto';
import type { IncomingMessage } from 'node:http';
import { extname } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { HttpBindings } from '@hono/node-server';
import { Hono } from 'hono';
import type { ContentfulStatusCode } from 'hono/utils/http-status';
import { EDIT_API } from '../../schema/index.ts';
import { readBuilt } from '../io/index.ts';
import type { Answer, EditContext } from './api.ts';
import { bodyOf, Refusal, statusOf } from './refusal.ts';

export interface AppOptions {
  readonly api: ReadonlyMap<string, Answer>;
  readonly page: ReadonlyMap<string, PageFile>;
  readonly token: string;
  /** The port that the server listens on, once it does. */
  readonly port: () => number;
  /** Called with errors that are bugs of gq, not mistakes of the user. */
  readonly onCrash: (error: unknown) => void;
}

/** The page and the API in one app. */
export function createApp({ api, page, token, port, onCrash }: AppOptions): Hono<{ Bindings: HttpBindings }> {
  const answer = (c: EditContext): Response | Promise<Response> => {
    const { incoming } = c.env;
    guard(incoming, port());
    const { method = '', url = '' } = incoming;
    // the raw URL: nothing is decoded or resolved, so no encoding can disguise an address
    const question = url.indexOf('?');
    const address = question < 0 ? url : url.slice(0, question);
    const file = page.get(address);
    if (file !== undefined) {
      if (method !== 'GET' && method !== 'HEAD') throw wrongMethod('GET, HEAD', method);
      return answerPage(c, file);
    }
    const found = api.get(`${method} ${address}`);
    if (found === undefined) throw noAnswer(api, method, address);
    // a page that has only the key asks for this first
    if (address !== EDIT_API.RUN) checkToken(incoming, token);
    return found(c, new URLSearchParams(question < 0 ? '' : url.slice(question + 1)));
  };

  const app = new Hono<{ Bindings: HttpBindings }>();
  app.use(async (c, next) => {
    await next();
    for (const [name, value] of Object.entries(SECURITY_HEADERS)) c.res.headers.set(name, value);
    if (!c.res.headers.has('Cache-Control')) c.res.headers.set('Cache-Control', 'no-store');
  });
  app.all('*', answer);
  app.onError((error, c) => {
    if (!(error instanceof Refusal)) onCrash(error);
    const refusal =
      error instanceof Refusal
        ? error
        : new Refusal('failed', 'gq edit failed on this request', 'This is a bug in gq: please report it.');
    // the rest of a refused body is not read
    if (refusal.code === 'body-too-large') c.header('Connection', 'close');
    return c.json(bodyOf(refusal), statusOf(refusal) as ContentfulStatusCode);
  });
  return app;
}

function answerPage(c: EditContext, file: PageFile): Response {
  const caching = { ETag: file.etag, 'Cache-Control': file.isForever ? 'private, max-age=31536000, immutable' : 'no-cache' };
  if (c.env.incoming.headers['if-none-match'] === file.etag) return c.body(null, 304, caching);
  return c.body(file.content, 200, { 'Content-Type': file.type, ...caching });
}

function noAnswer(api: ReadonlyMap<string, Answer>, method: string, address: string): Refusal {
  const methods = [...api.keys()].map((key) => key.split(' ')).filter(([, known]) => known === address);
  if (methods.length > 0) return wrongMethod(methods.map(([known]) => known).join(', '), method);
  return new Refusal('unknown-address', 'there is nothing at this address', 'Open the address that gq edit printed.');
}

const wrongMethod = (expected: string, found: string): Refusal =>
  new Refusal('wrong-method', `expected ${expected}, found ${found}`, 'Reload the page: it may come from another version of gq.');

const OPEN_PRINTED = 'Open the address that gq edit printed.';

/**
 * Accepts only requests that the editor's own page sends to this server, or that open the page. Any website can make a
 * visitor's browser send requests to 127.0.0.1, but it can't forge the headers Host, Origin and Sec-Fetch-*.
 * Checks the raw request, before anything is parsed, decoded or joined.
 * @throws Refusal
 */
export function guard(incoming: IncomingMessage, port: number): void {
  const { headers, method = '', url = '' } = incoming;
  const host = onlyHost(incoming);
  // an attacker can make a host name resolve to 127.0.0.1 (DNS rebinding), but Host still contains that name
  if (host === null || !hostsOf(port).includes(host)) {
    throw new Refusal('wrong-host', `expected Host: 127.0.0.1:${port}, found ${quoted(host)}`, OPEN_PRINTED);
  }
  if (headers.upgrade !== undefined || /\bupgrade\b/i.test(headers.connection ?? '')) {
    throw new Refusal('upgrade-refused', 'this server speaks only HTTP/1.1, not WebSocket', 'Send the request without Upgrade.');
  }
  const reads = method === 'GET' || method === 'HEAD';
  const site = headers['sec-fetch-site'];
  if (site !== undefined && site !== 'same-origin' && !(reads && !isApi(url) && (site === 'none' || opensPage(incoming)))) {
    throw new Refusal('foreign-page', `a page of another site (${quoted(String(site))}) sent this request`, OPEN_PRINTED);
  }
  // browsers send Origin with everything that is not GET or HEAD
  const { origin } = headers;
  if (origin !== undefined ? origin !== `http://${host}` : !reads) {
    throw new Refusal('foreign-page', `expected Origin: http://${host}, found ${quoted(origin ?? null)}`, OPEN_PRINTED);
  }
}

/** @throws Refusal wrong-token */
function checkToken(incoming: IncomingMessage, token: string): void {
  const given = incoming.headers[EDIT_API.TOKEN_HEADER];
  if (typeof given === 'string' && timingSafeEqual(digest(given), digest(token))) return;
  throw new Refusal('wrong-token', 'this page belongs to another run of gq edit', OPEN_PRINTED);
}

const digest = (text: string): Buffer => createHash('sha256').update(text).digest();

const isApi = (url: string): boolean => url.startsWith('/api/');

/** Any page may link to the editor's page, which does nothing without the token, but no page may put it into a frame. */
const opensPage = ({ headers, url = '' }: IncomingMessage): boolean =>
  /^\/(index\.html)?(\?|$)/.test(url) && headers['sec-fetch-mode'] === 'navigate' && headers['sec-fetch-dest'] === 'document';

function hostsOf(port: number): string[] {
  const names = ['127.0.0.1', 'localhost'];
  // browsers omit port 80
  return names.flatMap((name) => (port === 80 ? [name, `${name}:80`] : [`${name}:${port}`]));
}

/** The Host header, if there is exactly one. */
function onlyHost({ rawHeaders }: IncomingMessage): string | null {
  const hosts = rawHeaders.filter((_, i) => i % 2 === 1 && rawHeaders[i - 1].toLowerCase() === 'host');
  return hosts.length === 1 ? hosts[0] : null;
}

const quoted = (text: string | null): string => (text === null ? 'none' : JSON.stringify(text.slice(0, 80)));

/**
 * The headers of every answer. Inline styles are allowed because widget libraries add style elements to the page; a style can't
 * load anything from another host.
 */
const SECURITY_HEADERS: Readonly<Record<string, string>> = {
  'Content-Security-Policy': [
    "default-src 'none'",
    "script-src 'self'",
    "worker-src 'self'",
    "style-src 'self' 'unsafe-inline'",
    "img-src 'self' data: blob:",
    "font-src 'self'",
    "media-src 'self' blob:",
    "connect-src 'self'",
    "manifest-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
    "frame-ancestors 'none'",
  ].join('; '),
  'X-Content-Type-Options': 'nosniff',
  'X-Frame-Options': 'DENY',
  'Referrer-Policy': 'same-origin',
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
  'Cross-Origin-Resource-Policy': 'same-origin',
  'Permissions-Policy': 'camera=(), microphone=(), geolocation=(), display-capture=(), usb=(), serial=(), hid=(), payment=()',
};

/** A file of the page. */
interface PageFile {
  readonly content: Uint8Array<ArrayBuffer>;
  readonly type: string;
  readonly etag: string;
  /** Whether the name contains a hash of the content, so that the file never changes. */
  readonly isForever: boolean;
}

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.webmanifest': 'application/manifest+json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.ico': 'image/x-icon',
  '.webp': 'image/webp',
  '.woff2': 'font/woff2',
  '.txt': 'text/plain; charset=utf-8',
  '.map': 'application/json',
};

/** The folder into which `npm run build` puts the editor. */
export const PAGE = fileURLToPath(new URL('../../editor', import.meta.url));

/**
 * The files of the built page by address. They are read once: an address is only looked up and never becomes a path, and a
 * later build can't mix two versions.
 * @throws Failure if there is no built page
 */
export function readPage(folder: string): ReadonlyMap<string, PageFile> {
  const files = new Map<string, PageFile>();
  for (const [path, content] of readBuilt(folder, "the editor's page")) {
    const type = TYPES[extname(path)];
    if (type === undefined) continue;
    const etag = `"${createHash('sha256').update(content).digest('base64url')}"`;
    files.set(`/${path}`, { content, type, etag, isForever: path.startsWith('assets/') });
  }
  return files.set('/', files.get('/index.html')!);
}
