const KEPT = 'gravity-quest-editor-token';
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
export function keepToken({ sessionStorage }: Pick<TokenPage, 'sessionStorage'>, token: string): void {
  try {
    sessionStorage.setItem(KEPT, token);
  } catch {
    // a tab that stores nothing is reloaded from the address
  }
}

/** Whether the address has a token that this tab does not know yet: another start of `gq edit` has printed the address. */
export function isOtherToken(page: Omit<TokenPage, 'history'>): boolean {
  const given = tokenIn(page.location);
  if (given === '' || !mayBeServed(page)) return false;
  try {
    return page.sessionStorage.getItem(KEPT) !== given;
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
    if (given === '') return page.sessionStorage.getItem(KEPT);
    page.sessionStorage.setItem(KEPT, given);
    if (page.sessionStorage.getItem(KEPT) !== given) return given;
  } catch {
    return given === '' ? null : given;
  }
  const rest = partsOf(hash)
    .filter((part) => !part.startsWith(`${PART}=`))
    .join('&');
  page.history.replaceState(page.history.state, '', `${pathname}${search}${rest === '' ? '' : `#${rest}`}`);
  return given;
}
