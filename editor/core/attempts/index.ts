export { type AttemptKeeper, createAttemptKeeper } from './attempt-keeper.ts';
export { type Attempt, type Attempts, attemptInWords, attemptsAt } from './attempts.ts';
export { causeInWords } from './cause-in-words.ts';
export { openIndexedDbAttempts } from './indexed-db-attempts.ts';
