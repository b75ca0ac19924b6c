export { FAMILIES, LONGEST_RUN, makeChain, makeTurns } from './chain.ts';
