export { type Attempt, type Attempts, attemptInWords, createAttempts } from './attempts.ts';
export { causeInWords } from './cause-in-words.ts';
