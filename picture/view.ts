import { boxOf } from '../engine/index.ts';
import { type Level, OBJECT_KINDS, type ObjectKind, objectsIn, type Place, placesIn, rulesOf } from '../schema/basics/index.ts';
import { IN_PICTURE } from './kinds/index.ts';
import { num, polyline } from './xml.ts';

/**
 * The part of the level that the picture shows, and the conversion of level px into units of the picture, with one scale for
 * both axes.
 */
export interface View {
  /** Width in units of the picture, which is the width of the SVG's viewBox. */
  readonly width: number;
  /** Height of the scene in units, without the caption. */
  readonly height: number;
  /** Units of the picture per px of the level. */
  readonly scale: number;
  x(x: number): number;
  y(y: number): number;
}

/** Room around the contents, px of the level. */
const MARGIN = 36;

/** Room around the astronaut's centre, px of the level; more if her box needs it. */
const AROUND_HER = 20;

/** A level smaller than this is not enlarged any further, px of the level. */
const SMALLEST = 420;

/** The least and the greatest ratio of height to width of the scene. */
const FLATTEST = 0.42;
const TALLEST = 1.15;

/**
 * Frames the objects, the astronaut and her path, and as much of the ranges as falls inside.
 * @param way points of her path, px of the level
 * @param width width of the picture in units
 */
export function frame(level: Level, way: readonly (readonly [number, number])[], width: number): View {
  let left = Number.POSITIVE_INFINITY;
  let top = Number.POSITIVE_INFINITY;
  let right = Number.NEGATIVE_INFINITY;
  let bottom = Number.NEGATIVE_INFINITY;
  const include = (x: number, y: number, r: number): void => {
    left = Math.min(left, x - r);
    top = Math.min(top, y - r);
    right = Math.max(right, x + r);
    bottom = Math.max(bottom, y + r);
  };
  const aroundHer = Math.max(AROUND_HER, boxOf(rulesOf(level)).halfDiagonal);
  for (const kind of OBJECT_KINDS) {
    const { reach = 1 } = IN_PICTURE[kind];
    for (const object of thingsOf(level, kind)) {
      const around = object.radius === undefined ? aroundHer : reach * object.radius;
      for (const { x, y } of placesIn(kind, object)) include(x, y, around);
    }
  }
  for (const [x, y] of way) include(x, y, aroundHer);

  const centreX = (left + right) / 2;
  const centreY = (top + bottom) / 2;
  let spanX = Math.max(SMALLEST, right - left + 2 * MARGIN);
  let spanY = bottom - top + 2 * MARGIN;
  spanY = Math.max(spanY, FLATTEST * spanX);
  spanX = Math.max(spanX, spanY / TALLEST);
  const scale = width / spanX;
  return {
    width,
    height: Math.round(spanY * scale),
    scale,
    x: (x) => (x - centreX + spanX / 2) * scale,
    y: (y) => (y - centreY + spanY / 2) * scale,
  };
}

/** An object of a level; the astronaut has no radius. */
export interface Thing {
  readonly x: number;
  readonly y: number;
  readonly radius?: number;
}

/** The level's objects of one kind. */
export const thingsOf = (level: Level, kind: ObjectKind): readonly Thing[] => objectsIn(level, kind);

/** A line through points of the level, as the data of a path. */
export const lineThrough = (view: View, points: readonly (readonly [x: number, y: number])[], close = false): string =>
  polyline(
    points.map(([x, y]) => [view.x(x), view.y(y)]),
    close,
  );

/** Moves a drawing, which is centred on the origin in px of the level, to its place in the level. */
export function place(view: View, kind: string, index: number, at: Place, drawing: string): string {
  const scale = Number(view.scale.toFixed(6));
  return (
    `<g data-kind="${kind}" data-index="${index}" transform="translate(${num(view.x(at.x))} ${num(view.y(at.y))}) ` +
    `scale(${scale})">${drawing}</g>`
  );
}
