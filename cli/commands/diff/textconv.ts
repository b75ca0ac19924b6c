import { levelInLines } from '../../../review/index.ts';
import { readLevel } from '../../../schema/index.ts';
import { readContent } from '../../../schema/level/index.ts';

/** A level as lines of text; a file that is not a valid level as it is, after the reason, so that `git diff` still shows it. */
export function textOfLevel(bytes: Uint8Array): string {
  const read = readLevel(bytes);
  if (read.ok) return levelInLines(read.document.file);
  const [{ message, line, column }] = read.problems;
  const place = line === null ? '' : `${line}:${column ?? 1}: `;
  // with a mark before it, a level is still one to look at
  const marked = readContent(bytes);
  const content = marked.ok ? levelInLines(marked.document.file) : new TextDecoder().decode(bytes);
  return `not a valid level: ${place}${message}\n${content}`;
}
