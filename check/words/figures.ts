import { TICK } from '../../engine/basics/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Closest, Effort } from '../../solver/index.ts';

/** Formats a number with its noun: `1 level`, `2 levels`. */
export const plural = (count: number, one: string, many = `${one}s`): string => `${count} ${count === 1 ? one : many}`;

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

/** Formats holds as `--holds` takes them: `12-96,130-188`, or `none`. */
export const holdsInWords = (holds: readonly Hold[]): string =>
  holds.length === 0 ? 'none' : holds.map(([press, release]) => `${press}-${release}`).join(',');
