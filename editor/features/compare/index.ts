export { sourceKey } from './compared.ts';
export { compareOrTell, useComparedRows } from './compared-rows.ts';
export { useDifference } from './use-difference.ts';
