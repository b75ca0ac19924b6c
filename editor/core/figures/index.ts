export type { Fact } from './fact.ts';
export { SLACK_LIMIT, slackText, type Tightest, tightestOf } from './slack.ts';
export { nextTurn, type TurnsOptions, timeInTurns } from './time-in-turns.ts';
export { about, extraInWords, percent, pixels, plural, seconds } from './words.ts';
