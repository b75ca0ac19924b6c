import type { Level } from '../../../schema/basics/index.ts';
import { circlesOf, type IndexedCircles, indexed } from '../../indexed-circles.ts';
import type { Scene } from '../../scene.ts';
import type { Indexing } from '../../spatial-index.ts';

/** The winds of a scene: discs, and the acceleration in each, px/s². */
export interface Winds extends IndexedCircles {
  readonly ax: Float64Array;
  readonly ay: Float64Array;
}

export function windsOf({ winds }: Level, indexing: Indexing): Winds {
  const { count, x, y, r, index, spatial } = indexed(circlesOf(winds, [...winds.keys()]), indexing);
  return { count, x, y, r, index, spatial, ax: Float64Array.from(winds, (w) => w.ax), ay: Float64Array.from(winds, (w) => w.ay) };
}

/** The winds that `prepare` made for a compiled scene. */
export const preparedWinds = (scene: Scene): Winds => scene.own.winds as Winds;

/** Upper bound of her acceleration by winds, px/s²: that of all together, since discs may overlap. */
export const strongestWind = ({ winds }: Level): number =>
  winds.reduce((sum, { ax, ay }) => sum + Math.sqrt(ax * ax + ay * ay), 0);
