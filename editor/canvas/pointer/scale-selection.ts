import { scaleObjects } from '../../core/document/index.ts';
import { cursorOf, type ScaleHandle, type SelectionBox, scalingOf } from '../selection-box/index.ts';
import type { PointerContext, PointerInput, PointerState } from './state.ts';

const percent = (factor: number): string => `${Math.round(factor * 1000) / 10} %`;

/**
 * Drags a handle of the selection's box: the places are scaled about the opposite corner or side. A corner keeps the shape, with
 * Shift it does not; with Alt the radii scale, too.
 */
export function scalingSelection(
  context: PointerContext,
  from: PointerInput,
  selection: SelectionBox,
  handle: ScaleHandle,
): PointerState {
  const { document } = context;
  const file = document.file();
  const gesture = document.begin(`Scale ${selection.keys.length === 1 ? 'it' : `${selection.keys.length} objects`}`);
  const end = () => context.measure([]);
  return {
    name: 'scaling',
    cursor: cursorOf(handle),
    move(input) {
      const move = { x: input.place.x - from.place.x, y: input.place.y - from.place.y };
      const scaling = scalingOf(selection, handle, { move, keepsShape: !input.shift, withRadii: input.alt });
      const result = gesture.set(scaleObjects(file, selection.keys, scaling));
      if (!result.ok) context.refused(result.refusal.message);
      const { x, y } = scaling;
      context.measure([{ words: x === y ? percent(x) : `${percent(x)} × ${percent(y)}`, at: input.place }]);
      return undefined;
    },
    up() {
      gesture.commit();
      end();
      return undefined;
    },
    cancel() {
      gesture.cancel();
      end();
    },
  };
}
