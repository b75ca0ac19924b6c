export { LostLegend } from './LostLegend.tsx';
export { briefLossInWords, lossInWords, lostFromInWords, sinceInWords } from './loss-words.ts';
export { type LostPicture, type LostWay, lostPictureOf, type PathOf } from './lost-picture.ts';
export { type LostFindings, lossKey, lostOf } from './lost-store.ts';
export { countLost, lostInWords } from './lost-words.ts';
export { LOST_SQUARE, type LostSquare, squaresOf } from './squares.ts';
export { useRunLoss } from './use-run-loss.ts';
export { LOST_KEY, type LostSession, watchLost } from './watch-lost.ts';
