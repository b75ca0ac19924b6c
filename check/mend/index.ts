export { createMend, type Mend, type Mended, type MendOptions, repairedFile } from './mend.ts';
export { mendedInWords } from './mended-in-words.ts';
export { takenBack } from './take-back.ts';
export { unitsOf } from './units.ts';
