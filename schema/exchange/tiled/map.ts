import { KINDS, OBJECT_KINDS } from '../../basics/index.ts';
import { LEVEL_SHAPE } from '../../level/index.ts';

/** A custom property in a Tiled map. */
export interface TiledProperty {
  /** Its name. */
  readonly name: string;
  /** The type of its value, as Tiled calls it. */
  readonly type: 'string' | 'int' | 'float' | 'bool' | 'object';
  /** Its value; for an object, that object's number. */
  readonly value: string | number | boolean;
}

/** An object in a Tiled map, as Tiled's JSON map format has it. */
export interface TiledObject {
  /** Its number, unique in the map. */
  readonly id: number;
  /** Its name; empty. */
  readonly name: string;
  /** The class; Tiled 1.9 calls it `class`, all other versions `type`. */
  readonly type: string;
  /** The left edge of an ellipse, or the place of a point; px. */
  readonly x: number;
  /** The upper edge of an ellipse, or the place of a point; px. */
  readonly y: number;
  /** Width of an ellipse; 0 for a point; px. */
  readonly width: number;
  /** Height, the same as the width; px. */
  readonly height: number;
  /** Angle in degrees. */
  readonly rotation: 0;
  /** Whether it is shown. */
  readonly visible: true;
  /** There for an ellipse. */
  readonly ellipse?: true;
  /** There for a point. */
  readonly point?: true;
  /** Its custom properties; missing if there are none. */
  readonly properties?: readonly TiledProperty[];
}

/** A layer of objects. */
export interface TiledLayer {
  /** Its number, unique in the map. */
  readonly id: number;
  /** The list of a level file, or the kind of which there is one. */
  readonly name: string;
  /** A layer of objects. */
  readonly type: 'objectgroup';
  /** Objects are drawn in the order of the list. */
  readonly draworder: 'index';
  /** The color of its objects in Tiled. */
  readonly color: string;
  /** It is not transparent. */
  readonly opacity: 1;
  /** Whether it is shown. */
  readonly visible: true;
  /** Always 0. */
  readonly x: 0;
  /** Always 0. */
  readonly y: 0;
  /** Its objects, in the order of the level. */
  readonly objects: readonly TiledObject[];
}

/** A Tiled map as {@link exportTiled} makes it: a plain JSON value in Tiled's JSON map format. */
export interface TiledMap {
  /** Tells maps from other files of Tiled. */
  readonly type: 'map';
  /** The version of the format. */
  readonly version: string;
  /** The version of Tiled that writes the same format. */
  readonly tiledversion: string;
  /** Places in the map are the places that are seen. */
  readonly orientation: 'orthogonal';
  /** The order in which tiles are drawn; there are none. */
  readonly renderorder: 'right-down';
  /** It has a size. */
  readonly infinite: false;
  /** As Tiled writes it. */
  readonly compressionlevel: -1;
  /** Number of columns of tiles. */
  readonly width: number;
  /** Number of rows of tiles. */
  readonly height: number;
  /** Width of a tile, px. */
  readonly tilewidth: number;
  /** Height of a tile, px. */
  readonly tileheight: number;
  /** The number of the next layer. */
  readonly nextlayerid: number;
  /** The number of the next object. */
  readonly nextobjectid: number;
  /** What the map is. */
  readonly class: string;
  /** The color behind the objects. */
  readonly backgroundcolor: string;
  /** What the level says besides its objects. */
  readonly properties: readonly TiledProperty[];
  /** A layer for each kind of object. */
  readonly layers: readonly TiledLayer[];
  /** None. */
  readonly tilesets: readonly never[];
}

/** The kinds of objects that are points in a map: too small for a circle that can be grabbed, or without a radius. */
export const POINT_KINDS: readonly string[] = ['astronaut', 'mineral'];

/** The property of the first of two mouths that names the second. */
export const PARTNER = 'to';

/** Properties of the map: how far the level is moved to the right and down, so that all of it lies in the map. */
export const OFFSET = ['offsetX', 'offsetY'] as const;

/** Properties of an object: its place, where the numbers of the map don't give it to the last bit. */
export const EXACT = ['exactX', 'exactY'] as const;

/** Keys of a level file that the layers of the map stand for, or that only a file has. */
const ELSEWHERE: readonly string[] = ['$schema', 'version', ...OBJECT_KINDS.map((kind) => KINDS[kind].list ?? kind)];

/** Keys of a level file whose values are texts, numbers or flags. */
const PLAIN: readonly string[] = ['name', 'description', 'range', 'recoil'];

/** Keys of a level file that are properties of the map; those with `true` are written as JSON text. */
export const MAP_KEYS: Readonly<Record<string, boolean>> = Object.fromEntries(
  Object.keys(LEVEL_SHAPE.keys)
    .filter((key) => !ELSEWHERE.includes(key))
    .map((key) => [key, !PLAIN.includes(key)]),
);
