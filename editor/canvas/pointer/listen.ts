import { type Point, panBy, toLevel, type View, zoomAt } from '../view.ts';
import { enterGroup } from './click.ts';
import { PointerMachine } from './pointer-machine.ts';
import { hasMoved, type PointerContext, type PointerInput } from './state.ts';

const MODIFIERS: readonly string[] = ['Shift', 'Alt', 'Control', 'Meta'];

export interface PointerListening {
  /** The keyboard in place of the pointer: it presses, moves and releases through the same states. */
  readonly keys: {
    /** @param onCancel called when the drag is cancelled instead of ended */
    press(input: PointerInput, onCancel: () => void): void;
    move(input: PointerInput): void;
    release(input: PointerInput): void;
    /** Whether a drag by keys is in progress. */
    isHolding(): boolean;
  };
  /** Cancels what the pointer has begun. @returns whether there was anything */
  cancel(): boolean;
  stop(): void;
}

/**
 * Feeds mouse, pen and touch on the canvas into the pointer machine. Two fingers move and zoom the view.
 * @param enabled while false, as in a playtest, input is ignored
 */
export function listenToPointer(element: HTMLElement, context: PointerContext, enabled: () => boolean): PointerListening {
  const fingers = new Map<number, Point>();
  // Reading the canvas's position forces a layout, so it is cached while the pointer is busy, when it can't change.
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

  const long = longPress((input) => {
    machine.cancel();
    context.openMenu(input.place, input.screen);
  });
  const onDown = (event: PointerEvent) => {
    if (!enabled()) return;
    context.canvas.setState({ message: null });
    element.focus({ preventScroll: true });
    element.setPointerCapture(event.pointerId);
    if (event.pointerType === 'touch') {
      fingers.set(event.pointerId, screenOf(event));
      if (fingers.size > 1) {
        long.end();
        machine.cancel();
        return;
      }
    }
    // a drag by keys ends where it is
    machine.releaseKeys();
    if (machine.isBusy) return;
    event.preventDefault();
    const input = inputOf(event);
    machine.press(input);
    if (input.by === 'touch') long.begin(input);
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
    long.move(input);
    // no other listener needs the event
    if (machine.isBusy) event.stopPropagation();
    machine.move(input);
  };
  const onUp = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    long.end();
    if (!machine.isBusy || machine.isByKeys || !enabled()) return;
    const input = inputOf(event);
    machine.release(input);
    machine.hover(input);
  };
  const onCancel = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    long.end();
    if (!machine.isByKeys) machine.cancel();
  };
  const onLeave = () => {
    context.hovered.setState(null, true);
    context.canvas.setState({ placing: null });
  };
  const onDoubleClick = (event: MouseEvent) => {
    if (!enabled() || machine.isBusy || event.button !== 0) return;
    const screen = screenOf(event);
    enterGroup(context, { screen, place: toLevel(context.view(), screen), ...modifiersOf(event), by: 'mouse', button: 0 });
  };
  const onWheel = (event: WheelEvent) => {
    event.preventDefault();
    context.setView(wheeled(context.view(), event, () => screenOf(event)));
  };
  const onKey = (event: KeyboardEvent) => {
    // Alt, Shift or Ctrl may be held during a drag, so Escape is handled here and not as a command.
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
  element.addEventListener('dblclick', onDoubleClick, options);
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
      long.end();
      machine.cancel();
      stopping.abort();
    },
  };
}

const modifiersOf = (event: MouseEvent | KeyboardEvent): Pick<PointerInput, 'shift' | 'alt' | 'mod'> => ({
  shift: event.shiftKey,
  alt: event.altKey,
  mod: event.ctrlKey || event.metaKey,
});

/** ms that a finger must rest to open the menu */
const LONG = 500;

interface LongPress {
  begin(input: PointerInput): void;
  /** A finger that moves does something else. */
  move(input: PointerInput): void;
  end(): void;
}

/** Calls back when a finger rests where it was put down. */
function longPress(call: (input: PointerInput) => void): LongPress {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let from: PointerInput | null = null;
  const end = () => {
    clearTimeout(timer);
    from = null;
  };
  return {
    begin(input) {
      end();
      from = input;
      timer = setTimeout(() => {
        from = null;
        call(input);
      }, LONG);
    },
    move(input) {
      if (from !== null && hasMoved(from, input)) end();
    },
    end,
  };
}

/** zoom factor per px of wheel */
const WHEEL_ZOOM = 1.0015;
/** px of a wheel line, as some mice report */
const WHEEL_LINE = 16;

/** The view after two fingers have moved from two points of the screen to two others. */
function pinched(view: View, [a, b]: readonly Point[], [c, d]: readonly Point[]): View {
  const middle = (p: Point, q: Point) => ({ x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 });
  const apart = (p: Point, q: Point) => Math.max(1, Math.hypot(p.x - q.x, p.y - q.y));
  const [from, to] = [middle(a, b), middle(c, d)];
  return zoomAt(panBy(view, to.x - from.x, to.y - from.y), to, apart(c, d) / apart(a, b));
}

/**
 * The view after a turn of the wheel: zoomed at the pointer, with Shift moved sideways. @param at returns the pointer's
 * position, called only if needed
 */
function wheeled(view: View, event: WheelEvent, at: () => Point): View {
  const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? WHEEL_LINE : 1;
  if (event.shiftKey && !event.ctrlKey) return panBy(view, -(event.deltaX + event.deltaY) * unit, 0);
  // a pinch on a touchpad is reported as a wheel with Ctrl, in small steps
  const factor = WHEEL_ZOOM ** (-event.deltaY * unit * (event.ctrlKey ? 6 : 1));
  return zoomAt(view, at(), factor);
}
