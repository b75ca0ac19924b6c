import { type ObjectKey, withGroups } from '../../core/document/index.ts';
import { objectsIn } from '../hit-test.ts';
import type { PointerContext, PointerInput, PointerState } from './state.ts';

/** Selects what lies in a rectangle, with whole groups; with Shift it is added to the selection. */
export function drawingMarquee(context: PointerContext, from: PointerInput): PointerState {
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
