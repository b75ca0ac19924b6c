/** So many places are remembered: more than lie over one another. */
const REMEMBERED = 12;

/** Where the work is: what has the keys when nothing else has them. */
const homeOf = (page: Document): HTMLElement | null =>
  page.querySelector<HTMLElement>('main :is([tabindex="0"], button:enabled)');

/** Gives the focus to the canvas; where no level is open, to the first thing that can be done instead. */
export function focusHome(): void {
  homeOf(document)?.focus({ preventScroll: true });
}

/** Whether it takes the focus without doing anything: a tab that is not in front comes to the front by it. */
const isQuiet = (element: HTMLElement): boolean =>
  element.checkVisibility() && !element.matches('[role=tab][aria-selected="false"]');

/** Whether it can not have the focus any more. */
const isGone = (element: HTMLElement): boolean =>
  !element.isConnected || element.matches(':disabled') || element.closest('[inert], [hidden]') !== null;

/**
 * Keeps the focus when what has it goes: a dialog that is closed, a row that is deleted, a button that can't be pressed any more. It goes to where it
 * was before, or to the canvas: on the page's body the next Tab begins at the top again, and a screen reader is silent.
 * @returns stops it
 */
export function keepFocus(page: Document): () => void {
  // 'home' is one place, though each level has a canvas of its own
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
    // a press on nothing in particular takes the focus away as well: that is wanted
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
