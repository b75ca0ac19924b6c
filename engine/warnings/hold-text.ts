import type { Hold } from '../../schema/index.ts';

/** A hold as the file writes it. */
export const holdText = ([press, release]: Hold): string => `[${press}, ${release}]`;
