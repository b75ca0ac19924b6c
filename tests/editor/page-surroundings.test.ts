import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { pageSurroundings } from '../../editor/core/files/index.ts';

// A page whose database is refused; the browser tests cover pages with a database.

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  vi.stubGlobal('indexedDB', {
    open() {
      throw new DOMException('denied', 'SecurityError');
    },
  });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** A tab on an address whose server answers with a status; null: no answer. */
function windowOn(address: string, status: number | null, kept: string | null = null) {
  const asked: { path: string; token: string | null }[] = [];
  const page = {
    location: new URL(address),
    history: { state: null, replaceState: () => {} },
    sessionStorage: { getItem: () => kept, setItem: () => {} },
    navigator: {},
    fetch(path: string, init?: RequestInit) {
      asked.push({ path, token: new Headers(init?.headers).get('x-gq-token') });
      if (status === null) return Promise.reject(new TypeError('failed'));
      return Promise.resolve(new Response('{}', { status }));
    },
  };
  return { page: page as unknown as Window, asked };
}
const text = JSON.stringify({ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } });

describe('a page', () => {
  it('that gq edit has not served has the levels of its browser, and only its own ones without a database', async () => {
    for (const [address, status] of [
      ['https://example.org/', 200],
      ['https://example.org/', 401],
      ['http://127.0.0.1:4747/', 200],
      ['http://127.0.0.1:4747/', 404],
      ['http://127.0.0.1:4747/', null],
    ] as const) {
      const { page, asked } = windowOn(address, status);
      const { storage, lateLevels, locks, journal } = await pageSurroundings(page);
      expect([storage.kind, storage.lasts, lateLevels === null, locks]).toEqual(['browser', false, false, null]);
      expect(asked).toEqual(address.startsWith('http:') ? [{ path: '/api/levels', token: null }] : []);
      expect(await storage.write('07', text, null)).toMatchObject({ ok: true });
      expect(await storage.write('08', text, null)).toMatchObject({ ok: true });
      expect(await storage.list()).toMatchObject({ ok: true, value: { levels: [{ id: '07' }, { id: '08' }] } });
      expect(journal.state.getState().kind).toBe('missing');
    }
  });

  it('that gq edit has served has the levels of its folder, or reports that the token is missing', async () => {
    const given = windowOn('http://127.0.0.1:4747/#token=secret', 500, 'secret');
    const { storage, lateLevels } = await pageSurroundings(given.page);
    expect([storage.kind, storage.lasts, lateLevels]).toEqual(['server', true, null]);
    expect(given.asked).toEqual([]);
    expect(await storage.list()).toMatchObject({ ok: false, error: { code: 'unexpected' } });
    expect(given.asked).toEqual([{ path: 'http://127.0.0.1:4747/api/levels', token: 'secret' }]);

    const bare = windowOn('http://127.0.0.1:4747/', 401);
    expect((await pageSurroundings(bare.page)).storage.kind).toBe('server');
    expect(bare.asked).toEqual([{ path: '/api/levels', token: null }]);
  });
});
