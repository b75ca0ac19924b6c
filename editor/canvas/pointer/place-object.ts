import { appearanceOf, PLACEABLES, type Placeable } from '../../../schema/index.ts';
import { addObject, type ObjectKey, objectsOf } from '../../core/document/index.ts';
import { type Point, toLevel } from '../view.ts';
import { hasMoved, type PointerContext, type PointerInput, type PointerState } from './state.ts';

/** Where a new object goes: on the grid, unless Ctrl is held. */
export function placeFor(context: PointerContext, { place, mod }: Pick<PointerInput, 'place' | 'mod'>): Point {
  const { grid } = context.snapping();
  if (mod || grid === null) return place;
  return { x: Math.round(place.x / grid) * grid, y: Math.round(place.y / grid) * grid };
}

/**
 * Adds an object where the pointer was pressed; a drag sets its radius. With Shift, or while the tool is
 * locked, it stays selected afterwards.
 */
export function placingObject(context: PointerContext, from: PointerInput, kind: Placeable): PointerState {
  const { document, selection } = context;
  const at = placeFor(context, from);
  const gesture = document.begin(`Add ${appearanceOf(kind).one}`);
  let added: readonly ObjectKey[] = [];
  const set = (radius?: number) => {
    const result = gesture.set(addObject(kind, at.x, at.y, radius));
    if (result.ok) added = result.added;
    else context.refused(result.refusal.message);
  };
  set();
  return {
    name: 'placing',
    cursor: 'crosshair',
    move(input) {
      if (!hasMoved(from, input)) return undefined;
      const reached = Math.hypot(input.place.x - at.x, input.place.y - at.y);
      set(Math.max(1, input.mod ? reached : Math.round(reached)));
      return undefined;
    },
    up(input) {
      gesture.commit();
      selection.select(added.filter((key) => objectsOf(document.file()).has(key)));
      if (!input.shift && !context.isToolLocked()) context.setTool('select');
      return undefined;
    },
    cancel: () => gesture.cancel(),
  };
}

/** the data type of a tool that is dragged onto the canvas */
export const DRAGGED_TOOL = 'application/x-gq-tool';

/** Lets the user drag tools from the toolbar onto the canvas. @returns stops it */
export function listenToDrops(element: HTMLElement, context: PointerContext): () => void {
  const stopping = new AbortController();
  const options = { signal: stopping.signal };
  const placeOf = (event: DragEvent) => {
    const box = element.getBoundingClientRect();
    const screen = { x: event.clientX - box.left, y: event.clientY - box.top };
    const mod = event.ctrlKey || event.metaKey;
    return placeFor(context, { place: toLevel(context.view(), screen), mod });
  };
  element.addEventListener(
    'dragover',
    (event) => {
      if (event.dataTransfer?.types.includes(DRAGGED_TOOL) !== true) return;
      event.preventDefault();
      event.dataTransfer.dropEffect = 'copy';
      context.canvas.setState({ placing: placeOf(event) });
    },
    options,
  );
  element.addEventListener('dragleave', () => context.canvas.setState({ placing: null }), options);
  element.addEventListener(
    'drop',
    (event) => {
      const name = event.dataTransfer?.getData(DRAGGED_TOOL);
      const tool = PLACEABLES.find((one) => one === name);
      context.canvas.setState({ placing: null });
      if (tool === undefined) return;
      event.preventDefault();
      const { x, y } = placeOf(event);
      const result = context.document.change(`Add ${appearanceOf(tool).one}`, addObject(tool, x, y));
      if (result.ok) context.selection.select(result.added);
      else context.refused(result.refusal.message);
      element.focus({ preventScroll: true });
    },
    options,
  );
  return () => stopping.abort();
}
