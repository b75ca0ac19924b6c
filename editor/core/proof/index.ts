export { endInWords, isWhole, type LiveProof, limitInWords, MOST_WORK } from './answer.ts';
export { createProofStore, type ProofStore, type Reach } from './live-proof.ts';
export { pathOf } from './march.ts';
export { NEAR, type NearMiss } from './margins.ts';
export { createProver } from './prover.ts';
export { type SlackOf, slackQuestion, toPlay, toProve, withoutRuns } from './questions.ts';
export { type PlayedFile, playsAlike } from './scene-record.ts';
export { type FoundByWorker, type Proved, toldProblems, toldVerdict } from './told.ts';
