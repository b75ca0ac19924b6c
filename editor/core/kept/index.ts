export { keptWith } from './kept-with.ts';
