export { hashRandomSet, RANDOM_SET_HASH } from './frozen.ts';
export { layoutOf, RANDOM_SET_SIZE, randomLevel } from './random-level.ts';
