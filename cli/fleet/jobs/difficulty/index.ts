import { termsReport } from '../../../../check/words/index.ts';
import type { MeasureSettings } from '../../../difficulty/index.ts';
import type { Json } from '../../job.ts';
import { type JobKind, PLAIN_FORMATS } from '../kind.ts';

const termsOfFolder = ({ terms }: MeasureSettings) => termsReport({ terms, level: terms });

/** `gq difficulty` of each level. */
export const difficultyJob: JobKind = {
  formats: PLAIN_FORMATS,
  isLong: () => true,
  isClaim: ({ code }) => code === 0,
  // the modules of difficulty simulate, so they are loaded only where that is needed
  crashed: (name, error, settings): Json => ({
    ...{ name, runName: null, difficulty: null, comparedNames: [], curve: [], players: null, problems: [], code: 2 },
    terms: termsOfFolder(settings as unknown as MeasureSettings),
    why: `measuring this level crashed: ${error instanceof Error ? error.message : error}; please report it, with the level`,
  }),
  openWork: async (settings) => (await import('./work.ts')).openDifficulty(settings as unknown as MeasureSettings),
  async report(records, _reporting, destinations, options) {
    const { reportMeasured } = await import('./report.ts');
    return reportMeasured(records, destinations, options);
  },
};
