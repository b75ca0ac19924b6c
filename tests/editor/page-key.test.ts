import { webcrypto } from 'node:crypto';
import { describe, expect, it } from 'vitest';
import { createAccess, newKey } from '../../cli/serve/access.ts';
import { NO_FOLDER_TERMS } from '../../editor/core/files/folder-list.ts';
import { createPageKey } from '../../editor/core/files/page-access.ts';
import { createServerStorage } from '../../editor/core/files/server-storage.ts';
import { EDIT_API, type ListResponse } from '../../schema/index.ts';
import { TurnedClock } from './stage.ts';

const ORIGIN = 'http://127.0.0.1:4747';
const LIST: ListResponse = {
  folder: { id: 'f', path: 'levels', $schema: null },
  folders: [''],
  levels: [],
  unread: 0,
  terms: NO_FOLDER_TERMS,
  troubles: [],
};

/** What listens on the port: a run of `gq edit`, or something else. */
type Listener = (path: string, token: string | undefined) => { readonly status: number; readonly body: unknown };

const refusal = { error: { code: 'wrong-token', message: 'this page belongs to another run of gq edit', hint: 'Open it.' } };

/** A run that knows a key. @param port it says that it listens on */
function runOf(key: string, port = 4747): Listener & { readonly token: string } {
  const access = createAccess(key);
  const answer: Listener = (path, token) => {
    if (path.startsWith(EDIT_API.RUN)) return { status: 200, body: access.run(port, path.split('challenge=')[1]) };
    if (token !== access.token) return { status: 401, body: refusal };
    return { status: 200, body: path === EDIT_API.KEY ? { key: access.key } : LIST };
  };
  return Object.assign(answer, { token: access.token });
}

/** A tab, and all that it has sent to what listens now. */
function tab(first: Listener & { readonly token: string }, { stores = true } = {}) {
  const kept = new Map<string, string>();
  let listener: Listener = first;
  let sent: string[] = [];
  const fetchIt = (async (address: string, init?: RequestInit) => {
    const path = String(address).slice(ORIGIN.length);
    const headers = (init?.headers ?? {}) as Record<string, string>;
    sent.push(path, JSON.stringify(headers));
    const { status, body } = listener(path, headers[EDIT_API.TOKEN_HEADER]);
    return new Response(JSON.stringify(body), { status });
  }) as typeof fetch;
  const key = createPageKey({
    location: { origin: ORIGIN, port: '4747' },
    crypto: webcrypto as unknown as Crypto,
    fetch: fetchIt,
    sessionStorage: {
      getItem: (name) => kept.get(name) ?? null,
      setItem(name, value) {
        if (!stores) throw new DOMException('no', 'QuotaExceededError');
        kept.set(name, value);
      },
    },
  });
  const timers = new TurnedClock();
  const storage = createServerStorage({ origin: ORIGIN, token: first.token, key, client: 'page-1', fetch: fetchIt, timers });
  return {
    key,
    storage,
    kept,
    sent: () => sent.join('\n'),
    listen(next: Listener) {
      listener = next;
      sent = [];
    },
  };
}

describe('a tab of an earlier run', () => {
  it('gets the token of the present one, which it keeps, and sends its request again', async () => {
    const secret = newKey();
    const first = runOf(secret);
    const { key, storage, kept, listen, sent } = tab(first);
    await key.learn(first.token);
    for (let i = 0; i < 3; i++) {
      const next = runOf(secret);
      listen(next);
      // several requests at once ask once
      const answers = await Promise.all([storage.list(), storage.list(), storage.list()]);
      expect(answers.map(({ ok }) => ok)).toEqual([true, true, true]);
      expect([...kept.values()]).toContain(next.token);
      expect(sent()).not.toContain(secret);
    }
  });

  it('tells nobody its key or a token that works, and asks for the new address, where the key is not the same', async () => {
    const secret = newKey();
    const first = runOf(secret);
    const next = runOf(secret, 5000);
    const impostors: Record<string, Listener> = {
      'another key': runOf(newKey()),
      'a guess': (path) =>
        path.startsWith(EDIT_API.RUN)
          ? { status: 200, body: { nonce: 'n'.repeat(22), proof: 'p'.repeat(43) } }
          : { status: 401, body: refusal },
      // another program has taken the port, and passes the question on to gq edit, which now listens on another one
      'a relay': next,
      'no answer': () => ({ status: 404, body: {} }),
      nonsense: () => ({ status: 401, body: refusal }),
    };
    for (const [name, impostor] of Object.entries(impostors)) {
      const { key, storage, listen, sent } = tab(first);
      await key.learn(first.token);
      listen(impostor);
      const answer = await storage.list();
      expect([name, answer.ok]).toEqual([name, false]);
      if (name !== 'no answer')
        expect(answer).toMatchObject({ error: { code: 'wrong-token', hint: expect.stringMatching(/Open the address/) } });
      expect(sent()).not.toContain(secret);
      expect(sent()).not.toContain(next.token);
    }
  });

  it('says what to open where the browser stores nothing for the tab', async () => {
    const secret = newKey();
    const first = runOf(secret);
    const { key, storage, listen } = tab(first, { stores: false });
    await key.learn(first.token);
    expect(await storage.list()).toMatchObject({ ok: true });
    listen(runOf(secret));
    expect(await storage.list()).toMatchObject({ ok: false, error: { code: 'wrong-token' } });
  });
});
