export { type ProofPicture, type ProofRole, proofPicture } from './picture.ts';
export * from './proof.ts';
export {
  FINEST,
  mayProve,
  type ProveOptions,
  proveBy,
  proveImpossible,
  proveMineralsUnreachable,
} from './prove.ts';
export { PROVERS, type ProverEntry, proversThat } from './provers.ts';
