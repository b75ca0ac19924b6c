export { leaveRange, range } from './range.ts';
