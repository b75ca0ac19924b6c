export { endInWords, isWhole, type LiveProof, limitInWords, MOST_WORK } from './answer.ts';
export { type FoundByWorker, knownProblems, knownVerdict, type Proved } from './known-problems.ts';
export { createProofStore, type ProofStore, type Reach } from './live-proof.ts';
export { NEAR, type NearMiss } from './margins.ts';
export { createProver } from './prover.ts';
export { type SlackOf, slackQuestion, toPlay, toProve, withoutRuns } from './questions.ts';
export { pathOf } from './recorder.ts';
export { type PlayedFile, playsAlike } from './scene-record.ts';
