export { useAtRest, useInPace, useQuestion, type Wanted } from './hooks.ts';
export { oneAtATime } from './one-at-a-time.ts';
export { type Asked, type Desk, type Question, question } from './question.ts';
export { after, afterRest } from './waits.ts';
