import type { Point } from './view.ts';

/** A figure beside a place of the level. */
export interface Measure {
  readonly words: string;
  readonly at: Point;
}
