export { NotCovered } from './flow.ts';
export { type Played, play, type Sample } from './play.ts';
