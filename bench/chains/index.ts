export { type Chain, FAMILIES, type Family, makeChain } from './chain.ts';
