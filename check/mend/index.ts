export { createMend, type Mend, type Mended, type MendOptions } from './mend.ts';
export { mendedInWords } from './mended-in-words.ts';
export { distanceOf, type TakenBack, takenBack, valueAfter } from './take-back.ts';
export { isMove, isNumeric, type Unit, unitsOf } from './units.ts';
