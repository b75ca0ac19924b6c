import type { ProofCode } from './proof.ts';

/** Codes of the engine's warnings that say less than what was proved. */
export const OUTDONE_WARNINGS: Readonly<Partial<Record<ProofCode, string>>> = {
  'out-of-range': 'black-hole-out-of-reach',
  covered: 'black-hole-covered',
  'nothing-in-range': 'nothing-in-range-at-start',
  'starts-in-hazard': 'starts-in-hazard',
};
