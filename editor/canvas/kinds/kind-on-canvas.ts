import type { LucideIcon } from 'lucide-react';
import type { Pose } from '../../context/index.ts';
import type { FoundObject } from '../../document/index.ts';
import type { Brush } from '../brush.ts';
import type { Colours, Theme } from '../colours.ts';
import type { Thing } from '../thing.ts';
import type { Point } from '../view.ts';

/** What stands for a kind beside its name, in tools and lists. */
export interface Sign {
  readonly Icon: LucideIcon;
  readonly tone: 'quiet' | 'bad' | 'good' | 'accent' | 'unknown';
}

/** Draws a texture: the unit circle is what is touched, or a share of it as the part says that shows it. */
export type DrawTexture = (brush: Brush, colours: Colours, theme: Theme) => void;

/** One of the images of which an object is made. */
export interface Part {
  readonly texture: string;
  /** Which is drawn above which; of one depth, in the order of the parts. */
  readonly depth: number;
  /** Radius of the texture's unit circle, in radii of the object; 1 when left out. */
  readonly scale?: number;
  /** Where its middle is from the object's, in radii. */
  readonly offset?: Point;
  /** Radians, clockwise. */
  readonly rotation?: number;
}

/** An object as it is shown at one of its places. */
export interface Figure {
  readonly found: FoundObject;
  /** Where the level has it, px. */
  readonly at: Point;
  /** px */
  readonly radius: number;
  readonly parts: readonly Part[];
  /** The image of each part. */
  readonly images: readonly Pick<Thing, 'alpha' | 'scale' | 'setAlpha' | 'setPosition' | 'setRotation'>[];
  /** How far each image is away from where its part has it, px; the kind's own, kept while the object is there. */
  readonly away: readonly { x: number; y: number }[];
}

/** How a kind of object is drawn on the canvas. */
export interface KindOnCanvas {
  readonly sign: Sign;
  /** Of those of its variant. */
  readonly variantSign?: Sign;
  /** By their names, which no other kind has. */
  readonly textures: Readonly<Record<string, DrawTexture>>;
  /** What an object is made of, from below to above. */
  parts(found: FoundObject): readonly Part[];
  /**
   * Shows it as it is in a run. Left out: it stays as the level has it.
   * @param pose null: as the level has it
   * @param zoom px of screen per px of the level
   */
  pose?(figure: Figure, pose: Pose | null, zoom: number): void;
  /** Turns what turns by itself. @param time s */
  turn?(figure: Figure, time: number, zoom: number): void;
}

/** Puts a figure where it is now. */
export function put({ parts, images, away, radius }: Figure, x: number, y: number): void {
  // thousands in a frame
  for (let i = 0; i < images.length; i++) {
    const { offset } = parts[i];
    images[i].setPosition(x + (offset?.x ?? 0) * radius + away[i].x, y + (offset?.y ?? 0) * radius + away[i].y);
  }
}
