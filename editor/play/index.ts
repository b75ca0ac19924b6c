export { attemptGhosts } from './attempt-ghosts.ts';
export { type Attempt, type Attempts, createAttempts } from './attempts.ts';
export { PlayView } from './PlayView.tsx';
export { playCommands } from './play-commands.ts';
