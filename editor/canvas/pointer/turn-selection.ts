import { mapObjects, mapProblem, turnBy } from '../../core/document/index.ts';
import { centreOf, type SelectionBox } from '../selection-box/index.ts';
import type { PointerContext, PointerInput, PointerState } from './state.ts';

/** degrees between the angles that a drag stops at: usually, with Shift, and with Ctrl */
const STEPS = { usual: 1, wide: 15, fine: 0.1 } as const;

const stepOf = ({ shift, mod }: PointerInput): number => (shift ? STEPS.wide : mod ? STEPS.fine : STEPS.usual);

/** Drags the handle that turns the selection about the middle of its box; Shift stops at every 15 degrees. */
export function turningSelection(context: PointerContext, from: PointerInput, selection: SelectionBox): PointerState {
  const { document } = context;
  const file = document.file();
  const { keys } = selection;
  const centre = centreOf(selection.box);
  const gesture = document.begin(`Turn ${keys.length === 1 ? 'it' : `${keys.length} objects`}`);
  const angleAt = ({ place }: PointerInput) => (Math.atan2(place.y - centre.y, place.x - centre.x) * 180) / Math.PI;
  const start = angleAt(from);
  const end = () => context.measure([]);
  return {
    name: 'turning',
    cursor: 'grabbing',
    move(input) {
      const step = stepOf(input);
      const turned = Math.round((angleAt(input) - start) / step) * step;
      const degrees = Number((((turned + 540) % 360) - 180).toFixed(1));
      const map = turnBy(degrees);
      const problem = mapProblem(file, keys, map);
      if (problem !== null) context.refused(problem);
      else {
        const result = gesture.set(mapObjects(keys, centre, map));
        if (!result.ok) context.refused(result.refusal.message);
      }
      context.measure([{ words: `${degrees}°`, at: input.place }]);
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
