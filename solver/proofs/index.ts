export { OUTDONE_WARNINGS } from './outdone.ts';
export { type ProofPicture, type ProofRole, proofPicture } from './picture.ts';
export type {
  About,
  BarrierEdge,
  Blocker,
  BoxNumbers,
  Certificate,
  DeadEnd,
  Direction,
  Doomed,
  Drift,
  FanGrid,
  Flowpipe,
  LineEnd,
  LineTrap,
  OrbitGrid,
  Orbits,
  PipeGrid,
  PipePart,
  PipeStep,
  Proof,
  ProofCode,
  Prover,
  Strip,
  ThingRef,
} from './proof.ts';
export { FINEST, mayProve, type ProveOptions, proveBy, proveImpossible, proveMineralsUnreachable } from './prove.ts';
export { PROVERS, type ProverEntry, proversThat } from './provers.ts';
