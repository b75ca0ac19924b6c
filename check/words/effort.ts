import { TICK } from '../../engine/basics/index.ts';
import type { Closest, Effort } from '../../solver/index.ts';
import { plural } from './plural.ts';

/** Formats effort: `12 runs, 3456 ticks`. */
export const effortInWords = ({ runs, ticks }: Effort): string => `${plural(runs, 'run')}, ${plural(ticks, 'tick')}`;

/**
 * Formats a closest approach: `41.7 px from the black hole at 3.22 s`.
 * @param pixels formats a length in px
 */
export const closestInWords = (
  { distance, tick }: Pick<Closest, 'distance' | 'tick'>,
  pixels = (length: number): string => `${length.toFixed(1)} px`,
): string => `${pixels(distance)} from the black hole at ${(tick * TICK).toFixed(2)} s`;
