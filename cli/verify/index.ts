export { linesOf, readLine } from './lines.ts';
export { startThreads } from './threads.ts';
export { PlayDesk, type PlayItem, verifyInOrder } from './verify-plays.ts';
