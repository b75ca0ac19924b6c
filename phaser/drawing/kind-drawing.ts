import type { Brush } from './brush.ts';
import type { GameColours, Theme } from './colours.ts';

/** Draws a texture. Its unit circle is the rim of the object, scaled by the part that uses the texture. */
export type DrawTexture = (brush: Brush, colours: GameColours, theme: Theme) => void;

/** One of the images that an object consists of. */
export interface Part {
  /** The name of its texture. */
  readonly texture: string;
  /** Greater depths are drawn above; parts of equal depth in their order. */
  readonly depth: number;
  /** Radius of the texture's unit circle, in radii of the object; 1 if absent. */
  readonly scale?: number;
  /** Its centre relative to the object's, in radii. */
  readonly offset?: { readonly x: number; readonly y: number };
  /** radians, clockwise */
  readonly rotation?: number;
}

/** How a kind of object is drawn, in the editor and by the default skin. */
export interface KindDrawing<Look = unknown> {
  /** By name; names are unique across kinds. */
  readonly textures: Readonly<Record<string, DrawTexture>>;
  /** How fast its first part turns, radians per second. */
  readonly spin: number;
  /**
   * The parts of an object, from below to above.
   *
   * @param object - the object, of which only what changes its look is read
   * @param key - its id or another name that it keeps, for a shape of its own
   */
  parts(object: Look, key?: string): readonly Part[];
}
