export { sourceKey } from './compared.ts';
export { compareOrTell } from './show-compared.ts';
export { useComparedRows } from './use-compared-rows.ts';
export { useDifference } from './use-difference.ts';
