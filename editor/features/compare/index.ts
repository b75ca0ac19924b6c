export { sourceKey } from './compared.ts';
export { compareOrTell, useComparedRows, useDifference } from './compared-rows.ts';
