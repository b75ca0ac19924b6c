import { placeFor } from './place-object.ts';
import { hovered, pressed } from './press.ts';
import type { PointerContext, PointerInput, PointerState } from './state.ts';

/** What the pointer, or the keyboard in its place, is doing on the canvas: one thing at a time. */
export class PointerMachine {
  private state: PointerState | null = null;
  private last: PointerInput | null = null;
  private cancelled: (() => void) | null = null;

  /** @param onIdle called whenever the machine becomes idle */
  constructor(
    private readonly context: PointerContext,
    private readonly onIdle: () => void,
  ) {}

  get isBusy(): boolean {
    return this.state !== null;
  }

  /** Whether a drag by keys is in progress. */
  get isByKeys(): boolean {
    return this.state !== null && this.last?.by === 'keys';
  }

  /** Called when the pointer moves without doing anything. */
  hover(input: PointerInput): void {
    const { context } = this;
    const { key, cursor } = hovered(context, input);
    const tool = context.tool();
    const placing = tool === 'select' || tool === 'hand' || input.by === 'touch' ? null : placeFor(context, input);
    context.hovered.setState(key, true);
    context.canvas.setState({ cursor, placing });
  }

  /** Begins something. @param onCancel for keys: called when it is cancelled instead of ended */
  press(input: PointerInput, onCancel: (() => void) | null = null): void {
    this.last = input;
    if (onCancel !== null) this.cancelled = onCancel;
    this.enter(pressed(this.context, input));
  }

  move(input: PointerInput): void {
    this.last = input;
    if (this.state === null) this.hover(input);
    else this.follow(input);
  }

  release(input: PointerInput): void {
    this.last = input;
    this.letGo(input);
  }

  /** Ends a drag by keys where it is. */
  releaseKeys(): void {
    if (this.isByKeys && this.last !== null) this.letGo(this.last);
  }

  /** A change of modifiers affects a drag before the pointer moves again. @returns whether there is a drag */
  modify(modifiers: Pick<PointerInput, 'shift' | 'alt' | 'mod'>): boolean {
    if (this.last === null || this.state === null || this.isByKeys) return false;
    this.last = { ...this.last, ...modifiers };
    this.state.move?.(this.last);
    return true;
  }

  /** Cancels what was begun. @returns whether there was anything */
  cancel(): boolean {
    const was = this.state;
    const tell = this.isByKeys ? this.cancelled : null;
    this.enter(null);
    was?.cancel();
    tell?.();
    return was !== null;
  }

  private follow(input: PointerInput): void {
    let next = this.state?.move?.(input);
    // a drag that has just begun must follow this move as well
    while (next !== undefined) {
      this.enter(next);
      next = next.move?.(input);
    }
  }

  private letGo(input: PointerInput): void {
    this.enter(this.state?.up?.(input) ?? null);
  }

  private enter(next: PointerState | null): void {
    this.state = next;
    if (next === null) {
      this.onIdle();
      return;
    }
    this.context.hovered.setState(null, true);
    this.context.canvas.setState({ cursor: next.cursor, placing: null });
  }
}
