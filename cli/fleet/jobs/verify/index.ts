import type { PlayJobSettings } from '../../../verify/index.ts';
import type { Json } from '../../job.ts';
import { type JobKind, PLAIN_FORMATS } from '../kind.ts';
import type { VerifyRecord } from './work.ts';

/** `gq verify` of each play. */
export const verifyJob: JobKind = {
  formats: PLAIN_FORMATS,
  isLong: () => false,
  isClaim: (result) => (result as unknown as VerifyRecord).report?.verdict === 'ok',
  crashed: (name, error): Json => ({
    report: null,
    why: `${name}: verifying this play crashed: ${error instanceof Error ? error.message : error}; please report it, with the play`,
  }),
  async expectInputs(settings) {
    const { expectAsPlanned } = await import('../../../verify/index.ts');
    expectAsPlanned(settings as unknown as PlayJobSettings);
  },
  openWork: async (settings) => (await import('./work.ts')).openVerify(settings as unknown as PlayJobSettings),
  async report(records, _reporting, destinations, options) {
    const { reportVerified } = await import('./report.ts');
    return reportVerified(records, destinations, options);
  },
};
