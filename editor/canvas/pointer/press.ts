import type { ObjectKey } from '../../document/index.ts';
import { type Hit, hitTest, REACH } from '../hit-test.ts';
import { drawingMarquee } from './marquee.ts';
import { movingObjects } from './move-objects.ts';
import { panning } from './pan.ts';
import { placingObject } from './place-object.ts';
import { resizingObjects } from './resize-objects.ts';
import { hasMoved, type PointerContext, type PointerInput, type PointerState } from './state.ts';

/** An object is pressed: a click selects it, a drag moves it and what is selected with it, or by its rim resizes it. */
function pressedObject(context: PointerContext, from: PointerInput, hit: Hit): PointerState {
  const { key, part } = hit;
  const { selection } = context;
  const wasSelected = selection.keys().includes(key);
  if (!wasSelected) {
    if (from.shift) selection.add([key]);
    else selection.select([key]);
  }
  return {
    name: 'pressed',
    cursor: part === 'rim' ? 'nwse-resize' : 'default',
    move(input) {
      if (!hasMoved(from, input)) return undefined;
      return part === 'rim' ? resizingObjects(context, hit) : movingObjects(context, from, hit);
    },
    up() {
      if (!wasSelected) return undefined;
      if (from.shift) selection.toggle(key);
      else selection.select([key]);
      return undefined;
    },
    cancel: () => {},
  };
}

/** Empty space is pressed: a click selects nothing, a drag of the mouse draws a marquee, of a finger moves the view. */
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

/** What a press of the pointer begins. Space plays, so the other buttons are what moves the view. */
export function pressed(context: PointerContext, input: PointerInput): PointerState {
  const tool = context.tool();
  if (input.button !== 0 || tool === 'hand') return panning(context, input);
  if (tool !== 'select') return placingObject(context, input, tool);
  const reach = REACH[input.by] / context.view().zoom;
  const hit = hitTest(context.document.file(), context.her(), input.place, reach, context.selection.keys());
  if (hit === null) return pressedSpace(context, input);
  return pressedObject(context, input, hit);
}

/** The cursor and the hovered object where nothing is pressed. */
export function hovered(context: PointerContext, input: PointerInput): { key: ObjectKey | null; cursor: string } {
  const tool = context.tool();
  if (tool === 'hand') return { key: null, cursor: 'grab' };
  if (tool !== 'select') return { key: null, cursor: 'crosshair' };
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
