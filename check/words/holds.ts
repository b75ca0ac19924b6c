import type { Hold } from '../../schema/index.ts';

/** Formats holds as `--holds` takes them: `12-96,130-188`, or `none`. */
export const holdsInWords = (holds: readonly Hold[]): string =>
  holds.length === 0 ? 'none' : holds.map(([press, release]) => `${press}-${release}`).join(',');
