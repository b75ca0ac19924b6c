import type { ProofCode } from './proof.ts';

/** The engine's warning, by its code, that says less than a proof of each kind and is dropped when there is such a proof. */
export const OUTDONE_WARNINGS: Readonly<Partial<Record<ProofCode, string>>> = {
  'out-of-range': 'black-hole-out-of-reach',
  covered: 'black-hole-covered',
  'nothing-in-range': 'nothing-in-range-at-start',
  'starts-in-hazard': 'starts-in-hazard',
};
