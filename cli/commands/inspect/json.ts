import type { Inspection } from '../../inspection.ts';
import { problemJson } from '../../report-parts/index.ts';

/** The results of `inspect` as JSON. */
export function inspectJson({ level, effects, counts, modes, work, problems }: Inspection): string {
  return `${JSON.stringify({ level, effects, counts, modes, work, problems: problems.map(problemJson) })}\n`;
}
