export type { Effort } from './decide.ts';
export { decideAll, refuteSome } from './decide-all.ts';
export { type Stratum, tell } from './tell.ts';
