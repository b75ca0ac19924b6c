export { LostLegend } from './LostLegend.tsx';
export { lossInWords, lostFromInWords, sinceInWords } from './loss-words.ts';
export { type LostPicture, type LostWay, lostPictureOf } from './lost-picture.ts';
export { type LostFindings, lossKey, lostOf } from './lost-store.ts';
export { lostInWords } from './lost-words.ts';
export { LOST_SQUARE, type LostSquare } from './squares.ts';
export { useRunLoss } from './use-run-loss.ts';
export { LOST_KEY, type LostSession, watchLost } from './watch-lost.ts';
