import { levelInLines } from '../../../review/index.ts';
import { readLevel } from '../../../schema/index.ts';

/** A level as lines of text; a file that is not a valid level as it is, after the reason, so that `git diff` still shows it. */
export function textOfLevel(bytes: Uint8Array): string {
  const read = readLevel(bytes, { byteOrderMark: 'skip' });
  if (read.ok) return levelInLines(read.document.file);
  const [{ message, line, column }] = read.problems;
  const place = line === null ? '' : `${line}:${column ?? 1}: `;
  return `not a valid level: ${place}${message}\n${new TextDecoder().decode(bytes)}`;
}
