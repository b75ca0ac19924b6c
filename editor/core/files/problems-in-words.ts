import type { Problem } from '../../../schema/index.ts';

/** Where a file can't be read, what was expected and found, and what to do, as one text: `01.level.json:4:3: …`. */
export function problemsInWords(file: string, problems: readonly Problem[]): string {
  const [first] = problems;
  if (first === undefined) return `${file} can't be read.`;
  return problemInWords(file, first, problems.length > 1 ? ` (and ${problems.length - 1} more)` : '');
}

/** One problem of a file, likewise. @param more is added to the message */
export function problemInWords(file: string, { line, column, message, hint }: Problem, more = ''): string {
  const place = line === null ? file : `${file}:${line}:${column}`;
  const said = `${message}${more}`;
  return `${place}: ${said}${said.endsWith('?') ? '' : '.'} ${hint}`;
}
