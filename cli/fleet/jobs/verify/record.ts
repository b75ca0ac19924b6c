import type { VerifyReport } from '../../../../schema/index.ts';

/** What has become of a play. */
export interface VerifyRecord {
  /** null: it could not be verified. */
  readonly report: VerifyReport | null;
  /** Why it could not; null if it could. */
  readonly why: string | null;
}
