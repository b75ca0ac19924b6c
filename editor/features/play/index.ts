export { attemptGhosts } from './attempt-ghosts.ts';
export { keepAsRun, keepHolds, makeProof } from './keep-attempt.ts';
export { PlayView } from './PlayView.tsx';
export { playCommands } from './play-commands.ts';
export { ReplayView } from './ReplayView.tsx';
