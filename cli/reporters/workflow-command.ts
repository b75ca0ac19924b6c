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
export function workflowCommand({ severity, file, line, column, title, message }: Annotation): string {
  const at = line === null ? '' : `,line=${line},endLine=${line},col=${column ?? 1}`;
  const where = file === null ? '' : `file=${property(file)}${at},`;
  return `::${severity} ${where}title=${property(title)}::${data(message)}\n`;
}

/** Annotations in the order in which GitHub shows most of those that matter: it shows only ten of each severity. */
export const errorsFirst = (annotations: readonly Annotation[]): Annotation[] => [
  ...annotations.filter(({ severity }) => severity === 'error'),
  ...annotations.filter(({ severity }) => severity === 'warning'),
];

const data = (text: string): string => text.replaceAll('%', '%25').replaceAll('\r', '%0D').replaceAll('\n', '%0A');

const property = (text: string): string => data(text).replaceAll(':', '%3A').replaceAll(',', '%2C');
