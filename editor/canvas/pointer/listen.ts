import { type Point, panBy, toLevel, zoomAt } from '../view.ts';
import { placeFor } from './place-object.ts';
import { hovered, pressed } from './press.ts';
import type { PointerContext, PointerInput, PointerState } from './state.ts';

/** Zoom by one px of wheel. */
const WHEEL_ZOOM = 1.0015;
/** A line of wheel as some mice report it, px. */
const WHEEL_LINE = 16;

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
  let state: PointerState | null = null;
  let last: PointerInput | null = null;
  let cancelled: (() => void) | null = null;
  const fingers = new Map<number, Point>();
  const stopping = new AbortController();
  const options = { signal: stopping.signal };

  // asking where the canvas is makes the browser lay out the page: while the pointer does something it stays where it is
  let corner: { readonly left: number; readonly top: number } | null = null;
  const screenOf = (event: { clientX: number; clientY: number }): Point => {
    const { left, top } = corner ?? element.getBoundingClientRect();
    if (state !== null) corner = { left, top };
    return { x: event.clientX - left, y: event.clientY - top };
  };
  const inputOf = (event: PointerEvent): PointerInput => {
    const screen = screenOf(event);
    return {
      screen,
      place: toLevel(context.view(), screen),
      shift: event.shiftKey,
      alt: event.altKey,
      mod: event.ctrlKey || event.metaKey,
      by: event.pointerType === 'touch' ? 'touch' : 'mouse',
      button: event.button,
    };
  };
  const hover = (input: PointerInput) => {
    const { key, cursor } = hovered(context, input);
    const tool = context.tool();
    const placing = tool === 'select' || tool === 'hand' || input.by === 'touch' ? null : placeFor(context, input);
    context.hovered.setState(key, true);
    context.canvas.setState({ cursor, placing });
  };
  const enter = (next: PointerState | null) => {
    state = next;
    if (next === null) {
      corner = null;
      return;
    }
    context.hovered.setState(null, true);
    context.canvas.setState({ cursor: next.cursor, placing: null });
  };
  const follow = (input: PointerInput) => {
    let next = state?.move?.(input);
    // a drag that has just begun is to follow this very move
    while (next !== undefined) {
      enter(next);
      next = next.move?.(input);
    }
  };
  const letGo = (input: PointerInput) => enter(state?.up?.(input) ?? null);
  const byKeys = () => state !== null && last?.by === 'keys';
  const cancel = () => {
    const was = state;
    const tell = byKeys() ? cancelled : null;
    enter(null);
    was?.cancel();
    tell?.();
    return was !== null;
  };

  const onDown = (event: PointerEvent) => {
    if (!enabled()) return;
    element.focus({ preventScroll: true });
    element.setPointerCapture(event.pointerId);
    if (event.pointerType === 'touch') {
      fingers.set(event.pointerId, screenOf(event));
      if (fingers.size > 1) {
        cancel();
        return;
      }
    }
    // what the keys hold stays where they have brought it
    if (byKeys() && last !== null) letGo(last);
    if (state !== null) return;
    event.preventDefault();
    last = inputOf(event);
    enter(pressed(context, last));
  };
  const onMove = (event: PointerEvent) => {
    if (!enabled()) return;
    if (fingers.size === 2 && fingers.has(event.pointerId)) {
      const [a, b] = [...fingers.values()];
      fingers.set(event.pointerId, screenOf(event));
      const [c, d] = [...fingers.values()];
      const middle = (p: Point, q: Point) => ({ x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 });
      const apart = (p: Point, q: Point) => Math.max(1, Math.hypot(p.x - q.x, p.y - q.y));
      const [from, to] = [middle(a, b), middle(c, d)];
      context.setView(zoomAt(panBy(context.view(), to.x - from.x, to.y - from.y), to, apart(c, d) / apart(a, b)));
      return;
    }
    if (byKeys()) return;
    last = inputOf(event);
    if (state === null) hover(last);
    else {
      // nobody else has a use for it, and the dividers of the panels would measure the page each time
      event.stopPropagation();
      follow(last);
    }
  };
  const onUp = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    if (state === null || byKeys() || !enabled()) return;
    last = inputOf(event);
    letGo(last);
    hover(last);
  };
  const onCancel = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    if (!byKeys()) cancel();
  };
  const onLeave = () => {
    context.hovered.setState(null, true);
    context.canvas.setState({ placing: null });
  };
  const onWheel = (event: WheelEvent) => {
    event.preventDefault();
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? WHEEL_LINE : 1;
    if (event.shiftKey && !event.ctrlKey) {
      context.setView(panBy(context.view(), -(event.deltaX + event.deltaY) * unit, 0));
      return;
    }
    // a pinch on a touchpad comes as a wheel with Ctrl, in small steps
    const factor = WHEEL_ZOOM ** (-event.deltaY * unit * (event.ctrlKey ? 6 : 1));
    context.setView(zoomAt(context.view(), screenOf(event), factor));
  };
  const onKey = (event: KeyboardEvent) => {
    // with Alt, Shift or Ctrl held, as a drag may need them, it is no command's key
    if (event.key === 'Escape' && event.type === 'keydown' && !event.defaultPrevented && cancel()) event.preventDefault();
    // modifiers change what a drag does before the pointer moves again
    if (last === null || state === null || byKeys() || !['Shift', 'Alt', 'Control', 'Meta'].includes(event.key)) return;
    if (event.key === 'Alt') event.preventDefault();
    last = { ...last, shift: event.shiftKey, alt: event.altKey, mod: event.ctrlKey || event.metaKey };
    state.move?.(last);
  };

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
        if (state !== null) return;
        last = input;
        cancelled = onCancel;
        enter(pressed(context, input));
      },
      move(input) {
        if (!byKeys()) return;
        last = input;
        follow(input);
      },
      release(input) {
        if (!byKeys()) return;
        last = input;
        letGo(input);
      },
      isHolding: byKeys,
    },
    cancel,
    stop() {
      cancel();
      stopping.abort();
    },
  };
}
