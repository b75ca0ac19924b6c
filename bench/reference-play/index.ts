export { type Played, play, type Sample } from './play.ts';
export { NotCovered } from './flow.ts';
