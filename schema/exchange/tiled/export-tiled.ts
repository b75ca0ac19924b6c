import { fieldsOf, KINDS, OBJECT_KINDS, type ObjectKind } from '../../basics/index.ts';
import type { Json } from '../../json/index.ts';
import { type LevelFile, objectsOfFile } from '../../level/index.ts';
import {
  EXACT,
  MAP_KEYS,
  OFFSET,
  PARTNER,
  POINT_KINDS,
  type TiledLayer,
  type TiledMap,
  type TiledObject,
  type TiledProperty,
} from './map.ts';

/** The grid of the map, px. */
const TILE = 32;

/** Space around the level, px. */
const MARGIN = 2 * TILE;

/** Most tiles in a row or column: a larger grid would take Tiled long to draw. Objects may lie beyond it. */
const MOST_TILES = 10_000;

/** The colours of layers in Tiled, for the kinds in their order. */
const COLORS = ['#ffffff', '#b388ff', '#b0bec5', '#ff7043', '#26c6da', '#9ccc65', '#ffee58', '#42a5f5', '#ec407a'];

const colorOf = (kind: ObjectKind): string => COLORS[OBJECT_KINDS.indexOf(kind) % COLORS.length];

interface Located {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

const radiusOf = (kind: ObjectKind, object: Json): number => {
  const field = KINDS[kind].fields.radius;
  return (object.radius as number | undefined) ?? (field?.type === 'number' ? (field.default ?? 0) : 0);
};

const discsOf = (kind: ObjectKind, object: Json): Located[] =>
  KINDS[kind].places.map(([x, y]) => ({ x: object[x] as number, y: object[y] as number, radius: radiusOf(kind, object) }));

/** How far the level is moved along an axis, and how many tiles it takes. */
function extent(discs: readonly Located[], axis: 'x' | 'y'): { offset: number; tiles: number } {
  let least = Number.POSITIVE_INFINITY;
  let most = Number.NEGATIVE_INFINITY;
  for (const disc of discs) {
    least = Math.min(least, disc[axis] - disc.radius);
    most = Math.max(most, disc[axis] + disc.radius);
  }
  // a level that lies to the right of the origin keeps its numbers
  const offset = least < 0 ? Math.ceil((MARGIN - least) / TILE) * TILE : 0;
  return { offset, tiles: Math.min(MOST_TILES, Math.ceil((most + offset + MARGIN) / TILE)) };
}

const property = (name: string, value: string | number | boolean): TiledProperty => {
  const type = typeof value === 'string' ? 'string' : typeof value === 'number' ? 'float' : 'bool';
  return { name, type, value };
};

/** x- keys as properties; their values are written as JSON, which is what they are. */
const ownKeys = (object: Json): TiledProperty[] =>
  Object.entries(object)
    .filter(([key, value]) => key.startsWith('x-') && value !== undefined)
    .map(([key, value]) => property(key, JSON.stringify(value)));

/** Writes places and sizes of objects for a map whose level is moved. */
class Drawing {
  nextId = 1;
  readonly offset: readonly [x: number, y: number];

  constructor(offset: readonly [x: number, y: number]) {
    this.offset = offset;
  }

  /** An object at a place of the level: a point, or a circle if it has a radius. */
  object(
    kind: ObjectKind,
    place: readonly [x: number, y: number],
    radius: number | null,
    rest: readonly TiledProperty[],
  ): TiledObject {
    const half = radius ?? 0;
    const properties: TiledProperty[] = [];
    const [x, y] = place.map((at, i) => {
      const value = at + this.offset[i] - half + 0;
      if (value + half - this.offset[i] !== at) properties.push(property(EXACT[i], at));
      return value;
    });
    properties.push(...rest);
    return {
      id: this.nextId++,
      name: '',
      type: kind,
      x,
      y,
      width: 2 * half,
      height: 2 * half,
      rotation: 0,
      visible: true,
      ...(radius === null ? { point: true } : { ellipse: true }),
      ...(properties.length === 0 ? {} : { properties }),
    };
  }

  /** The objects of the map that stand for one object of the level: one for each of its places. */
  objects(kind: ObjectKind, object: Json): TiledObject[] {
    const { places, radius } = KINDS[kind];
    const isPoint = POINT_KINDS.includes(kind);
    const drawn: readonly string[] = [...places.flat(), ...(isPoint ? [] : [radius ?? ''])];
    const rest = fieldsOf(kind).flatMap(([name]) => {
      const value = object[name];
      return value === undefined || drawn.includes(name) ? [] : [property(name, value as number | boolean)];
    });
    const own = [...(object.id === undefined ? [] : [property('id', object.id as string)]), ...rest, ...ownKeys(object)];
    const size = isPoint ? null : radiusOf(kind, object);
    const placeOf = ([x, y]: readonly [string, string]) => [(object[x] as number) + 0, (object[y] as number) + 0] as const;
    // the partner has the next id
    const partner: TiledProperty[] = places.length > 1 ? [{ name: PARTNER, type: 'object', value: this.nextId + 1 }] : [];
    const [first, ...others] = places;
    const main = this.object(kind, placeOf(first), size, [...own, ...partner]);
    return [main, ...others.map((place) => this.object(kind, placeOf(place), size, []))];
  }
}

/**
 * Turns a level into a Tiled map: a layer of objects for each kind, circles and points whose class is the kind, and everything
 * else as properties. {@link importTiled} reads it back as the same level.
 *
 * @param file - the content of a valid level file
 * @returns the map, in Tiled's JSON map format
 */
export function exportTiled(file: LevelFile): TiledMap {
  const discs = OBJECT_KINDS.flatMap((kind) => objectsOfFile(file, kind).flatMap((object) => discsOf(kind, object)));
  const [across, down] = [extent(discs, 'x'), extent(discs, 'y')];
  const drawing = new Drawing([across.offset, down.offset]);
  const layers = OBJECT_KINDS.map((kind, i): TiledLayer => {
    const objects = objectsOfFile(file, kind).flatMap((object) => drawing.objects(kind, object));
    const name = KINDS[kind].list ?? kind;
    const look = { draworder: 'index', color: colorOf(kind), opacity: 1, visible: true, x: 0, y: 0 } as const;
    return { id: i + 1, name, type: 'objectgroup', ...look, objects };
  });
  const known = Object.entries(MAP_KEYS).flatMap(([key, isText]) => {
    const value = (file as unknown as Json)[key];
    return value === undefined ? [] : [property(key, isText ? JSON.stringify(value) : (value as string | number | boolean))];
  });
  const moved = OFFSET.flatMap((name, i) => (drawing.offset[i] === 0 ? [] : [property(name, drawing.offset[i])]));
  return {
    type: 'map',
    version: '1.10',
    tiledversion: '1.10.2',
    orientation: 'orthogonal',
    renderorder: 'right-down',
    infinite: false,
    compressionlevel: -1,
    width: across.tiles,
    height: down.tiles,
    tilewidth: TILE,
    tileheight: TILE,
    nextlayerid: layers.length + 1,
    nextobjectid: drawing.nextId,
    class: 'level',
    backgroundcolor: '#0b1020',
    properties: [...known, ...moved, ...ownKeys(file as unknown as Json)],
    layers,
    tilesets: [],
  };
}

const lines = (rows: readonly string[], indent: string): string =>
  rows.length === 0 ? '[]' : `[\n${rows.map((row) => `${indent} ${row}`).join(',\n')}\n${indent}]`;

const members = (object: object, indent: string, format: (key: string, value: unknown) => string | null): string =>
  Object.entries(object)
    .map(([key, value]) => `${indent}${JSON.stringify(key)}: ${format(key, value) ?? JSON.stringify(value)}`)
    .join(',\n');

/**
 * Writes a Tiled map as a JSON file (`.tmj`), one object or property a line.
 *
 * @param map - the map
 * @returns the text of the file
 */
export function formatTiled(map: TiledMap): string {
  const rows = (list: readonly unknown[], indent: string): string =>
    lines(
      list.map((one) => JSON.stringify(one)),
      indent,
    );
  const layer = (one: TiledLayer): string =>
    `{\n${members(one, '   ', (key, value) => (key === 'objects' ? rows(value as readonly unknown[], '   ') : null))}\n  }`;
  const text = members(map, ' ', (key, value) => {
    if (key === 'properties') return rows(value as readonly unknown[], ' ');
    return key === 'layers' ? lines((value as readonly TiledLayer[]).map(layer), ' ') : null;
  });
  return `{\n${text}\n}\n`;
}
