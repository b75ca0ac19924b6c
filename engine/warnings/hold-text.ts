import type { Hold } from '../../schema/basics/index.ts';

/** A hold as it stands in a file. */
export const holdText = ([press, release]: Hold): string => `[${press}, ${release}]`;
