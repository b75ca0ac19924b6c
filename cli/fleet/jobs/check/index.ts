import { type CheckSettings, crashedLevel } from '../../../check/index.ts';
import { REPORTER_NAMES } from '../../../reporters/index.ts';
import type { JobKind } from '../kind.ts';
import type { CheckReporting } from './report.ts';
import { recordOf } from './work.ts';

/** `gq check` of each level. */
export const checkJob: JobKind = {
  formats: REPORTER_NAMES,
  isLong: ({ search, requireSlack }) => search !== null || requireSlack !== null,
  isClaim: ({ verdict }) => verdict === 'completable',
  crashed: (name, error, settings) => recordOf(crashedLevel(name, error, (settings as unknown as CheckSettings).terms)),
  openWork: async (settings) => (await import('./work.ts')).openCheck(settings as unknown as CheckSettings),
  async report(records, reporting, destinations, options) {
    const { reportCheckOf } = await import('./report.ts');
    return reportCheckOf(records, reporting as unknown as CheckReporting, destinations, options);
  },
};
