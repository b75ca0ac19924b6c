import type { InspectReport } from '../../../schema/index.ts';
import type { Inspection } from '../../inspection.ts';
import { problemJson } from '../../report-parts/index.ts';

/** The results of `inspect` as JSON. */
export function inspectJson({ level, terms, effects, counts, modes, work, problems }: Inspection): string {
  const report: InspectReport = {
    version: 1,
    level,
    terms,
    effects: { simulated: [...effects.simulated], notCalledFor: [...effects.notCalledFor] },
    counts,
    modes: [...modes],
    work,
    problems: problems.map(problemJson),
  };
  return `${JSON.stringify(report)}\n`;
}
