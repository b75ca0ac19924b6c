export { toNumber } from './double-double.ts';
export { GAUSS_TOLERANCE, gauss } from './gauss/index.ts';
export { apart, type Played, play, type Sample } from './play.ts';
export { type Method, NotCovered } from './stretch.ts';
export { TAYLOR_TOLERANCE, taylor } from './taylor/index.ts';
