const KEPT = 'gravity-quest-editor-token';
const PART = 'token';

/** Hosts that `gq edit` listens on, and the addresses of its page. */
const HOSTS = ['127.0.0.1', 'localhost'];
const PATHS = ['/', '/index.html'];

/** What of a window is needed. */
export interface TokenPage {
  readonly location: Pick<Location, 'protocol' | 'hostname' | 'pathname' | 'search' | 'hash'>;
  readonly history: Pick<History, 'replaceState' | 'state'>;
  readonly sessionStorage: Pick<Storage, 'getItem' | 'setItem'>;
}

/** Whether `gq edit` may have served the page: elsewhere a token in the address is somebody's joke, and would hide the levels of this browser. */
export const mayBeServed = ({ location }: Pick<TokenPage, 'location'>): boolean =>
  location.protocol === 'http:' && HOSTS.includes(location.hostname) && PATHS.includes(location.pathname);

/**
 * The token in the address that `gq edit` prints. It is taken out of the address, so that no bookmark, no picture of the screen and no list of pages has
 * it, and is kept for this tab alone, so that the page can be loaded anew; where the tab keeps nothing the address keeps it.
 * @returns null: the page was opened without one
 */
export function takeToken(page: TokenPage): string | null {
  if (!mayBeServed(page)) return null;
  const { pathname, search, hash } = page.location;
  const parts = hash.replace(/^#/, '').split('&');
  const given = parts.find((part) => part.startsWith(`${PART}=`))?.slice(PART.length + 1) ?? '';
  try {
    if (given === '') return page.sessionStorage.getItem(KEPT);
    page.sessionStorage.setItem(KEPT, given);
    if (page.sessionStorage.getItem(KEPT) !== given) return given;
  } catch {
    return given === '' ? null : given;
  }
  const rest = parts.filter((part) => !part.startsWith(`${PART}=`)).join('&');
  page.history.replaceState(page.history.state, '', `${pathname}${search}${rest === '' ? '' : `#${rest}`}`);
  return given;
}
