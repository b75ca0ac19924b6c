export { endInWords, isWhole, type LiveProof } from './answer.ts';
export { createProofStore, type ProofStore } from './live-proof.ts';
export { NEAR, type NearMiss } from './margins.ts';
export { limitInWords, MOST_WORK } from './patience.ts';
export { type PlayedFile, playsAlike } from './plays-alike.ts';
export { createProver } from './prover.ts';
export { type SlackOf, slackQuestion, toPlay, toProve, withoutRuns } from './questions.ts';
export type { Reach } from './reach.ts';
export { type FoundByWorker, type Proved, toldProblems, toldVerdict } from './told.ts';
