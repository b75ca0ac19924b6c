export { type AnytimeOptions, type AnytimeProof, createAnytimeProof } from './anytime-proof.ts';
export { createDecider, type Decider, type DeciderOptions } from './decider.ts';
export { proofShare } from './proof-share.ts';
