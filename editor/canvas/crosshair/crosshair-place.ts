import { objectsOf } from '../../document/index.ts';
import { type Hit, hitTest, REACH } from '../hit-test.ts';
import type { PointerContext } from '../pointer/index.ts';
import { isInView, type Point } from '../view.ts';

/** How far an arrow moves it. */
export type Stride = 'grid' | 'far' | 'fine';

/** So many lines of the grid are a far stride: every eighth is drawn stronger. */
const FAR = 8;

/** The next line of the grid that way. */
function nextLine(from: number, way: number, step: number): number {
  if (way === 0) return from;
  return way > 0 ? (Math.floor(from / step) + 1) * step : (Math.ceil(from / step) - 1) * step;
}

/** Where it comes to. @param to one step to the left or right, up or down @param grid px between lines */
export function stepped(place: Point, to: Point, stride: Stride, grid: number): Point {
  if (stride === 'fine') return { x: place.x + to.x, y: place.y + to.y };
  const step = stride === 'far' ? FAR * grid : grid;
  return { x: nextLine(place.x, to.x, step), y: nextLine(place.y, to.y, step) };
}

/**
 * Where it is shown first. The only object that is selected is where somebody goes on; else where it was; else the middle of what is seen.
 * @param last where it was; null: nowhere yet
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

/** What lies under it; null: nothing does. */
export function under(context: PointerContext, place: Point): Hit | null {
  const selected = context.tool() === 'select' ? context.selection.keys() : [];
  return hitTest(context.document.file(), context.her(), place, REACH.keys / context.view().zoom, selected);
}
