export { changesInWords } from './change-words.ts';
export { effectsInWords, standingInWords } from './effect-words.ts';
export { jsonLine, keyInWords } from './values.ts';
