import type { StoreApi } from 'zustand/vanilla';
import { objectsOf } from '../core/document/index.ts';
import { CrosshairReports, type Moment, placeInWords, under } from './crosshair-reports.ts';
import { CLICK_SLOP, type PointerContext, type PointerInput, type PointerListening } from './pointer/index.ts';
import { isInView, type Point, toScreen, withinView } from './view.ts';

/** How far an arrow key moves the crosshair. */
export type Stride = 'grid' | 'far' | 'fine';

/**
 * A pointer for the keyboard: a point on the canvas that arrows move, where the current tool is used. It exists while the
 * canvas has the focus.
 */
export interface Crosshair {
  isShown(): boolean;
  /** Where it is, or would be shown. */
  place(): Point;
  /** Whether the canvas has the focus, so that keys are meant for it. */
  hasFocus(): boolean;
  /** Shows the crosshair and focuses the canvas. @param why announced first */
  show(why?: string): void;
  /** @returns whether it was shown */
  hide(): boolean;
  /**
   * Moves the crosshair.
   * @param to one step left, right, up or down
   * @param isRepeated whether the key is held down: the announcement then waits until it is released
   */
  move(to: Point, stride: Stride, isRepeated: boolean): void;
  /** Acts like a click at the crosshair; ends a drag in progress. */
  use(shift: boolean): void;
  /** Starts a drag at the crosshair, or ends the one in progress. */
  hold(shift: boolean): void;
  stop(): void;
}

interface CrosshairParts {
  readonly element: HTMLElement;
  readonly context: PointerContext;
  readonly pointer: PointerListening;
  /** px between grid lines, whether objects snap to them or not */
  readonly grid: () => number;
  /** Announcements for screen readers. */
  readonly said: StoreApi<string>;
}

export const createCrosshair = (parts: CrosshairParts): Crosshair => new KeyboardPointer(parts);

class KeyboardPointer implements Crosshair {
  private readonly element: HTMLElement;
  private readonly context: PointerContext;
  private readonly pointer: PointerListening;
  private readonly grid: () => number;
  private readonly reports: CrosshairReports;
  private readonly stops: readonly (() => void)[];
  private at: Point = { x: 0, y: 0 };
  private wasUsed = false;
  private isOut = false;
  /** Where the mouse pointer rested when the crosshair was shown; the page moving under it is no move of the pointer. */
  private rest: Point | null = null;
  /** The level and the selection when the drag began. */
  private held: (Moment & { readonly shift: boolean }) | null = null;

  constructor({ element, context, pointer, grid, said }: CrosshairParts) {
    this.element = element;
    this.context = context;
    this.pointer = pointer;
    this.grid = grid;
    this.reports = new CrosshairReports(context, said);
    const draw = () => this.draw();
    // an undo, another tool or the outline may change what lies under the crosshair
    this.stops = [this.listen(), context.selection.store.subscribe(draw), context.document.subscribe(draw)];
  }

  place(): Point {
    return this.isShown() ? this.at : startingPlace(this.context, this.grid(), this.wasUsed ? this.at : null);
  }

  isShown(): boolean {
    return this.isOut && this.hasFocus();
  }

  hasFocus(): boolean {
    return window.document.activeElement === this.element;
  }

  show(why?: string): void {
    const { context, reports } = this;
    if (!this.isOut) {
      this.at = startingPlace(context, this.grid(), this.wasUsed ? this.at : null);
      this.wasUsed = true;
      this.rest = null;
    }
    this.isOut = true;
    this.element.focus({ preventScroll: true });
    if (!this.hasFocus()) return;
    context.setView(withinView(context.view(), this.at));
    this.draw();
    if (why === undefined) reports.reportStep(this.at, this.held);
    else reports.reportPlace(this.at, why);
  }

  hide(): boolean {
    const was = this.isShown();
    this.isOut = false;
    this.draw();
    if (was) this.reports.report('');
    return was;
  }

  move(to: Point, stride: Stride, isRepeated: boolean): void {
    const { context, reports } = this;
    if (!this.isShown()) this.show();
    this.at = stepped(this.at, to, stride, this.grid());
    context.setView(withinView(context.view(), this.at));
    if (this.held !== null) this.pointer.keys.move(this.input(this.held.shift));
    this.draw();
    if (isRepeated) reports.isPending = true;
    else reports.reportStep(this.at, this.held);
  }

  use(shift: boolean): void {
    const { context, reports, pointer, at: place } = this;
    if (pointer.keys.isHolding()) {
      this.release(shift);
      return;
    }
    if (context.tool() === 'hand') {
      context.setView({ ...context.view(), x: place.x, y: place.y });
      reports.report(`The middle of the view is at ${placeInWords(place)}`);
      return;
    }
    const before = this.moment();
    pointer.keys.press(this.input(shift), () => {});
    pointer.keys.release(this.input(shift));
    this.draw();
    reports.reportDone(place, before);
  }

  hold(shift: boolean): void {
    const { context, reports, pointer } = this;
    if (pointer.keys.isHolding()) {
      this.release(shift);
      return;
    }
    // a drag at the crosshair can't move the view that it moves over
    if (context.tool() === 'hand') return;
    const isEmpty = under(context, this.at) === null;
    const what = context.tool() === 'select' ? reports.thing(this.at) : null;
    this.held = { ...this.moment(), shift };
    pointer.keys.press(this.input(shift), () => this.putBack());
    this.draw();
    if (what === null) reports.reportStep(this.at, this.held);
    else reports.report(isEmpty ? `Selecting from ${placeInWords(this.at)}` : `Holding ${what}`);
  }

  stop(): void {
    for (const end of this.stops) end();
  }

  /** @returns stops it */
  private listen(): () => void {
    const { element, pointer, context, reports } = this;
    const stopping = new AbortController();
    const options = { signal: stopping.signal };
    const onFocus = () => {
      if (this.isOut || context.tool() !== 'select') this.show();
    };
    const onBlur = () => {
      if (pointer.keys.isHolding()) this.release(false);
      else reports.report('');
      this.draw();
    };
    const onPointerMove = ({ clientX: x, clientY: y }: PointerEvent) => {
      if (!this.isShown() || pointer.keys.isHolding()) return;
      this.rest ??= { x, y };
      if (Math.hypot(x - this.rest.x, y - this.rest.y) > CLICK_SLOP.mouse) this.hide();
    };
    const onKeyUp = () => {
      if (reports.isPending) reports.reportStep(this.at, this.held);
    };
    element.addEventListener('focus', onFocus, options);
    element.addEventListener('blur', onBlur, options);
    element.addEventListener('pointerdown', () => this.hide(), options);
    element.addEventListener('pointermove', onPointerMove, options);
    window.addEventListener('keyup', onKeyUp, options);
    return () => stopping.abort();
  }

  private draw(): void {
    const { canvas, hovered } = this.context;
    const shown = this.isShown();
    if (!shown && canvas.getState().crosshair === null) return;
    canvas.setState({ crosshair: shown ? this.at : null });
    const key = shown && !this.pointer.keys.isHolding() ? (under(this.context, this.at)?.key ?? null) : null;
    hovered.setState(key, true);
  }

  private input(shift: boolean): PointerInput {
    const { at: place } = this;
    // the crosshair stands exactly where the user wants it: nothing snaps
    return { screen: toScreen(this.context.view(), place), place, shift, alt: false, mod: true, by: 'keys', button: 0 };
  }

  private moment(): Moment {
    const { document, selection } = this.context;
    return { file: document.file(), keys: selection.keys() };
  }

  private release(shift: boolean): void {
    const before = this.held;
    this.held = null;
    this.pointer.keys.release(this.input(shift || before?.shift === true));
    this.draw();
    if (before !== null) this.reports.reportDone(this.at, before);
  }

  /** Called when the drag was cancelled. */
  private putBack(): void {
    this.held = null;
    this.draw();
    this.reports.reportPlace(this.at, 'Put back');
  }
}

/** grid lines in a far stride: every eighth line is drawn stronger */
const FAR = 8;

/** The next grid line in a direction. */
function nextLine(from: number, way: number, step: number): number {
  if (way === 0) return from;
  return way > 0 ? (Math.floor(from / step) + 1) * step : (Math.ceil(from / step) - 1) * step;
}

/** The new point of the crosshair. @param to one step left, right, up or down @param grid px between lines */
function stepped(place: Point, to: Point, stride: Stride, grid: number): Point {
  if (stride === 'fine') return { x: place.x + to.x, y: place.y + to.y };
  const step = stride === 'far' ? FAR * grid : grid;
  return { x: nextLine(place.x, to.x, step), y: nextLine(place.y, to.y, step) };
}

/**
 * Where the crosshair is shown first: at the selected object if there is just one, else where it was last, else in the middle
 * of the view.
 * @param last where it was last; null: not shown yet
 */
function startingPlace(context: PointerContext, grid: number, last: Point | null): Point {
  const seen = context.view();
  const [lone, ...others] = context.tool() === 'select' ? context.selection.keys() : [];
  const object = others.length > 0 || lone === undefined ? undefined : objectsOf(context.document.file()).get(lone)?.object;
  if (object !== undefined && isInView(seen, object)) return { x: object.x, y: object.y };
  if (last !== null && isInView(seen, last)) return last;
  const round = (value: number) => Math.round(value / grid) * grid;
  return { x: round(seen.x), y: round(seen.y) };
}
