import { type LevelFile, type Problem, type ReadResponse, readLevel } from '../../schema/index.ts';
import { settle } from '../document/index.ts';

export type TextReading =
  | { readonly ok: true; readonly file: LevelFile }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/** The level that a text says, or the bytes of a file, with an id on every object; or what is wrong with it. */
export function readText(source: string | Uint8Array): TextReading {
  const reading = readLevel(source, { byteOrderMark: 'skip' });
  if (!reading.ok) return { ok: false, problems: reading.problems };
  const settled = settle(reading.document.file, null);
  if (settled.ok) return { ok: true, file: settled.file };
  const { message, hint } = settled.refusal;
  return {
    ok: false,
    problems: [{ code: 'unexpected', severity: 'error', message, hint, pointer: '', line: null, column: null }],
  };
}

/** Whatever a text looks like in which some bytes could not be read, it is not what the file says. */
const UNREADABLE: ReadonlySet<string> = new Set(['not-utf8', 'not-a-level']);

/** The level that a file of the storage holds, or what is wrong with the file. */
export function readStored({ text, problems }: Pick<ReadResponse, 'text' | 'problems'>): TextReading {
  // only the storage knows why it could not be read
  return text === null || problems.some(({ code }) => UNREADABLE.has(code)) ? { ok: false, problems } : readText(text);
}
