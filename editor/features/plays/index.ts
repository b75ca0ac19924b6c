export { droppedFiles } from './choose-plays.ts';
export { openPlayFiles, type Reading, readingOf } from './open-plays.ts';
export { copyPlay, copyPlayLink, type SharedPlay, savePlay } from './share-play.ts';
