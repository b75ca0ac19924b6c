import { TICK } from '../../engine/index.ts';
import type { Closest, Effort } from '../../solver/index.ts';
import { plural } from './plural.ts';

/** `12 runs, 3456 ticks`. */
export const effortInWords = ({ runs, ticks }: Effort): string => `${plural(runs, 'run')}, ${plural(ticks, 'tick')}`;

/**
 * How near any run of a search came: `41.7 px from the black hole at 3.22 s`.
 * @param pixels writes a length, px
 */
export const closestInWords = (
  { distance, tick }: Pick<Closest, 'distance' | 'tick'>,
  pixels = (length: number): string => `${length.toFixed(1)} px`,
): string => `${pixels(distance)} from the black hole at ${(tick * TICK).toFixed(2)} s`;
