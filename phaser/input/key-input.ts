import type { Held } from './held.ts';

/** Elements that use keys themselves while they have the focus. */
const USES_KEYS = 'input, textarea, select, button, a[href], summary, [contenteditable]';

const usesKeys = (target: EventTarget | null): boolean =>
  target !== null && 'closest' in target && (target as Element).closest(USES_KEYS) !== null;

/**
 * Listens to keys. They come from the page, as Phaser hands an event to one game of a page only, and none to a paused scene, so
 * that a release would be missed.
 *
 * @param listens whether a press counts now
 * @returns ends it
 */
export function listenToKeys(codes: readonly string[], held: Held, listens: () => boolean): () => void {
  const onDown = (event: KeyboardEvent) => {
    const { code, repeat, ctrlKey, altKey, metaKey, target } = event;
    if (!codes.includes(code) || ctrlKey || altKey || metaKey || !listens() || usesKeys(target)) return;
    // the page would scroll
    event.preventDefault();
    if (!repeat) held.press(code);
  };
  const onUp = ({ code, key }: KeyboardEvent) => {
    held.release(code);
    // macOS does not report the release of a key while Command is held
    if (key === 'Meta') for (const one of codes) held.release(one);
  };
  window.addEventListener('keydown', onDown);
  window.addEventListener('keyup', onUp);
  return () => {
    window.removeEventListener('keydown', onDown);
    window.removeEventListener('keyup', onUp);
  };
}
