export { type Attempt, type Attempts, attemptInWords, attemptsAt } from './attempts.ts';
export { causeInWords } from './cause-in-words.ts';
