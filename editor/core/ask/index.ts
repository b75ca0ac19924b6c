export { useAtRest, useInPace, usePromised, useQuestion, type Wanted } from './hooks.ts';
export { type KeptAnswers, keepAnswers } from './kept-answers.ts';
export { type Asked, askOnce, type Desk, onDemand, type Question, question } from './question.ts';
export { inSlices } from './slices.ts';
export { after, afterRest, whenIdle } from './waits.ts';
