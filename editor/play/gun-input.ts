/** The input that holds the gun in a playtest. */
export interface GunInput {
  /** Whether the gun is held now; a press shorter than a frame counts once. */
  read(): boolean;
  stop(): void;
}

const isOnButton = ({ target }: Event): boolean => target instanceof Element && target.closest('button') !== null;

/**
 * Reads mouse, touch or a key as the gun.
 * @param element where presses of the pointer count
 * @param key `KeyboardEvent.code`; Space also works
 */
export function listenToGun(page: Window, element: HTMLElement, key: () => string): GunInput {
  const held = new Set<string>();
  let tapped = false;
  const stopping = new AbortController();
  const options = { signal: stopping.signal };
  const press = (source: string) => {
    held.add(source);
    tapped = true;
  };
  const isGun = (event: KeyboardEvent) => event.code === key() || event.code === 'Space';

  element.addEventListener(
    'pointerdown',
    (event) => {
      if (event.button !== 0) return;
      // Capturing the pointer would take the click away from the button.
      if (isOnButton(event)) return;
      event.preventDefault();
      element.setPointerCapture(event.pointerId);
      press(`pointer ${event.pointerId}`);
    },
    options,
  );
  for (const type of ['pointerup', 'pointercancel'] as const) {
    element.addEventListener(type, (event) => held.delete(`pointer ${event.pointerId}`), options);
  }
  page.addEventListener(
    'keydown',
    (event) => {
      if (!isGun(event)) return;
      // These keys press a focused button.
      if ((event.key === ' ' || event.key === 'Enter') && isOnButton(event)) return;
      event.preventDefault();
      if (!event.repeat) press(event.code);
    },
    options,
  );
  page.addEventListener('keyup', (event) => held.delete(event.code), options);
  page.addEventListener('blur', () => held.clear(), options);
  return {
    read() {
      const now = held.size > 0 || tapped;
      tapped = false;
      return now;
    },
    stop: () => stopping.abort(),
  };
}
