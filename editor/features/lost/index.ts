export { lostFromInWords, sinceInWords } from './loss-words.ts';
export { type LostFindings, lossKey, lostOf } from './lost-store.ts';
