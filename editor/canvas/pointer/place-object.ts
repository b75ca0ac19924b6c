import { appearanceOf, type Placeable } from '../../../schema/index.ts';
import { addObject, type ObjectKey, objectsOf } from '../../core/document/index.ts';
import type { Point } from '../view.ts';
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
