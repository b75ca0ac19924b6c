import { TICK } from '../../engine/index.ts';
import type { Closest, Effort } from '../../solver/index.ts';
import { holdsInWords } from './holds.ts';
import { plural } from './plural.ts';

/** `12 runs, 3456 ticks`. */
export const effortInWords = ({ runs, ticks }: Effort): string => `${plural(runs, 'run')}, ${plural(ticks, 'tick')}`;

/** How near any run came, and which. */
export const closestInWords = ({ distance, tick, holds }: Closest): string =>
  `${distance.toFixed(1)} px from the black hole at ${(tick * TICK).toFixed(2)} s, by --holds ${holdsInWords(holds)}`;
