export { type Chain, FAMILIES, type Family, LONGEST_RUN, makeChain, makeMirrored } from './chain.ts';
export { makeGrazing } from './grazing.ts';
