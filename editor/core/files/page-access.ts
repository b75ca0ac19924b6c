import { EDIT_API, KEY_RESPONSE, RUN_RESPONSE, runMessage, tokenMessage } from '../../../schema/edit-api/index.ts';
import { fits } from '../../../schema/level/index.ts';

const KEY_KEPT = 'gravity-quest-editor-key';

/** The parts of a window that are needed. */
interface KeyPage {
  readonly location: Pick<Location, 'origin' | 'port'>;
  readonly sessionStorage: Pick<Storage, 'getItem' | 'setItem'>;
  readonly crypto: Pick<Crypto, 'getRandomValues' | 'subtle'>;
  readonly fetch: typeof fetch;
}

/** What lets a tab in again after `gq edit` was restarted. */
export interface PageKey {
  /** Asks for the key of the folder, which the tab keeps. Never rejects. */
  learn(token: string): Promise<void>;
  /**
   * Asks for the token of the present run. The key is not sent, and the answer counts only if it proves that the server has it.
   * @returns null if the tab has no key, or the server has another one or none. Never rejects
   */
  renew(): Promise<string | null>;
}

const base64url = (bytes: Uint8Array): string =>
  btoa(String.fromCharCode(...bytes))
    .replaceAll('+', '-')
    .replaceAll('/', '_')
    .replaceAll('=', '');

async function sign({ crypto }: KeyPage, key: string, message: string): Promise<string> {
  const bytes = new TextEncoder();
  const algorithm = { name: 'HMAC', hash: 'SHA-256' };
  const imported = await crypto.subtle.importKey('raw', bytes.encode(key), algorithm, false, ['sign']);
  return base64url(new Uint8Array(await crypto.subtle.sign('HMAC', imported, bytes.encode(message))));
}

const portOf = ({ port }: KeyPage['location']): number => (port === '' ? 80 : Number(port));

export function createPageKey(page: KeyPage): PageKey {
  const { location, crypto, fetch } = page;
  const get = async (path: string, headers: Record<string, string>): Promise<unknown> => {
    const response = await fetch(`${location.origin}${path}`, { headers, cache: 'no-store' });
    return response.ok ? await response.json() : null;
  };
  const known = (): string | null => {
    try {
      return page.sessionStorage.getItem(KEY_KEPT);
    } catch {
      return null;
    }
  };
  const renew = async (): Promise<string | null> => {
    const key = known();
    if (key === null) return null;
    const challenge = base64url(crypto.getRandomValues(new Uint8Array(32)));
    const run = await get(`${EDIT_API.RUN}?challenge=${challenge}`, {});
    if (!fits(run, RUN_RESPONSE)) return null;
    const { nonce, proof } = run;
    if (proof !== (await sign(page, key, runMessage(portOf(location), challenge, nonce)))) return null;
    const token = await sign(page, key, tokenMessage(nonce));
    keepToken(page, token);
    return token;
  };
  return {
    async learn(token) {
      try {
        const answer = await get(EDIT_API.KEY, { [EDIT_API.TOKEN_HEADER]: token });
        if (fits(answer, KEY_RESPONSE)) page.sessionStorage.setItem(KEY_KEPT, answer.key);
      } catch {
        // the tab stores nothing, or the server does not answer: it says after a restart what to open
      }
    },
    renew: () => renew().catch(() => null),
  };
}

const TOKEN_KEPT = 'gravity-quest-editor-token';
const PART = 'token';

/** Hosts that `gq edit` listens on, and the paths of its page. */
const HOSTS = ['127.0.0.1', 'localhost'];
const PATHS = ['/', '/index.html'];

/** The parts of a window that are needed. */
export interface TokenPage {
  readonly location: Pick<Location, 'protocol' | 'hostname' | 'pathname' | 'search' | 'hash'>;
  readonly history: Pick<History, 'replaceState' | 'state'>;
  readonly sessionStorage: Pick<Storage, 'getItem' | 'setItem'>;
}

/** Whether `gq edit` may have served the page. Elsewhere, a token in the address must not hide the levels of this browser. */
export const mayBeServed = ({ location }: Pick<TokenPage, 'location'>): boolean =>
  location.protocol === 'http:' && HOSTS.includes(location.hostname) && PATHS.includes(location.pathname);

/** The token in the address of a page; '' if there is none. */
const tokenIn = ({ hash }: Pick<Location, 'hash'>): string =>
  partsOf(hash)
    .find((part) => part.startsWith(`${PART}=`))
    ?.slice(PART.length + 1) ?? '';

const partsOf = (hash: string): string[] => hash.replace(/^#/, '').split('&');

/** Keeps the token of a later run for this tab, so that the page can be reloaded. */
function keepToken({ sessionStorage }: Pick<TokenPage, 'sessionStorage'>, token: string): void {
  try {
    sessionStorage.setItem(TOKEN_KEPT, token);
  } catch {
    // a tab that stores nothing is reloaded from the address
  }
}

/** Whether the address has a token that this tab does not know yet: another start of `gq edit` has printed the address. */
export function isOtherToken(page: Omit<TokenPage, 'history'>): boolean {
  const given = tokenIn(page.location);
  if (given === '' || !mayBeServed(page)) return false;
  try {
    return page.sessionStorage.getItem(TOKEN_KEPT) !== given;
  } catch {
    return true;
  }
}

/**
 * Takes the token from the address that `gq edit` prints. It is removed from the address, so that no bookmark, screenshot or
 * history contains it, and kept for this tab only, so that the page can be reloaded. If the tab can't store it, it stays in the
 * address.
 * @returns null if the page was opened without a token
 */
export function takeToken(page: TokenPage): string | null {
  if (!mayBeServed(page)) return null;
  const { pathname, search, hash } = page.location;
  const given = tokenIn(page.location);
  try {
    if (given === '') return page.sessionStorage.getItem(TOKEN_KEPT);
    page.sessionStorage.setItem(TOKEN_KEPT, given);
    if (page.sessionStorage.getItem(TOKEN_KEPT) !== given) return given;
  } catch {
    return given === '' ? null : given;
  }
  const rest = partsOf(hash)
    .filter((part) => !part.startsWith(`${PART}=`))
    .join('&');
  page.history.replaceState(page.history.state, '', `${pathname}${search}${rest === '' ? '' : `#${rest}`}`);
  return given;
}
