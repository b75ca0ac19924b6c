/** A point, in px of the level or of the screen. */
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

/** The part of the level that the canvas shows: the point in its middle and the px of screen per px of the level. */
export interface View extends Point {
  readonly zoom: number;
  /** px of screen */
  readonly width: number;
  readonly height: number;
}

/** px of screen per px of the level */
export const ZOOM_LIMITS = { least: 0.02, most: 16 } as const;

/** The point of the level that is shown at a point of the canvas. */
export function toLevel(view: View, screen: Point): Point {
  return { x: view.x + (screen.x - view.width / 2) / view.zoom, y: view.y + (screen.y - view.height / 2) / view.zoom };
}

/** Where on the canvas a point of the level is shown. */
export function toScreen(view: View, place: Point): Point {
  return { x: (place.x - view.x) * view.zoom + view.width / 2, y: (place.y - view.y) * view.zoom + view.height / 2 };
}

/** Zooms by a factor and keeps the point of the level under `screen` in place. */
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

/** Moves the view by px of screen. */
export function panBy(view: View, dx: number, dy: number): View {
  return { ...view, x: view.x - dx / view.zoom, y: view.y - dy / view.zoom };
}

/** px of screen kept between the crosshair and the edges; more at the top, where the tools are */
const CLEAR = { side: 48, top: 84 } as const;

/** Moves the view no farther than needed to show a point clear of the edges and the tools. */
export function withinView(view: View, place: Point): View {
  const { x, y } = toScreen(view, place);
  // a small canvas keeps a middle part
  const side = Math.min(CLEAR.side, view.width / 4);
  const [top, bottom] = [Math.min(CLEAR.top, view.height / 4), Math.min(CLEAR.side, view.height / 4)];
  const dx = Math.min(view.width - side, Math.max(side, x)) - x;
  const dy = Math.min(view.height - bottom, Math.max(top, y)) - y;
  return dx === 0 && dy === 0 ? view : panBy(view, dx, dy);
}

/** least px of screen per px of the level at which a place can be made out */
const LEGIBLE = 0.5;

/** Shows a place: moves and enlarges the view only if the place is at its edge or too small to be made out. */
export function lookAt(view: View, place: Point): View {
  if (view.zoom >= LEGIBLE && withinView(view, place) === view) return view;
  const zoom = Math.max(view.zoom, LEGIBLE);
  return { ...view, zoom, x: place.x, y: place.y - TOOLS / 2 / zoom };
}

/** Whether a point is visible. */
export function isInView(view: View, place: Point): boolean {
  const { x, y } = toScreen(view, place);
  return x >= 0 && y >= 0 && x <= view.width && y <= view.height;
}

/** px of screen around a fitted box, at most a share of a small canvas; more at the top, where the tools are */
const MARGIN = 60;
const MARGIN_SHARE = 0.125;
const TOOLS = 24;

const marginOf = (size: number): number => Math.min(MARGIN, MARGIN_SHARE * size);

/** Fits a box into the view with a margin, clear of the tools, at a zoom of at most `most`. */
export function fitBox(view: View, box: Box, most = 2): View {
  const width = Math.max(1, box.right - box.left);
  const height = Math.max(1, box.bottom - box.top);
  const room = (size: number, above: number) => Math.max(1, size - 2 * marginOf(size) - above);
  const wanted = Math.min(most, room(view.width, 0) / width, room(view.height, TOOLS) / height);
  const zoom = Math.min(ZOOM_LIMITS.most, Math.max(ZOOM_LIMITS.least, wanted));
  const y = (box.top + box.bottom) / 2 - TOOLS / 2 / zoom;
  return { ...view, x: (box.left + box.right) / 2, y, zoom };
}

/** How the level is shown on the minimap: px of the map per px of the level, and the point of the level in its middle. */
export interface MapView extends Point {
  readonly scale: number;
}

/** px of the map around the level */
const MAP_MARGIN = 8;

/** Shows a box of the level completely. @param width px @param height px */
export function mapViewOf({ left, top, right, bottom }: Box, width: number, height: number): MapView {
  const scale = Math.min(
    (width - 2 * MAP_MARGIN) / Math.max(1, right - left),
    (height - 2 * MAP_MARGIN) / Math.max(1, bottom - top),
  );
  return { x: (left + right) / 2, y: (top + bottom) / 2, scale };
}

/** Whether all of a box is in view: then a minimap says nothing. */
export function isAllInView({ left, top, right, bottom }: Box, view: View): boolean {
  const [halfWidth, halfHeight] = [view.width / 2 / view.zoom, view.height / 2 / view.zoom];
  const isWithin = left >= view.x - halfWidth && right <= view.x + halfWidth;
  return isWithin && top >= view.y - halfHeight && bottom <= view.y + halfHeight;
}

/** The point of the level at a point of the map, px from its top left. */
export const fromMap = (map: MapView, at: Point, width: number, height: number): Point => ({
  x: map.x + (at.x - width / 2) / map.scale,
  y: map.y + (at.y - height / 2) / map.scale,
});

/** A tick of a ruler. */
interface Tick {
  /** px of the level */
  readonly value: number;
  /** px of screen from the start of the ruler */
  readonly at: number;
  /** Whether it has a number. */
  readonly isLong: boolean;
}

/** px of screen between two numbers at least */
const ROOM = 64;
/** short ticks per number */
const PARTS = 5;

/** The round step whose numbers have room: 1, 2 or 5 times a power of ten, at least 1 px. @param zoom px of screen per px of the level */
export function stepFor(zoom: number): number {
  const least = Math.max(1, ROOM / zoom);
  const power = 10 ** Math.floor(Math.log10(least));
  return ([1, 2, 5, 10].find((factor) => factor * power >= least) ?? 10) * power;
}

/**
 * The ticks of a ruler.
 * @param from px of the level at its start
 * @param length px of screen
 * @param zoom px of screen per px of the level
 */
export function ticksOf(from: number, length: number, zoom: number): Tick[] {
  const small = stepFor(zoom) / PARTS;
  const ticks: Tick[] = [];
  for (let k = Math.ceil(from / small); (k * small - from) * zoom <= length; k++) {
    ticks.push({ value: k * small + 0, at: (k * small - from) * zoom, isLong: k % PARTS === 0 });
  }
  return ticks;
}
