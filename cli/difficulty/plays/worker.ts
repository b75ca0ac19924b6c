export { readPlays as default } from './read-plays.ts';
