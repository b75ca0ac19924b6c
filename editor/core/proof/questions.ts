import type { Terms } from '../../../engine/index.ts';
import type { Level } from '../../../schema/index.ts';
import type { LiveProof } from './answer.ts';

/** What a worker should prove about a level. */
export interface ProofQuestion {
  readonly level: Level;
  readonly terms: Terms;
  /** Indices of the minerals that some run collects, which need no proof. null: the page does not know. */
  readonly collected: readonly number[] | null;
}

/** What a worker should prove about the level; null: the runs reach everything, or checks are off. */
export function toProve(proof: LiveProof): ProofQuestion | null {
  const { level, terms, verdict, run, limit } = proof;
  if (limit === 'unchecked') return null;
  if (verdict === 'completable' && run.minerals.length === level.minerals.length) return null;
  return { level, terms, collected: proof.findings?.collected ?? null };
}

/** What a worker should simulate because the page left it out; null: nothing. */
export const toPlay = ({
  level,
  terms,
  limit,
}: Pick<LiveProof, 'level' | 'terms' | 'limit'>): { readonly level: Level; readonly terms: Terms } | null =>
  limit === null || limit === 'unchecked' ? null : { level, terms };
