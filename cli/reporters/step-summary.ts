import { statSync } from 'node:fs';
import type { ResultFile } from '../command.ts';
import { markdownWithin } from './markdown.ts';
import { pathInWorkspace } from './paths.ts';
import type { ReportContext, Results } from './reporter.ts';

/** Bytes that GitHub takes as the summary of a step; of a larger file it takes nothing. */
const STEP_BYTES = 1024 * 1024;

/**
 * What to add to the summary of a step of a workflow, of which earlier commands may have written a part.
 * @param path `GITHUB_STEP_SUMMARY`
 */
export function stepSummary(
  path: string,
  results: Results,
  { linkTo, places }: Pick<ReportContext, 'linkTo' | 'places'>,
): { readonly files: ResultFile[]; readonly messages: string } {
  const before = statSync(path, { throwIfNoEntry: false })?.size ?? 0;
  const start = before === 0 ? '' : '\n';
  const content = markdownWithin(results, linkTo, STEP_BYTES - before - start.length, (file) => pathInWorkspace(file, places));
  if (content !== '') return { files: [{ path, content: start + content, mode: 'append' }], messages: '' };
  return { files: [], messages: 'warning: the summary of this step is full (1 MiB): the table of levels is left out\n' };
}
