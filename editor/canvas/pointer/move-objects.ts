import { duplicateObjects, moveObjects, type ObjectKey, objectsOf } from '../../document/index.ts';
import { REACH } from '../hit-test.ts';
import { snapMove, snapTargets } from '../snapping.ts';
import type { PointerContext, PointerInput, PointerState } from './state.ts';

/**
 * Dragging what is selected. With Alt copies are left where the objects were: the objects themselves move on, so that what the pointer holds stays the same.
 * @param lead the object under the pointer
 */
export function movingObjects(context: PointerContext, from: PointerInput, lead: ObjectKey): PointerState {
  const { document, selection, canvas } = context;
  const keys = selection.keys();
  const file = document.file();
  const start = objectsOf(file).get(lead)?.object ?? { x: from.place.x, y: from.place.y };
  const targets = snapTargets(file, keys);
  const gesture = document.begin(keys.length === 1 ? 'Move' : `Move ${keys.length} objects`);
  const done = () => canvas.setState({ guides: [] });
  return {
    name: 'moving',
    cursor: 'grabbing',
    move(input) {
      const move = { x: input.place.x - from.place.x, y: input.place.y - from.place.y };
      // Shift keeps to the axis that is farther
      const straight = input.shift ? (Math.abs(move.x) > Math.abs(move.y) ? { x: move.x, y: 0 } : { x: 0, y: move.y }) : move;
      const reach = (input.touch ? REACH.touch : REACH.mouse) / context.view().zoom;
      const snapping = input.mod ? { grid: null, toObjects: false } : context.snapping();
      const snapped = snapMove(start, straight, targets, { ...snapping, reach });
      const dx = input.shift && straight.x === 0 ? 0 : snapped.dx;
      const dy = input.shift && straight.y === 0 ? 0 : snapped.dy;
      const result = gesture.set((draft) => {
        if (input.alt) duplicateObjects(keys, 0, 0)(draft);
        moveObjects(keys, dx, dy)(draft);
      });
      if (!result.ok) context.refused(result.refusal.message);
      canvas.setState({ guides: snapped.guides });
      return undefined;
    },
    up() {
      gesture.commit();
      done();
      return undefined;
    },
    cancel() {
      gesture.cancel();
      done();
    },
  };
}
