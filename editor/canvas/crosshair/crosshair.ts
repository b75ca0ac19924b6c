import type { StoreApi } from 'zustand/vanilla';
import type { LevelFile } from '../../../schema/index.ts';
import { type ObjectKey, objectsOf } from '../../document/index.ts';
import { hitTest, REACH } from '../hit-test.ts';
import { CLICK_SLOP, type PointerContext, type PointerInput, type PointerListening } from '../pointer/index.ts';
import { isInView, type Point, toScreen, withinView } from '../view.ts';
import { changeInWords, placeInWords, selectionInWords, thingInWords } from './words.ts';

/** How far an arrow moves it. */
export type Stride = 'grid' | 'far' | 'fine';

/** So many lines of the grid are a far stride: every eighth is drawn stronger. */
const FAR = 8;

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

/** The next line of the grid that way. */
function nextLine(from: number, way: number, step: number): number {
  if (way === 0) return from;
  return way > 0 ? (Math.floor(from / step) + 1) * step : (Math.ceil(from / step) - 1) * step;
}

export function createCrosshair({ element, context, pointer, grid, said }: CrosshairParts): Crosshair {
  const { document, selection, canvas, hovered } = context;
  const stopping = new AbortController();
  const options = { signal: stopping.signal };
  let place: Point = { x: 0, y: 0 };
  let wasUsed = false;
  let isOut = false;
  /** Where the pointer rests meanwhile; a page that moves under it is no move of the pointer. */
  let rest: Point | null = null;
  /** The level and the selection when the keys began to hold something. */
  let held: { readonly file: LevelFile; readonly keys: readonly ObjectKey[]; readonly shift: boolean } | null = null;
  let isUntold = false;

  const hasFocus = () => window.document.activeElement === element;
  const isShown = () => isOut && hasFocus();
  const under = () =>
    hitTest(document.file(), place, REACH.keys / context.view().zoom, context.tool() === 'select' ? selection.keys() : []);
  const draw = () => {
    const shown = isShown();
    if (!shown && canvas.getState().crosshair === null) return;
    canvas.setState({ crosshair: shown ? place : null });
    hovered.setState(shown && !pointer.keys.isHolding() ? (under()?.key ?? null) : null, true);
  };
  const report = (text: string) => {
    isUntold = false;
    said.setState(text, true);
  };
  const thing = () => thingInWords(document.file(), under(), selection.keys());
  const tell = () => {
    const file = document.file();
    const here = placeInWords(place);
    if (held === null) report(`${here}, ${thing()}`);
    else if (canvas.getState().marquee !== null) report(`${here}, ${selection.keys().length} selected`);
    else report(changeInWords(held.file, file) ?? here);
  };
  const input = (shift: boolean): PointerInput => {
    const view = context.view();
    // it stands where it shall: nothing snaps away from there
    return { screen: toScreen(view, place), place, shift, alt: false, mod: true, by: 'keys', button: 0 };
  };
  /** Says what came of it. */
  const tellDone = ({ file, keys }: { readonly file: LevelFile; readonly keys: readonly ObjectKey[] }) =>
    report(
      changeInWords(file, document.file()) ??
        `${selectionInWords(document.file(), keys, selection.keys())}. ${placeInWords(place)}`,
    );
  const release = (shift: boolean) => {
    const before = held;
    held = null;
    pointer.keys.release(input(shift || before?.shift === true));
    draw();
    if (before !== null) tellDone(before);
  };
  /** The only object that is selected is where somebody goes on; else where the crosshair was; else the middle of what is seen. */
  const start = (): Point => {
    const view = context.view();
    const [lone, ...others] = context.tool() === 'select' ? selection.keys() : [];
    const object = others.length > 0 || lone === undefined ? undefined : objectsOf(document.file()).get(lone)?.object;
    if (object !== undefined && isInView(view, object)) return { x: object.x, y: object.y };
    if (wasUsed && isInView(view, place)) return place;
    const round = (value: number) => Math.round(value / grid()) * grid();
    return { x: round(view.x), y: round(view.y) };
  };
  const show = (why?: string) => {
    if (!isOut) {
      place = start();
      wasUsed = true;
      rest = null;
    }
    isOut = true;
    element.focus({ preventScroll: true });
    if (!hasFocus()) return;
    context.setView(withinView(context.view(), place));
    draw();
    if (why === undefined) tell();
    else report(`${why}. ${placeInWords(place)}, ${thing()}`);
  };
  const putBack = () => {
    held = null;
    draw();
    report(`Put back. ${placeInWords(place)}, ${thing()}`);
  };
  const hide = () => {
    const was = isShown();
    isOut = false;
    draw();
    if (was) report('');
    return was;
  };

  element.addEventListener(
    'focus',
    () => {
      if (isOut || context.tool() !== 'select') show();
    },
    options,
  );
  element.addEventListener(
    'blur',
    () => {
      if (pointer.keys.isHolding()) release(false);
      else report('');
      draw();
    },
    options,
  );
  element.addEventListener('pointerdown', hide, options);
  element.addEventListener(
    'pointermove',
    ({ clientX: x, clientY: y }) => {
      if (!isShown() || pointer.keys.isHolding()) return;
      rest ??= { x, y };
      if (Math.hypot(x - rest.x, y - rest.y) > CLICK_SLOP.mouse) hide();
    },
    options,
  );
  window.addEventListener(
    'keyup',
    () => {
      if (isUntold) tell();
    },
    options,
  );
  // an undo, another tool, the outline: what lies under it is another
  const stops = [selection.store.subscribe(draw), document.subscribe(draw)];

  return {
    isShown,
    hasFocus,
    show,
    hide,
    move(to, stride, isRepeated) {
      if (!isShown()) show();
      const step = stride === 'far' ? FAR * grid() : grid();
      place =
        stride === 'fine'
          ? { x: place.x + to.x, y: place.y + to.y }
          : { x: nextLine(place.x, to.x, step), y: nextLine(place.y, to.y, step) };
      context.setView(withinView(context.view(), place));
      if (held !== null) pointer.keys.move(input(held.shift));
      draw();
      if (isRepeated) isUntold = true;
      else tell();
    },
    use(shift) {
      if (pointer.keys.isHolding()) {
        release(shift);
        return;
      }
      if (context.tool() === 'hand') {
        context.setView({ ...context.view(), x: place.x, y: place.y });
        report(`The middle of the view is at ${placeInWords(place)}`);
        return;
      }
      const before = { file: document.file(), keys: selection.keys() };
      pointer.keys.press(input(shift), () => {});
      pointer.keys.release(input(shift));
      draw();
      tellDone(before);
    },
    hold(shift) {
      if (pointer.keys.isHolding()) {
        release(shift);
        return;
      }
      // the view is not dragged by what moves over it
      if (context.tool() === 'hand') return;
      const what = context.tool() === 'select' ? thing() : null;
      held = { file: document.file(), keys: selection.keys(), shift };
      pointer.keys.press(input(shift), putBack);
      draw();
      if (what === null) tell();
      else report(what === 'empty' ? `Selecting from ${placeInWords(place)}` : `Holding ${what}`);
    },
    stop() {
      for (const end of stops) end();
      stopping.abort();
    },
  };
}
