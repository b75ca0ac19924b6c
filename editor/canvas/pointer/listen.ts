import { type Point, toLevel } from '../view.ts';
import { PointerMachine } from './pointer-machine.ts';
import type { PointerContext, PointerInput } from './state.ts';
import { pinched, wheeled } from './zoom-gestures.ts';

const MODIFIERS: readonly string[] = ['Shift', 'Alt', 'Control', 'Meta'];

export interface PointerListening {
  /** A hand at the keys in place of the pointer: it presses, moves and lets go in the same states. */
  readonly keys: {
    /** @param onCancel called when it is taken back instead of let go */
    press(input: PointerInput, onCancel: () => void): void;
    move(input: PointerInput): void;
    release(input: PointerInput): void;
    /** Whether they hold something. */
    isHolding(): boolean;
  };
  /** Takes back what the pointer has begun. @returns whether there was anything */
  cancel(): boolean;
  stop(): void;
}

/**
 * Turns what mouse, pen and fingers do on the canvas into states: one at a time. Two fingers move and zoom the view.
 * @param enabled while it is false, as in a playtest, the canvas is left alone
 */
export function listenToPointer(element: HTMLElement, context: PointerContext, enabled: () => boolean): PointerListening {
  const fingers = new Map<number, Point>();
  // asking where the canvas is makes the browser lay out the page: while the pointer does something it stays where it is
  let corner: { readonly left: number; readonly top: number } | null = null;
  const machine = new PointerMachine(context, () => {
    corner = null;
  });
  const screenOf = (event: { clientX: number; clientY: number }): Point => {
    const { left, top } = corner ?? element.getBoundingClientRect();
    if (machine.isBusy) corner = { left, top };
    return { x: event.clientX - left, y: event.clientY - top };
  };
  const inputOf = (event: PointerEvent): PointerInput => {
    const screen = screenOf(event);
    return {
      screen,
      place: toLevel(context.view(), screen),
      ...modifiersOf(event),
      by: event.pointerType === 'touch' ? 'touch' : 'mouse',
      button: event.button,
    };
  };

  const onDown = (event: PointerEvent) => {
    if (!enabled()) return;
    element.focus({ preventScroll: true });
    element.setPointerCapture(event.pointerId);
    if (event.pointerType === 'touch') {
      fingers.set(event.pointerId, screenOf(event));
      if (fingers.size > 1) {
        machine.cancel();
        return;
      }
    }
    // what the keys hold stays where they have brought it
    machine.releaseKeys();
    if (machine.isBusy) return;
    event.preventDefault();
    machine.press(inputOf(event));
  };
  const onMove = (event: PointerEvent) => {
    if (!enabled()) return;
    if (fingers.size === 2 && fingers.has(event.pointerId)) {
      const before = [...fingers.values()];
      fingers.set(event.pointerId, screenOf(event));
      context.setView(pinched(context.view(), before, [...fingers.values()]));
      return;
    }
    if (machine.isByKeys) return;
    const input = inputOf(event);
    // nobody else has a use for it, and the dividers of the panels would measure the page each time
    if (machine.isBusy) event.stopPropagation();
    machine.move(input);
  };
  const onUp = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    if (!machine.isBusy || machine.isByKeys || !enabled()) return;
    const input = inputOf(event);
    machine.release(input);
    machine.hover(input);
  };
  const onCancel = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    if (!machine.isByKeys) machine.cancel();
  };
  const onLeave = () => {
    context.hovered.setState(null, true);
    context.canvas.setState({ placing: null });
  };
  const onWheel = (event: WheelEvent) => {
    event.preventDefault();
    context.setView(wheeled(context.view(), event, () => screenOf(event)));
  };
  const onKey = (event: KeyboardEvent) => {
    // with Alt, Shift or Ctrl held, as a drag may need them, it is no command's key
    const isEscape = event.key === 'Escape' && event.type === 'keydown' && !event.defaultPrevented;
    if (isEscape && machine.cancel()) event.preventDefault();
    if (MODIFIERS.includes(event.key) && machine.modify(modifiersOf(event)) && event.key === 'Alt') event.preventDefault();
  };

  const stopping = new AbortController();
  const options = { signal: stopping.signal };
  element.addEventListener('pointerdown', onDown, options);
  element.addEventListener('pointermove', onMove, options);
  element.addEventListener('pointerup', onUp, options);
  element.addEventListener('pointercancel', onCancel, options);
  element.addEventListener('pointerleave', onLeave, options);
  element.addEventListener('wheel', onWheel, { ...options, passive: false });
  element.addEventListener('contextmenu', (event) => event.preventDefault(), options);
  window.addEventListener('resize', () => (corner = null), options);
  window.addEventListener('keydown', onKey, options);
  window.addEventListener('keyup', onKey, options);
  return {
    keys: {
      press(input, onCancel) {
        if (!machine.isBusy) machine.press(input, onCancel);
      },
      move(input) {
        if (machine.isByKeys) machine.move(input);
      },
      release(input) {
        if (machine.isByKeys) machine.release(input);
      },
      isHolding: () => machine.isByKeys,
    },
    cancel: () => machine.cancel(),
    stop() {
      machine.cancel();
      stopping.abort();
    },
  };
}

const modifiersOf = (event: PointerEvent | KeyboardEvent): Pick<PointerInput, 'shift' | 'alt' | 'mod'> => ({
  shift: event.shiftKey,
  alt: event.altKey,
  mod: event.ctrlKey || event.metaKey,
});
