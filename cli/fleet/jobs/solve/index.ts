import type { Json } from '../../job.ts';
import { type JobKind, PLAIN_FORMATS } from '../kind.ts';
import { type SolveJobSettings, untried } from './record.ts';

/** `gq solve` of each level. */
export const solveJob: JobKind = {
  formats: PLAIN_FORMATS,
  isLong: () => true,
  isClaim: ({ verdict }) => verdict === 'found',
  crashed: (name, error) =>
    untried(name, 'crashed', `solving this level crashed: ${error instanceof Error ? error.message : error}`) as unknown as Json,
  openWork: async (settings) => (await import('./work.ts')).openSolve(settings as unknown as SolveJobSettings),
  async report(records, _reporting, destinations, options) {
    const { reportSolved } = await import('./report.ts');
    return reportSolved(records, destinations, options);
  },
};
