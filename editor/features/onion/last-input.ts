/** The last input anywhere on the page: a key, or the pointer and where it was, px of the page. */
export type Input = { readonly by: 'keys' } | { readonly by: 'mouse' | 'touch'; readonly x: number; readonly y: number };

let last: Input = { by: 'keys' };

export const lastInput = (): Input => last;

/** Follows the input until aborted. */
export function followInput(signal: AbortSignal): void {
  // before other listeners, as some of them stop the event
  const options = { capture: true, passive: true, signal };
  const onPointer = ({ clientX: x, clientY: y, pointerType }: PointerEvent) => {
    last = { by: pointerType === 'touch' ? 'touch' : 'mouse', x, y };
  };
  const onKey = () => {
    last = { by: 'keys' };
  };
  window.addEventListener('pointerdown', onPointer, options);
  // a drag goes on while a modifier is pressed, and a mouse that is moved without a button changes nothing
  window.addEventListener('pointermove', (event) => event.buttons !== 0 && onPointer(event), options);
  window.addEventListener('keydown', onKey, options);
}
