export { groupPlays, levelsByHash, openPlayFiles, openPlays, type Reading, readingOf } from './open-plays.ts';
export { choosePlayFolder, choosePlays, copyPlay, copyPlayLink, droppedFiles, type SharedPlay, savePlay } from './play-files.ts';
