import { plural } from '../../check/words/index.ts';

/** A message that GitHub shows at a place in a file of a pull request. */
export interface Annotation {
  readonly severity: 'error' | 'warning';
  /** null: no file in particular. */
  readonly file: string | null;
  /** Line and column, from 1; null: the whole file. */
  readonly line: number | null;
  readonly column: number | null;
  readonly title: string;
  readonly message: string;
}

/** A line by which a step of a workflow tells GitHub something about a file. */
function workflowCommand({ severity, file, line, column, title, message }: Annotation): string {
  const at = line === null ? '' : `,line=${line},endLine=${line},col=${column ?? 1}`;
  const where = file === null ? '' : `file=${property(file)}${at},`;
  return `::${severity} ${where}title=${property(title)}::${data(message)}\n`;
}

/** GitHub shows this many annotations of each severity of a step, and says nothing of the others. */
const MOST_SHOWN = 10;

/** The lines of all annotations, errors first, as GitHub shows only the first ones; if there are more, a notice says so. */
export function workflowCommands(annotations: readonly Annotation[]): string {
  const errors = annotations.filter(({ severity }) => severity === 'error');
  const warnings = annotations.filter(({ severity }) => severity === 'warning');
  return `${[...errors, ...warnings].map(workflowCommand).join('')}${noticeOfMore(errors.length, warnings.length)}`;
}

function noticeOfMore(errors: number, warnings: number): string {
  const more = [
    [errors - MOST_SHOWN, 'more error'],
    [warnings - MOST_SHOWN, 'more warning'],
  ] as const;
  const words = more.filter(([count]) => count > 0).map(([count, one]) => plural(count, one));
  if (words.length === 0) return '';
  const message = `${words.join(' and ')} not shown here: GitHub shows ${MOST_SHOWN} of each; the log of the step has all`;
  return `::notice title=${property('more problems')}::${data(message)}\n`;
}

const data = (text: string): string => text.replaceAll('%', '%25').replaceAll('\r', '%0D').replaceAll('\n', '%0A');

const property = (text: string): string => data(text).replaceAll(':', '%3A').replaceAll(',', '%2C');
