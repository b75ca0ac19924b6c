export { type AnytimeOptions, type AnytimeProof, createAnytimeProof } from './anytime-proof.ts';
