export { ComparedWatch } from './ComparedWatch.tsx';
export { comparedOf, isCompared, MOST_COMPARED, sourceKey } from './compared.ts';
export { LOOKS } from './looks.ts';
export { placeOf, type Racer, raceOf } from './racers.ts';
export { compareOrTell, showCompared } from './show-compared.ts';
export { type ComparedRow, useComparedRows } from './use-compared-rows.ts';
export { useDifference } from './use-difference.ts';
