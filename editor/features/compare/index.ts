export { sourceKey } from './compared.ts';
export { useComparedRows } from './compared-rows.ts';
export { compareOrTell } from './show-compared.ts';
export { useDifference } from './use-difference.ts';
