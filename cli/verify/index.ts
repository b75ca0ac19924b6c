export { itemOf, itemOfFile, itemOfLine, linesOf, readLine } from './lines.ts';
export {
  addPlayOptions,
  deskSettings,
  expectAsPlanned,
  type PlayJobSettings,
  type PlayOptions,
  planned,
  playAccuracyOption,
  playSettings,
  unusableInWords,
  unusableLevels,
} from './play-options.ts';
export { countsPretty, playPretty } from './pretty.ts';
export { startThreads } from './threads.ts';
export { PlayDesk, type PlayItem, verifyInOrder } from './verify-plays.ts';
