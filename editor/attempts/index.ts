export { type Attempt, type Attempts, attemptInWords, createAttempts } from './attempts.ts';
