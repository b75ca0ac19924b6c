import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { isOtherToken, mayBeServed, type TokenPage, takeToken } from '../../editor/core/files/page-access.ts';

/** A tab on an address, which history.replaceState changes. */
function tab(address: string, { keeps = true, kept = new Map<string, string>() } = {}) {
  let url = new URL(address);
  const page: TokenPage = {
    get location() {
      return url;
    },
    history: {
      state: { of: 'others' },
      replaceState(state, _, to) {
        expect(state).toEqual({ of: 'others' });
        url = new URL(String(to), url);
      },
    },
    sessionStorage: {
      getItem(name) {
        if (!keeps) throw new DOMException('denied', 'SecurityError');
        return kept.get(name) ?? null;
      },
      setItem(name, value) {
        if (!keeps) throw new DOMException('denied', 'SecurityError');
        kept.set(name, value);
      },
    },
  };
  return { page, kept, address: () => url.href };
}

const ROOT = 'http://127.0.0.1:4747/';

describe('the token of gq edit', () => {
  it('is removed from the address, and is still known after a reload', () => {
    const first = tab(`${ROOT}?a=b#token=abc-_123`);
    expect(takeToken(first.page)).toBe('abc-_123');
    expect(first.address()).toBe(`${ROOT}?a=b`);
    expect(takeToken(tab(ROOT, { kept: first.kept }).page)).toBe('abc-_123');
    // the address that the next run prints
    expect(takeToken(tab(`${ROOT}#token=next`, { kept: first.kept }).page)).toBe('next');
    expect(takeToken(tab(ROOT, { kept: first.kept }).page)).toBe('next');
  });

  it('leaves the rest of the fragment', () => {
    fc.assert(
      fc.property(
        fc.stringMatching(/^[\w-]{1,40}$/),
        fc.array(fc.stringMatching(/^[a-s]{1,5}=[\w-]{0,20}$/)),
        fc.nat(),
        (token, others, at) => {
          const parts = [...others];
          parts.splice(at % (others.length + 1), 0, `token=${token}`);
          const { page, address } = tab(`${ROOT}#${parts.join('&')}`);
          expect(takeToken(page)).toBe(token);
          expect(address()).toBe(others.length === 0 ? ROOT : `${ROOT}#${others.join('&')}`);
        },
      ),
    );
  });

  it('stays in the address if the tab can not store it, so that a reload works', () => {
    const { page, address } = tab(`${ROOT}#token=abc`, { keeps: false });
    expect(takeToken(page)).toBe('abc');
    expect(address()).toBe(`${ROOT}#token=abc`);
    expect(takeToken(tab(ROOT, { keeps: false }).page)).toBeNull();
  });

  it.each([
    'https://example.org/#token=abc',
    'https://127.0.0.1:4747/#token=abc',
    'http://127.0.0.1:8000/game/#token=abc',
    'http://example.org/#token=abc',
  ])('is null on a page that gq edit does not serve: %s', (address) => {
    const { page, kept, address: now } = tab(address);
    expect(mayBeServed(page)).toBe(false);
    expect(takeToken(page)).toBeNull();
    expect(kept.size).toBe(0);
    expect(now()).toBe(address);
  });

  it('is another one if the address has one that the tab does not know', () => {
    const { page, kept } = tab(`${ROOT}#token=abc`);
    expect(isOtherToken(page)).toBe(true);
    takeToken(page);
    expect(isOtherToken(page)).toBe(false);
    const isOther = (address: string) => isOtherToken(tab(address, { kept }).page);
    expect(isOther(`${ROOT}#level=07&token=abc`)).toBe(false);
    expect(isOther(`${ROOT}#level=07&token=next`)).toBe(true);
    expect(isOther(`${ROOT}#level=07`)).toBe(false);
    expect(isOther(`${ROOT}#token=`)).toBe(false);
    // a page that gq edit does not serve
    expect(isOther('https://example.org/#token=next')).toBe(false);
    expect(isOtherToken(tab(`${ROOT}#token=abc`, { keeps: false }).page)).toBe(true);
  });

  it('is null in a tab without one', () => {
    expect(takeToken(tab(ROOT).page)).toBeNull();
    expect(takeToken(tab(`${ROOT}#token=`).page)).toBeNull();
    expect(takeToken(tab(`${ROOT}#level=abc`).page)).toBeNull();
  });
});
