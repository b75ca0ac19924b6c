import { type ObjectKey, unitOf, withGroups } from '../../core/document/index.ts';
import { selectionBox } from '../extent.ts';
import { type Hit, hitTest, objectsIn, REACH } from '../hit-test.ts';
import { cursorOf, type Grip, handleAt } from '../selection-handles.ts';
import { panBy } from '../view.ts';
import { clickAt, lastClickAt } from './click.ts';
import { resizingObjects, scalingSelection, turningSelection } from './drag-handles.ts';
import { movingObjects } from './move-objects.ts';
import { placingObject } from './place-object.ts';
import { hasMoved, type PointerContext, type PointerInput, type PointerState } from './state.ts';

/**
 * A press on an object: a click selects it with its group, a drag moves the selection, or resizes it if the rim was grabbed. With
 * Alt, a click selects the object alone.
 */
function pressedObject(context: PointerContext, from: PointerInput, hit: Hit): PointerState {
  const { key, part } = hit;
  const { selection } = context;
  const unit = unitOf(context.document.file(), key, selection.keys());
  const wasSelected = selection.keys().includes(key);
  if (!wasSelected) {
    if (from.shift) selection.add(unit);
    else selection.select(unit);
  }
  return {
    name: 'pressed',
    cursor: part === 'rim' ? 'nwse-resize' : 'default',
    move(input) {
      if (!hasMoved(from, input)) return undefined;
      return part === 'rim' ? resizingObjects(context, hit) : movingObjects(context, from, hit);
    },
    up() {
      if (from.shift && wasSelected) selection.toggle(unit);
      else if (part === 'rim') selection.select(unit);
      else if (!from.shift) clickAt(context, from, from.alt);
      return undefined;
    },
    cancel: () => {},
  };
}

/** A handle of the selection's box under the pointer, with the box; null: none. */
function gripAt(context: PointerContext, { place, by }: PointerInput): Grip | null {
  const box = selectionBox(context.document.file(), context.her(), context.selection.keys());
  const handle = handleAt(box, place, context.view(), by);
  return box === null || handle === null ? null : { box, handle };
}

/** A press on a handle of the selection's box: a drag scales or turns the selection. */
function pressedHandle(context: PointerContext, from: PointerInput, { box, handle }: Grip): PointerState {
  return {
    name: 'pressed',
    cursor: cursorOf(handle),
    move(input) {
      if (!hasMoved(from, input)) return undefined;
      return handle.does === 'turn' ? turningSelection(context, from, box) : scalingSelection(context, from, box, handle);
    },
    up: () => undefined,
    cancel: () => {},
  };
}

/** A press on empty space: a click clears the selection, a drag draws a marquee, a drag by touch moves the view. */
function pressedSpace(context: PointerContext, from: PointerInput): PointerState {
  return {
    name: 'pressed',
    cursor: 'default',
    move(input) {
      if (!hasMoved(from, input)) return undefined;
      return from.by === 'touch' ? panning(context, from) : drawingMarquee(context, from);
    },
    up() {
      if (!from.shift) context.selection.clear();
      return undefined;
    },
    cancel: () => {},
  };
}

/** The state that a press begins. Space starts a playtest, so the middle and right buttons move the view. */
export function pressed(context: PointerContext, input: PointerInput): PointerState {
  const tool = context.tool();
  if (input.button !== 0 || tool === 'hand') return panning(context, input);
  if (tool !== 'select') return placingObject(context, input, tool);
  const grip = gripAt(context, input);
  if (grip !== null) return pressedHandle(context, input, grip);
  const reach = REACH[input.by] / context.view().zoom;
  const hit = hitTest(context.document.file(), context.her(), input.place, reach, context.selection.keys());
  // what lies below and was selected by clicking again can be dragged from there
  const last = hit?.part === 'body' ? lastClickAt(context, input) : null;
  if (last !== null) return pressedObject(context, input, last.hit);
  if (hit === null) return pressedSpace(context, input);
  return pressedObject(context, input, hit);
}

/** The cursor and the hovered object while nothing is pressed. */
export function hovered(context: PointerContext, input: PointerInput): { key: ObjectKey | null; cursor: string } {
  const tool = context.tool();
  if (tool === 'hand') return { key: null, cursor: 'grab' };
  if (tool !== 'select') return { key: null, cursor: 'crosshair' };
  const grip = gripAt(context, input);
  if (grip !== null) return { key: null, cursor: cursorOf(grip.handle) };
  const hit = hitTest(
    context.document.file(),
    context.her(),
    input.place,
    REACH.mouse / context.view().zoom,
    context.selection.keys(),
  );
  if (hit === null) return { key: null, cursor: 'default' };
  return { key: hit.key, cursor: hit.part === 'rim' ? 'nwse-resize' : 'grab' };
}

/** Selects what lies in a rectangle, with whole groups; with Shift it is added to the selection. */
function drawingMarquee(context: PointerContext, from: PointerInput): PointerState {
  const { document, selection, canvas } = context;
  const before: readonly ObjectKey[] = selection.keys();
  return {
    name: 'marquee',
    cursor: 'crosshair',
    move({ place, shift }) {
      const box = {
        left: Math.min(from.place.x, place.x),
        top: Math.min(from.place.y, place.y),
        right: Math.max(from.place.x, place.x),
        bottom: Math.max(from.place.y, place.y),
      };
      canvas.setState({ marquee: box });
      const file = document.file();
      selection.select([...(shift ? before : []), ...withGroups(file, objectsIn(file, context.her(), box))]);
      return undefined;
    },
    up() {
      canvas.setState({ marquee: null });
      return undefined;
    },
    cancel() {
      canvas.setState({ marquee: null });
      selection.select(before);
    },
  };
}

/** Moves the view; the right button opens the menu of the place if it is released where it was pressed. */
function panning(context: PointerContext, from: PointerInput): PointerState {
  const before = context.view();
  let isDrag = false;
  return {
    name: 'panning',
    cursor: 'grabbing',
    move(input) {
      isDrag ||= hasMoved(from, input);
      if (!isDrag) return undefined;
      const { screen } = input;
      context.setView(panBy({ ...context.view(), x: before.x, y: before.y }, screen.x - from.screen.x, screen.y - from.screen.y));
      return undefined;
    },
    up() {
      if (from.button === 2 && !isDrag) context.openMenu(from.place, from.screen);
      return undefined;
    },
    cancel: () => context.setView({ ...context.view(), x: before.x, y: before.y }),
  };
}
