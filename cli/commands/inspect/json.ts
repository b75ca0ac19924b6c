import type { Inspection } from '../../inspection.ts';
import { problemJson } from '../../report-parts/index.ts';

/** What `inspect` found out, for a program. */
export function inspectJson({ level, effects, counts, modes, work, problems }: Inspection): string {
  return `${JSON.stringify({ level, effects, counts, modes, work, problems: problems.map(problemJson) })}\n`;
}
