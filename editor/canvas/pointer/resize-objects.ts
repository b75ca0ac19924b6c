import { objectsOf, placesOf, radiusOf, scaleRadius, setRadius, unlocked } from '../../core/document/index.ts';
import type { Hit } from '../hit-test.ts';
import type { PointerContext, PointerState } from './state.ts';

/**
 * Drags a rim: the grabbed object gets the radius that reaches the pointer, and the rest of the selection is scaled by the same
 * factor.
 */
export function resizingObjects(context: PointerContext, { key: lead, place }: Hit): PointerState {
  const { document, selection } = context;
  const file = document.file();
  const found = objectsOf(file).get(lead);
  const before = found === undefined ? null : radiusOf(found);
  const keys = selection.keys().includes(lead) ? unlocked(file, selection.keys()) : [lead];
  const gesture = document.begin(keys.length === 1 ? 'Resize' : `Resize ${keys.length} objects`);
  return {
    name: 'resizing',
    cursor: 'nwse-resize',
    move(input) {
      if (found === undefined || before === null) return undefined;
      const middle = placesOf(found)[place];
      const reached = Math.hypot(input.place.x - middle.x, input.place.y - middle.y);
      const grid = input.mod || context.snapping().grid === null ? null : 1;
      const radius = Math.max(1, grid === null ? reached : Math.round(reached));
      const result = gesture.set(keys.length === 1 ? setRadius(keys, radius) : scaleRadius(file, keys, radius / before));
      if (!result.ok) context.refused(result.refusal.message);
      return undefined;
    },
    up() {
      gesture.commit();
      return undefined;
    },
    cancel: () => gesture.cancel(),
  };
}
