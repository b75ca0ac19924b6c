import { EDIT_API, keyResponseSchema, runMessage, runResponseSchema, tokenMessage } from '../../../schema/index.ts';
import { keepToken } from './page-token.ts';

const KEPT = 'gravity-quest-editor-key';

/** The parts of a window that are needed. */
export interface KeyPage {
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
      return page.sessionStorage.getItem(KEPT);
    } catch {
      return null;
    }
  };
  const renew = async (): Promise<string | null> => {
    const key = known();
    if (key === null) return null;
    const challenge = base64url(crypto.getRandomValues(new Uint8Array(32)));
    const run = runResponseSchema.safeParse(await get(`${EDIT_API.RUN}?challenge=${challenge}`, {}));
    if (!run.success) return null;
    const { nonce, proof } = run.data;
    if (proof !== (await sign(page, key, runMessage(portOf(location), challenge, nonce)))) return null;
    const token = await sign(page, key, tokenMessage(nonce));
    keepToken(page, token);
    return token;
  };
  return {
    async learn(token) {
      try {
        const answer = keyResponseSchema.safeParse(await get(EDIT_API.KEY, { [EDIT_API.TOKEN_HEADER]: token }));
        if (answer.success) page.sessionStorage.setItem(KEPT, answer.data.key);
      } catch {
        // the tab stores nothing, or the server does not answer: it says after a restart what to open
      }
    },
    renew: () => renew().catch(() => null),
  };
}
