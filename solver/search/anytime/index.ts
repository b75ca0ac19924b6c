export { type AnytimeOptions, type AnytimeProof, createAnytimeProof } from './anytime-proof.ts';
export { createDecider, type Decider, type DeciderOptions, proofShare } from './decider.ts';
