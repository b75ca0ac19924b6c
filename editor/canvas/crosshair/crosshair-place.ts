import { type FoundObject, lockedIn, objectsOf, visibleIn } from '../../core/document/index.ts';
import { type Hit, hitsAt, hitTest, REACH } from '../hit-test.ts';
import type { PointerContext } from '../pointer/index.ts';
import { isInView, type Point } from '../view.ts';

/** How far an arrow key moves the crosshair. */
export type Stride = 'grid' | 'far' | 'fine';

/** grid lines in a far stride: every eighth line is drawn stronger */
const FAR = 8;

/** The next grid line in a direction. */
function nextLine(from: number, way: number, step: number): number {
  if (way === 0) return from;
  return way > 0 ? (Math.floor(from / step) + 1) * step : (Math.ceil(from / step) - 1) * step;
}

/** The new point of the crosshair. @param to one step left, right, up or down @param grid px between lines */
export function stepped(place: Point, to: Point, stride: Stride, grid: number): Point {
  if (stride === 'fine') return { x: place.x + to.x, y: place.y + to.y };
  const step = stride === 'far' ? FAR * grid : grid;
  return { x: nextLine(place.x, to.x, step), y: nextLine(place.y, to.y, step) };
}

/**
 * Where the crosshair is shown first: at the selected object if there is just one, else where it was last, else in the middle
 * of the view.
 * @param last where it was last; null: not shown yet
 */
export function startingPlace(context: PointerContext, grid: number, last: Point | null): Point {
  const seen = context.view();
  const [lone, ...others] = context.tool() === 'select' ? context.selection.keys() : [];
  const object = others.length > 0 || lone === undefined ? undefined : objectsOf(context.document.file()).get(lone)?.object;
  if (object !== undefined && isInView(seen, object)) return { x: object.x, y: object.y };
  if (last !== null && isInView(seen, last)) return last;
  const round = (value: number) => Math.round(value / grid) * grid;
  return { x: round(seen.x), y: round(seen.y) };
}

/** What lies under the crosshair; null: nothing. */
export function under(context: PointerContext, place: Point): Hit | null {
  const selected = context.tool() === 'select' ? context.selection.keys() : [];
  return hitTest(context.document.file(), context.her(), place, REACH.keys / context.view().zoom, selected);
}

/** The locked object under the crosshair, which can't be grabbed; null: none. */
export function lockedUnder(context: PointerContext, place: Point): FoundObject | null {
  const file = context.document.file();
  const visible = visibleIn(file);
  const locked = [...lockedIn(file)].flatMap((key) => visible.get(key) ?? []);
  const [hit] = hitsAt(locked, context.her(), place, REACH.keys / context.view().zoom);
  return hit === undefined ? null : (visible.get(hit.key) ?? null);
}
