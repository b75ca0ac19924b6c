import {
  appearanceOfObject,
  KINDS,
  type Level,
  LISTED_KINDS,
  listOf,
  OBJECT_KINDS,
  type ObjectKind,
  placesIn,
  rulesOf,
} from '../schema/index.ts';
import { IN_PICTURE, type Look } from './kinds/index.ts';
import type { Theme } from './theme.ts';
import { place, type Thing, thingsOf, type View } from './view.ts';
import { num } from './xml.ts';

/**
 * From this many objects on, in a picture of this width, each is drawn as a speck. Details would be too small to see, and the
 * file too large to open.
 */
const SPECKS_FROM = { objects: 1500, width: 960 };

/** The least radius in the picture, units; smaller objects are drawn larger. */
const LEAST = 4;

/** A ring around an object that is drawn larger than it is, so that its drawing is not taken for its size. */
const drawRing = (radius: number, view: View, theme: Theme): string =>
  `<circle r="${num(2 * radius)}" fill="none" stroke="${theme.text}" stroke-opacity=".6" stroke-width="${num(0.8 / view.scale)}"/>`;

/**
 * Draws all objects but the astronaut, from the back to the front.
 * @param width width of the picture, px
 */
export function drawObjects(view: View, theme: Theme, level: Level, width: number): string {
  const count = LISTED_KINDS.reduce((sum, kind) => sum + level[listOf(kind)].length, 0);
  const crowded = count >= SPECKS_FROM.objects * Math.min(1, width / SPECKS_FROM.width);
  const least = LEAST / view.scale;
  const rules = rulesOf(level);
  const drawDisc = (kind: ObjectKind, look: Look<object>): string => {
    const { draw } = IN_PICTURE[kind];
    return look.radius < least ? draw({ ...look, radius: least }) + drawRing(least, view, theme) : draw(look);
  };
  const drawOne = (kind: ObjectKind, object: Thing, index: number, nth: number): string => {
    const { draw, speck, between } = IN_PICTURE[kind];
    const look = { object, place: nth, radius: object.radius ?? 0, index, theme, rules };
    if (KINDS[kind].list === null) return draw(look);
    if (crowded) return speck(look);
    return (nth === 0 ? (between?.(look) ?? '') : '') + drawDisc(kind, look);
  };
  const layers: { readonly depth: number; readonly draw: () => string }[] = [];
  for (const kind of OBJECT_KINDS) {
    const { depth, around } = IN_PICTURE[kind];
    const put = (name: (object: Thing) => string, draw: (object: Thing, index: number, nth: number) => string): string =>
      thingsOf(level, kind)
        .flatMap((object, i) => placesIn(kind, object).map((at, nth) => place(view, name(object), i, at, draw(object, i, nth))))
        .join('');
    const nameOf = (object: Thing): string => appearanceOfObject(kind, object).one.replaceAll(' ', '-');
    if (depth !== null) layers.push({ depth, draw: () => put(nameOf, (object, i, nth) => drawOne(kind, object, i, nth)) });
    if (around === undefined || crowded) continue;
    const { name, draw } = around;
    layers.push({
      depth: around.depth,
      draw: () =>
        put(
          () => name,
          () => draw(theme, rules),
        ),
    });
  }
  return layers
    .sort((a, b) => a.depth - b.depth)
    .map(({ draw }) => draw())
    .join('');
}
