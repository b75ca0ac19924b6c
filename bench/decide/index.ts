export { decideAll, refuteSome } from './decide-all.ts';
export { askedEffort } from './options.ts';
export { type Stratum, tell } from './tell.ts';
