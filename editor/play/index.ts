export { attemptGhosts } from './attempt-ghosts.ts';
export { keepAsRun, makeProof } from './keep-attempt.ts';
export { PlayView } from './PlayView.tsx';
export { playCommands } from './play-commands.ts';
