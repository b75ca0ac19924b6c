import {
  mapObjects,
  mapProblem,
  type ObjectKey,
  objectsOf,
  placesOf,
  type Recipe,
  radiusOf,
  scaleObjects,
  scaleRadius,
  setRadius,
  turnBy,
  unlocked,
} from '../../core/document/index.ts';
import { centreOf, type SelectionBox } from '../extent.ts';
import type { Hit } from '../hit-test.ts';
import { cursorOf, type ScaleHandle, scalingOf } from '../selection-handles.ts';
import type { PointerContext, PointerInput, PointerState } from './state.ts';

/** What a drag of a handle is called. */
interface DragNames {
  readonly name: string;
  readonly cursor: string;
  /** of the step in the history */
  readonly label: string;
}

/**
 * A drag that changes the level: each move changes it anew.
 * @param change returns what a move does, or why it can't be done
 */
function changing(
  context: PointerContext,
  { name, cursor, label }: DragNames,
  change: (input: PointerInput) => Recipe | string,
): PointerState {
  const gesture = context.document.begin(label);
  const end = () => context.measure([]);
  return {
    name,
    cursor,
    move(input) {
      const recipe = change(input);
      if (typeof recipe === 'string') context.refused(recipe);
      else {
        const result = gesture.set(recipe);
        if (!result.ok) context.refused(result.refusal.message);
      }
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

/** What a drag changes, for the label of its step: `it`, `3 objects`. */
const inWords = (keys: readonly ObjectKey[]): string => (keys.length === 1 ? 'it' : `${keys.length} objects`);

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
  const label = keys.length === 1 ? 'Resize' : `Resize ${inWords(keys)}`;
  return changing(context, { name: 'resizing', cursor: 'nwse-resize', label }, (input) => {
    if (found === undefined || before === null) return () => {};
    const middle = placesOf(found)[place];
    const reached = Math.hypot(input.place.x - middle.x, input.place.y - middle.y);
    const isFree = input.mod || context.snapping().grid === null;
    const radius = Math.max(1, isFree ? reached : Math.round(reached));
    return keys.length === 1 ? setRadius(keys, radius) : scaleRadius(file, keys, radius / before);
  });
}

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
  const file = context.document.file();
  const names = { name: 'scaling', cursor: cursorOf(handle), label: `Scale ${inWords(selection.keys)}` };
  return changing(context, names, (input) => {
    const move = { x: input.place.x - from.place.x, y: input.place.y - from.place.y };
    const scaling = scalingOf(selection, handle, { move, keepsShape: !input.shift, withRadii: input.alt });
    const { x, y } = scaling;
    context.measure([{ words: x === y ? percent(x) : `${percent(x)} × ${percent(y)}`, at: input.place }]);
    return scaleObjects(file, selection.keys, scaling);
  });
}

/** degrees between the angles that a drag stops at: usually, with Shift, and with Ctrl */
const STEPS = { usual: 1, wide: 15, fine: 0.1 } as const;

const stepOf = ({ shift, mod }: PointerInput): number => (shift ? STEPS.wide : mod ? STEPS.fine : STEPS.usual);

/** Drags the handle that turns the selection about the middle of its box; Shift stops at every 15 degrees. */
export function turningSelection(context: PointerContext, from: PointerInput, { keys, box }: SelectionBox): PointerState {
  const file = context.document.file();
  const centre = centreOf(box);
  const angleAt = ({ place }: PointerInput) => (Math.atan2(place.y - centre.y, place.x - centre.x) * 180) / Math.PI;
  const start = angleAt(from);
  return changing(context, { name: 'turning', cursor: 'grabbing', label: `Turn ${inWords(keys)}` }, (input) => {
    const step = stepOf(input);
    const turned = Math.round((angleAt(input) - start) / step) * step;
    const degrees = Number((((turned + 540) % 360) - 180).toFixed(1));
    context.measure([{ words: `${degrees}°`, at: input.place }]);
    const map = turnBy(degrees);
    return mapProblem(file, keys, map) ?? mapObjects(keys, centre, map);
  });
}
