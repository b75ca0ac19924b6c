export { Memory } from './memory.ts';
export { watchAndRepeat } from './watch.ts';
