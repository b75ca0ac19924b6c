import type { Problem } from '../../schema/index.ts';

/** Where a file can't be read, what was expected and found, and what to do, as one text: `01.level.json:4:3: …`. */
export function problemsInWords(file: string, problems: readonly Problem[]): string {
  const [first] = problems;
  if (first === undefined) return `${file} can't be read.`;
  const { line, column, message, hint } = first;
  const place = line === null ? file : `${file}:${line}:${column}`;
  const more = problems.length > 1 ? ` (and ${problems.length - 1} more)` : '';
  const said = `${message}${more}`;
  return `${place}: ${said}${said.endsWith('?') ? '' : '.'} ${hint}`;
}
