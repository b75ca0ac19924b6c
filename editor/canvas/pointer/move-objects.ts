import { duplicateObjects, type Gesture, moveObjects, objectsOf, placesOf, unlocked } from '../../core/document/index.ts';
import { type Hit, REACH } from '../hit-test.ts';
import { type SnapTargets, snapMove, snapTargets } from '../snapping.ts';
import type { PointerContext, PointerInput, PointerState } from './state.ts';

/** What the drag moves: the objects themselves, or copies of them while Alt is held. */
interface Drag {
  readonly areCopies: boolean;
  readonly gesture: Gesture;
  readonly targets: SnapTargets;
}

const NOT_COPIED = 'A level has one astronaut and one black hole: they can be moved, not copied. Release Alt to move them.';

/**
 * Drags the selection. While Alt is held, the objects stay in place, and copies of them are moved and selected. Locked objects stay. If a single
 * object with several places is selected, only the grabbed place moves.
 * @param hit what is under the pointer
 */
export function movingObjects(context: PointerContext, from: PointerInput, { key: lead, place }: Hit): PointerState {
  const { document, selection, canvas } = context;
  const file = document.file();
  const selected = selection.keys();
  const keys = unlocked(file, selected);
  const objects = objectsOf(file);
  const found = objects.get(lead);
  const places = found === undefined ? [] : placesOf(found);
  const start = places[place] ?? { x: from.place.x, y: from.place.y };
  const only = keys.length === 1 && places.length > 1 ? place : undefined;
  const copied = keys.filter((key) => objects.get(key)?.list !== null);

  const begin = (areCopies: boolean): Drag => {
    const moving = areCopies ? copied : keys;
    const what = moving.length === 1 ? '' : ` ${moving.length} objects`;
    return {
      areCopies,
      gesture: document.begin(areCopies ? `Duplicate${what}` : `Move${what}`),
      targets: snapTargets(file, context.her(), moving, areCopies ? { areCopies } : { only }),
    };
  };
  let drag = begin(false);
  /** Switches between moving the objects and moving copies. */
  const change = (areCopies: boolean) => {
    // an undo or a change on disk may have ended the gesture
    if (drag.areCopies === areCopies || !drag.gesture.isLive) return;
    drag.gesture.cancel();
    drag = begin(areCopies);
  };
  const show = (dx: number, dy: number) => {
    // a copy exactly on top of its original would not be visible
    const isNothing = drag.areCopies && dx === 0 && dy === 0;
    const recipe = drag.areCopies ? duplicateObjects(isNothing ? [] : copied, dx, dy) : moveObjects(keys, dx, dy, only);
    const { isLive } = drag.gesture;
    const result = drag.gesture.set(recipe);
    if (!result.ok) context.refused(result.refusal.message);
    else if (isLive) selection.select(result.added.length > 0 ? result.added : selected);
  };
  const done = () => canvas.setState({ guides: [], measures: [] });
  return {
    name: 'moving',
    cursor: 'grabbing',
    move(input) {
      change(input.alt);
      if (drag.areCopies && copied.length === 0) context.refused(NOT_COPIED);
      const move = { x: input.place.x - from.place.x, y: input.place.y - from.place.y };
      // Shift keeps the drag on its longer axis. Keys move along an axis anyway, and Shift sets their step.
      const fixed = input.shift && input.by !== 'keys' ? (Math.abs(move.x) > Math.abs(move.y) ? 'y' : 'x') : null;
      const reach = REACH[input.by] / context.view().zoom;
      const snapping = input.mod ? { grid: null, toObjects: false } : context.snapping();
      const { dx, dy, guides, measures } = snapMove(start, move, drag.targets, { ...snapping, reach, fixed });
      show(dx, dy);
      canvas.setState({ guides, measures, cursor: drag.areCopies ? 'copy' : 'grabbing' });
      return undefined;
    },
    up() {
      drag.gesture.commit();
      done();
      return undefined;
    },
    cancel() {
      drag.gesture.cancel();
      selection.select(selected);
      done();
    },
  };
}
