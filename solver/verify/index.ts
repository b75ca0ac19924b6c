export { type Verification, verifyProof } from './verify-proof.ts';
