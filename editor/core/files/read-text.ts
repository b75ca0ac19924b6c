import type { LevelFile, Problem, ReadResponse } from '../../../schema/index.ts';
import { readContent } from '../../../schema/level/index.ts';
import { normalize } from '../document/index.ts';

type TextReading =
  | { readonly ok: true; readonly file: LevelFile }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/** Reads a level from a text or the bytes of a file and gives every object an id; or says what is wrong. */
export function readText(source: string | Uint8Array): TextReading {
  const reading = readContent(source);
  if (!reading.ok) return { ok: false, problems: reading.problems };
  const normalized = normalize(reading.document.file, null);
  if (normalized.ok) return { ok: true, file: normalized.file };
  const { message, hint } = normalized.refusal;
  return {
    ok: false,
    problems: [{ code: 'unexpected', severity: 'error', message, hint, pointer: '', line: null, column: null }],
  };
}

/** With these problems, the decoded text is not what the file contains, whatever it looks like. */
const UNREADABLE: ReadonlySet<string> = new Set(['not-utf8', 'not-a-level']);

/** Reads a level from a file of the storage; or says what is wrong with the file. */
export function readStored({ text, problems }: Pick<ReadResponse, 'text' | 'problems'>): TextReading {
  // only the storage knows why the file could not be read
  return text === null || problems.some(({ code }) => UNREADABLE.has(code)) ? { ok: false, problems } : readText(text);
}

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
