export { type Chain, FAMILIES, LONGEST_RUN, makeChain, makeMirrored } from './chain.ts';
export { makeGrazing } from './grazing.ts';
