import type { ObjectKey } from '../../document/index.ts';
import { type Hit, hitTest, REACH } from '../hit-test.ts';
import { drawingMarquee } from './marquee.ts';
import { movingObjects } from './move-objects.ts';
import { panning } from './pan.ts';
import { placingObject } from './place-object.ts';
import { resizingObjects } from './resize-objects.ts';
import { hasMoved, type PointerContext, type PointerInput, type PointerState } from './state.ts';

/** A press on an object: a click selects it, a drag moves the selection, or resizes it if the rim was grabbed. */
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
  const reach = REACH[input.by] / context.view().zoom;
  const hit = hitTest(context.document.file(), context.her(), input.place, reach, context.selection.keys());
  if (hit === null) return pressedSpace(context, input);
  return pressedObject(context, input, hit);
}

/** The cursor and the hovered object while nothing is pressed. */
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
