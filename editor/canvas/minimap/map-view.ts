import type { Box, Point, View } from '../view.ts';

/** How the level is shown on the minimap: px of the map per px of the level, and the point of the level in its middle. */
export interface MapView extends Point {
  readonly scale: number;
}

/** px of the map around the level */
const MARGIN = 8;

/** Shows a box of the level completely. @param width px @param height px */
export function mapViewOf({ left, top, right, bottom }: Box, width: number, height: number): MapView {
  const scale = Math.min((width - 2 * MARGIN) / Math.max(1, right - left), (height - 2 * MARGIN) / Math.max(1, bottom - top));
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
