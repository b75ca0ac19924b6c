export { createProofStore, type ProofStore } from './live-proof.ts';

export { outcomeInWords, type RunEnd } from './outcome.ts';
export { type Proved, withProofs } from './proved-problems.ts';
export { createProver, type LiveProof } from './prover.ts';
