export { type AttemptKeeper, createAttemptKeeper } from './attempt-keeper.ts';
export { openIndexedDbAttempts } from './attempt-store.ts';
export { type Attempt, type Attempts, attemptInWords, attemptsAt, causeInWords } from './attempts.ts';
