export { type Choices, type Conflict, type Merged, mergeLevels, type Side } from './merge-levels.ts';
