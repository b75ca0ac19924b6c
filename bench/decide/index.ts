export type { Decision, Effort, NamedLevel } from './decide.ts';
export { decideAll, refuteSome } from './decide-all.ts';
export { type Asked, askedEffort } from './options.ts';
export { type Stratum, tell } from './tell.ts';
