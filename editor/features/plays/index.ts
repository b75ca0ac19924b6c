export { droppedFiles } from './choose-plays.ts';
export { followPlayLinks, takeLinkedPlay } from './follow-play-links.ts';
export { openPlayFiles, type Reading, readingOf } from './open-plays.ts';
export { playsCommands } from './plays-commands.ts';
export { copyPlay, copyPlayLink, type SharedPlay, savePlay } from './share-play.ts';
