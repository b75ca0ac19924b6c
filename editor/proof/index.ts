export { createProofStore, type ProofStore } from './live-proof.ts';

export { NEAR } from './margins.ts';
export { outcomeInWords, type RunEnd, reasonInWords } from './outcome.ts';
export { limitInWords } from './patience.ts';
export { type Proved, withProofs } from './proved-problems.ts';
export { createProver, endInWords, isWhole, type LiveProof } from './prover.ts';
export type { Reach } from './reach.ts';
