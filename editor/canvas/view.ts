/** A place, in px of the level or of the screen. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** An upright rectangle in px of the level. */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Which part of the level the canvas shows: the place in its middle, and how many px of screen a px of the level takes. */
export interface View extends Point {
  readonly zoom: number;
  /** px of screen */
  readonly width: number;
  readonly height: number;
}

/** px of screen per px of the level */
export const ZOOM_LIMITS = { least: 0.02, most: 16 } as const;

/** The place in the level that a place on the canvas shows. */
export function toLevel(view: View, screen: Point): Point {
  return { x: view.x + (screen.x - view.width / 2) / view.zoom, y: view.y + (screen.y - view.height / 2) / view.zoom };
}

/** Where on the canvas a place of the level is. */
export function toScreen(view: View, place: Point): Point {
  return { x: (place.x - view.x) * view.zoom + view.width / 2, y: (place.y - view.y) * view.zoom + view.height / 2 };
}

/** Zooms by a factor while what is under a place of the screen stays under it. */
export function zoomAt(view: View, screen: Point, factor: number): View {
  const zoom = Math.min(ZOOM_LIMITS.most, Math.max(ZOOM_LIMITS.least, view.zoom * factor));
  const under = toLevel(view, screen);
  return {
    ...view,
    zoom,
    x: under.x - (screen.x - view.width / 2) / zoom,
    y: under.y - (screen.y - view.height / 2) / zoom,
  };
}

/** Moves what is seen by so many px of screen. */
export function panBy(view: View, dx: number, dy: number): View {
  return { ...view, x: view.x - dx / view.zoom, y: view.y - dy / view.zoom };
}

/** px of screen that are kept between a place that is worked at and the edges; at the top there are the tools as well */
const CLEAR = { side: 48, top: 84 } as const;

/** The view moved no farther than needed for a place to be seen, clear of the edges and of the tools. */
export function withinView(view: View, place: Point): View {
  const { x, y } = toScreen(view, place);
  // a small canvas keeps a middle
  const side = Math.min(CLEAR.side, view.width / 4);
  const [top, bottom] = [Math.min(CLEAR.top, view.height / 4), Math.min(CLEAR.side, view.height / 4)];
  const dx = Math.min(view.width - side, Math.max(side, x)) - x;
  const dy = Math.min(view.height - bottom, Math.max(top, y)) - y;
  return dx === 0 && dy === 0 ? view : panBy(view, dx, dy);
}

/** Whether a place is seen. */
export function isInView(view: View, place: Point): boolean {
  const { x, y } = toScreen(view, place);
  return x >= 0 && y >= 0 && x <= view.width && y <= view.height;
}

/** px of screen around the level when all of it is shown, and how much of a small canvas they take at most; at the top there are the tools as well */
const MARGIN = 60;
const MARGIN_SHARE = 0.125;
const TOOLS = 24;

const marginOf = (size: number): number => Math.min(MARGIN, MARGIN_SHARE * size);

/** Shows all of a box with a margin, clear of the tools, at most at the zoom `most`. */
export function fitBox(view: View, box: Box, most = 2): View {
  const width = Math.max(1, box.right - box.left);
  const height = Math.max(1, box.bottom - box.top);
  const room = (size: number, above: number) => Math.max(1, size - 2 * marginOf(size) - above);
  const wanted = Math.min(most, room(view.width, 0) / width, room(view.height, TOOLS) / height);
  const zoom = Math.min(ZOOM_LIMITS.most, Math.max(ZOOM_LIMITS.least, wanted));
  const y = (box.top + box.bottom) / 2 - TOOLS / 2 / zoom;
  return { ...view, x: (box.left + box.right) / 2, y, zoom };
}
