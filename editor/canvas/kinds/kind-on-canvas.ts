import type { LucideIcon } from 'lucide-react';
import type { Part } from '../../../phaser/index.ts';
import type { Pose } from '../../core/context/index.ts';
import type { FoundObject } from '../../core/document/index.ts';
import type { Thing } from '../thing.ts';
import type { Point } from '../view.ts';

/** The icon of a kind, in tools and lists. */
export interface Sign {
  readonly Icon: LucideIcon;
  readonly tone: 'quiet' | 'bad' | 'good' | 'accent' | 'unknown';
}

/** An object at one of its places, as shown. */
export interface Figure {
  readonly found: FoundObject;
  /** its place in the level, px */
  readonly at: Point;
  /** px */
  readonly radius: number;
  readonly parts: readonly Part[];
  /** The image of each part. */
  readonly images: readonly Pick<Thing, 'alpha' | 'scale' | 'setAlpha' | 'setPosition' | 'setRotation'>[];
  /**
   * The offset of each image from the place that its part gives it, px; managed by the kind, kept as long as the object exists.
   */
  readonly away: readonly { x: number; y: number }[];
}

/** How a kind of object is drawn on the canvas. */
export interface KindOnCanvas {
  readonly sign: Sign;
  /** The icon of the variant. */
  readonly variantSign?: Sign;
  /** The parts of an object, from below to above. */
  parts(found: FoundObject): readonly Part[];
  /**
   * Shows the object during a run. Without this function it stays in place.
   * @param pose null: as in the level
   * @param zoom px of screen per px of the level
   */
  pose?(figure: Figure, pose: Pose | null, zoom: number): void;
  /** Animates what turns by itself. @param time s */
  turn?(figure: Figure, time: number, zoom: number): void;
}

/** Moves a figure to a place. */
export function put({ parts, images, away, radius }: Figure, x: number, y: number): void {
  // called thousands of times per frame
  for (let i = 0; i < images.length; i++) {
    const { offset } = parts[i];
    images[i].setPosition(x + (offset?.x ?? 0) * radius + away[i].x, y + (offset?.y ?? 0) * radius + away[i].y);
  }
}
