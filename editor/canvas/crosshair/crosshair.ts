import type { StoreApi } from 'zustand/vanilla';
import { CLICK_SLOP, type PointerContext, type PointerInput, type PointerListening } from '../pointer/index.ts';
import { type Point, toScreen, withinView } from '../view.ts';
import { type Stride, startingPlace, stepped, under } from './crosshair-place.ts';
import { CrosshairReports, type Moment } from './crosshair-reports.ts';
import { placeInWords } from './words.ts';

/** A pointer for the keyboard: a place on the canvas that arrows move and at which the tool in hand is used. It is there while the canvas has the focus. */
export interface Crosshair {
  isShown(): boolean;
  /** Whether the canvas has the focus, so that its keys are meant for it. */
  hasFocus(): boolean;
  /** Shows it and gives the canvas the focus. @param why said first */
  show(why?: string): void;
  /** @returns whether it was shown */
  hide(): boolean;
  /**
   * @param to one step to the left or right, up or down
   * @param isRepeated the key is held: what is there is reported once it is let go
   */
  move(to: Point, stride: Stride, isRepeated: boolean): void;
  /** Does what a click of the pointer does there; lets go of what is held. */
  use(shift: boolean): void;
  /** Presses and holds, as a drag begins; lets go of what is held. */
  hold(shift: boolean): void;
  stop(): void;
}

interface CrosshairParts {
  readonly element: HTMLElement;
  readonly context: PointerContext;
  readonly pointer: PointerListening;
  /** px between lines of the grid, whether things snap to it or not */
  readonly grid: () => number;
  /** What is said to who can't see it. */
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
  private place: Point = { x: 0, y: 0 };
  private wasUsed = false;
  private isOut = false;
  /** Where the pointer rests meanwhile; a page that moves under it is no move of the pointer. */
  private rest: Point | null = null;
  /** The level and the selection when the keys began to hold something. */
  private held: (Moment & { readonly shift: boolean }) | null = null;

  constructor({ element, context, pointer, grid, said }: CrosshairParts) {
    this.element = element;
    this.context = context;
    this.pointer = pointer;
    this.grid = grid;
    this.reports = new CrosshairReports(context, said);
    const draw = () => this.draw();
    // an undo, another tool, the outline: what lies under it is another
    this.stops = [this.listen(), context.selection.store.subscribe(draw), context.document.subscribe(draw)];
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
      this.place = startingPlace(context, this.grid(), this.wasUsed ? this.place : null);
      this.wasUsed = true;
      this.rest = null;
    }
    this.isOut = true;
    this.element.focus({ preventScroll: true });
    if (!this.hasFocus()) return;
    context.setView(withinView(context.view(), this.place));
    this.draw();
    if (why === undefined) reports.reportStep(this.place, this.held);
    else reports.reportPlace(this.place, why);
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
    this.place = stepped(this.place, to, stride, this.grid());
    context.setView(withinView(context.view(), this.place));
    if (this.held !== null) this.pointer.keys.move(this.input(this.held.shift));
    this.draw();
    if (isRepeated) reports.isPending = true;
    else reports.reportStep(this.place, this.held);
  }

  use(shift: boolean): void {
    const { context, reports, pointer, place } = this;
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
    // the view is not dragged by what moves over it
    if (context.tool() === 'hand') return;
    const what = context.tool() === 'select' ? reports.thing(this.place) : null;
    this.held = { ...this.moment(), shift };
    pointer.keys.press(this.input(shift), () => this.putBack());
    this.draw();
    if (what === null) reports.reportStep(this.place, this.held);
    else reports.report(what === 'empty' ? `Selecting from ${placeInWords(this.place)}` : `Holding ${what}`);
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
      if (reports.isPending) reports.reportStep(this.place, this.held);
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
    canvas.setState({ crosshair: shown ? this.place : null });
    const key = shown && !this.pointer.keys.isHolding() ? (under(this.context, this.place)?.key ?? null) : null;
    hovered.setState(key, true);
  }

  private input(shift: boolean): PointerInput {
    const { place } = this;
    // it stands where it shall: nothing snaps away from there
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
    if (before !== null) this.reports.reportDone(this.place, before);
  }

  /** What it held was taken back. */
  private putBack(): void {
    this.held = null;
    this.draw();
    this.reports.reportPlace(this.place, 'Put back');
  }
}
