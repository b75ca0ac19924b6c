export { endInWords, isWhole, type LiveProof } from './answer.ts';
export { asGqCheck } from './as-gq-check.ts';
export { createProofStore, type ProofStore } from './live-proof.ts';
export { NEAR } from './margins.ts';
export { limitInWords } from './patience.ts';
export { createProver } from './prover.ts';
export { toPlay, toProve } from './questions.ts';
export type { Reach } from './reach.ts';
export { type FoundByWorker, type Proved, toldProblems, toldVerdict } from './told.ts';
