import { followGamepads } from '../../core/commands/index.ts';

/** What the button of the gun does: a player, or what stands for one. */
export interface GunButton {
  press(): void;
  release(): void;
}

/** The input that holds the gun in a playtest. */
export interface GunInput {
  /** Whether a pointer, a key or a gamepad holds the gun now. */
  isHeld(): boolean;
  stop(): void;
}

const isOnButton = ({ target }: Event): boolean => target instanceof Element && target.closest('button') !== null;

/**
 * Reads mouse, touch, a key or a gamepad as the gun.
 * @param element where presses of the pointer count
 * @param key `KeyboardEvent.code`; Space also works
 * @param button pressed by the first pointer, key or button that is down, released when the last one is up
 */
export function listenToGun(page: Window, element: HTMLElement, key: () => string, button: GunButton): GunInput {
  const held = new Set<string>();
  const stopping = new AbortController();
  const options = { signal: stopping.signal };
  const press = (source: string) => {
    held.add(source);
    button.press();
  };
  const release = (source: string) => {
    if (held.delete(source) && held.size === 0) button.release();
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
    element.addEventListener(type, (event) => release(`pointer ${event.pointerId}`), options);
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
  page.addEventListener('keyup', (event) => release(event.code), options);
  page.addEventListener(
    'blur',
    () => {
      held.clear();
      button.release();
    },
    options,
  );
  const leavePads = followGamepads(page, ({ source, isDown, holdsGun }) => {
    // a press on a focused button is not for the gun
    if (isDown && holdsGun && !(page.document.activeElement instanceof HTMLButtonElement)) press(source);
    if (!isDown) release(source);
  });
  return {
    isHeld: () => held.size > 0,
    stop() {
      stopping.abort();
      leavePads();
    },
  };
}
