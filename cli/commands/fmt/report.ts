import { plural } from '../../../check/words/index.ts';
import type { FmtReport } from '../../../schema/index.ts';
import { type Colors, shellPath, visibleLine } from '../../io/index.ts';
import { problemJson, showFileProblems } from '../../report-parts/index.ts';
import { type Annotation, type Places, pathInWorkspace, workflowCommands } from '../../reporters/index.ts';
import type { ShownProblem } from '../../shown-problem.ts';

export interface FormattedFile {
  readonly file: string;
  /** `failed`: the file could not be read or written, and is unchanged. */
  readonly status: 'unchanged' | 'formatted' | 'would change' | 'invalid' | 'failed';
  readonly problems: readonly ShownProblem[];
}

/** The results of `fmt` as JSON. */
export function fmtJson(files: readonly FormattedFile[]): string {
  const list = files.map(({ file, status, problems }) => ({ file, status, problems: problems.map(problemJson) }));
  return `${JSON.stringify({ version: 1, files: list } satisfies FmtReport)}\n`;
}

/** The results of `fmt` as workflow commands: what would change and what is invalid, in the files of a pull request. */
export function fmtGithub(files: readonly FormattedFile[], places: Places): string {
  const annotations = files.flatMap(({ file, status, problems }): Annotation[] => {
    const path = pathInWorkspace(file, places);
    if (status === 'would change') {
      const message = `the layout is not the canonical one\nto format it: gq fmt ${shellPath(file)}`;
      return [{ severity: 'error', file: path, line: null, column: null, title: 'layout', message }];
    }
    return problems.map(({ severity, line, column, code, message, hint }) => {
      return { severity, file: path, line, column, title: code, message: hint === '' ? message : `${message}\n${hint}` };
    });
  });
  return `${workflowCommands(annotations)}${countsInWords(files)}`;
}

/** What `fmt` did to the files of these paths, for a person: the files that were not as they should be, and a count. */
export function fmtPretty(files: readonly FormattedFile[], paths: readonly string[], colors: Colors): string {
  let text = '';
  for (const { file, status, problems } of files) {
    // the reason for a failure goes to stderr
    if (status === 'unchanged' || status === 'failed') continue;
    const paint = status === 'invalid' ? colors.red : colors.yellow;
    text += `${paint(status)} ${visibleLine(file)}\n${showFileProblems(file, problems, colors)}`;
  }
  const wouldChange = files.some(({ status }) => status === 'would change');
  const todo = wouldChange ? `to format what would change: gq fmt ${paths.map((path) => shellPath(path)).join(' ')}\n` : '';
  return `${text}${countsInWords(files)}${todo}`;
}

/** A line that says how many files there are of each status. */
function countsInWords(files: readonly FormattedFile[]): string {
  const counts = (['unchanged', 'formatted', 'would change', 'invalid', 'failed'] as const)
    .map((status) => [status, files.filter((file) => file.status === status).length] as const)
    .filter(([, count]) => count > 0)
    .map(([status, count]) => `${count} ${status}`);
  return `${plural(files.length, 'file')}: ${counts.join(', ')}\n`;
}
