import type { Hold } from '../../../schema/basics/index.ts';
import type { AnytimeProof } from '../../search/anytime/index.ts';
import type { proveLost } from './prove-lost.ts';
import type { SurveyedState } from './standing.ts';

/** A state while it is examined. */
export type Examined = { -readonly [K in keyof SurveyedState]: SurveyedState[K] } & {
  readonly vx: number;
  readonly vy: number;
  /** The holds of a run through this state that completes the level; null while none is known. */
  onward: readonly Hold[] | null;
  /** How proofs were sought. */
  readonly sought: Set<typeof proveLost>;
  /** The search for a proof with ever finer sets; null: there is none for this state, undefined: not begun. */
  proving: AnytimeProof | null | undefined;
  /** Whether it was tried how runs go on from similar states. */
  isKnownTried: boolean;
};
