import { createHash, timingSafeEqual } from 'node:crypto';
import type { IncomingMessage } from 'node:http';
import { EDIT_API } from '../../schema/index.ts';
import { Refusal } from './refusal.ts';

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
export function checkToken(incoming: IncomingMessage, token: string): void {
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
