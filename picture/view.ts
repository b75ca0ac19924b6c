import { boxOf } from '../engine/index.ts';
import { type Level, OBJECT_KINDS, placesIn, rulesOf } from '../schema/index.ts';
import { IN_PICTURE } from './kinds/index.ts';
import { thingsOf } from './things.ts';

/** The part of the level that the picture shows, and how level px become units of the picture (one scale for both axes). */
export interface View {
  /** Units of the picture; the SVG's viewBox is as wide. */
  readonly width: number;
  /** Height of the scene, without the caption. */
  readonly height: number;
  /** Units of the picture a level px takes. */
  readonly scale: number;
  x(x: number): number;
  y(y: number): number;
}

/** Room around what matters, level px. */
const MARGIN = 36;

/** Around the astronaut's centre, level px; more where her box needs it. */
const AROUND_HER = 20;

/** A level that is smaller than this is not blown up further, level px. */
const SMALLEST = 420;

/** Height over width of the scene stays within these. */
const FLATTEST = 0.42;
const TALLEST = 1.15;

/**
 * Frames everything that matters: objects, the astronaut and her way; of the range discs only what falls inside.
 * @param way points of the run in level px, flat: x, y, x, y …
 * @param width units of the picture
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
