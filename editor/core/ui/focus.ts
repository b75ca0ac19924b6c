/** number of remembered places, more than are ever stacked */
const REMEMBERED = 12;

/** The home of the focus: the canvas, or a replacement. */
const homeOf = (page: Document): HTMLElement | null =>
  page.querySelector<HTMLElement>('main :is([tabindex="0"], button:enabled)');

/** Focuses the canvas; if no level is open, the first usable button instead. */
export function focusHome(): void {
  homeOf(document)?.focus({ preventScroll: true });
}

/** Whether focusing has no side effect; focusing a tab that is not in front would select it. */
const isQuiet = (element: HTMLElement): boolean =>
  element.checkVisibility() && !element.matches('[role=tab][aria-selected="false"]');

/** Whether it can no longer have the focus. */
const isGone = (element: HTMLElement): boolean =>
  !element.isConnected || element.matches(':disabled') || element.closest('[inert], [hidden]') !== null;

/**
 * Restores the focus when its element disappears: a dialog is closed, a row is deleted, a button is disabled. The focus goes to
 * where it was before, or to the canvas. On the page's body, the next Tab would start at the top, and screen readers would be
 * silent.
 * @returns stops it
 */
export function keepFocus(page: Document): () => void {
  // 'home' is one place, although each level has its own canvas
  let places: readonly (HTMLElement | 'home')[] = [];
  let last: HTMLElement | null = null;
  const onFocus = ({ target }: FocusEvent) => {
    if (!(target instanceof HTMLElement)) return;
    last = target;
    const place: HTMLElement | 'home' = target === homeOf(page) ? 'home' : target;
    places = [place, ...places.filter((other) => other !== place && (other === 'home' || other.isConnected))].slice(
      0,
      REMEMBERED,
    );
  };
  const look = () => {
    const now = page.activeElement;
    // Clicking on empty space also removes the focus, which is intended.
    if (last === null || (now !== page.body && now !== last) || !isGone(last)) return;
    last = null;
    const place = places.find((other) => other === 'home' || (!isGone(other) && isQuiet(other))) ?? 'home';
    const element = place === 'home' ? homeOf(page) : place;
    element?.focus({ preventScroll: true });
  };
  page.addEventListener('focusin', onFocus);
  const observer = new MutationObserver(look);
  observer.observe(page.body, { subtree: true, childList: true, attributeFilter: ['disabled', 'hidden', 'inert'] });
  return () => {
    page.removeEventListener('focusin', onFocus);
    observer.disconnect();
  };
}
