export { ComparedWatch } from './ComparedWatch.tsx';
export {
  type ComparedRun,
  type Comparing,
  chosenOf,
  comparedOf,
  isCompared,
  isFresh,
  MOST_COMPARED,
  type Source,
  sourceHolds,
  sourceKey,
  sourceName,
} from './compared.ts';
export { LOOKS } from './looks.ts';
export { placeOf, type Race, type Racer, raceOf } from './racers.ts';
export { compareOrTell, showCompared } from './show-compared.ts';
export { type ComparedRow, useComparedRows } from './use-compared-rows.ts';
export { type ShownDifference, useDifference } from './use-difference.ts';
