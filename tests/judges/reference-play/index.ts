export { NotCovered } from './not-covered.ts';
export { type Played, play, type Sample } from './play.ts';
