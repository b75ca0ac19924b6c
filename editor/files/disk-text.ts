import { type LevelFile, type Problem, readLevel } from '../../schema/index.ts';
import { settle } from '../document/index.ts';

export type TextReading =
  | { readonly ok: true; readonly file: LevelFile }
  | { readonly ok: false; readonly text: string; readonly problems: readonly Problem[] };

/** The level that a text says, with an id on every object; or what is wrong with the text. */
export function readText(text: string): TextReading {
  const reading = readLevel(text, { byteOrderMark: 'skip' });
  if (!reading.ok) return { ok: false, text, problems: reading.problems };
  const settled = settle(reading.document.file, null);
  if (settled.ok) return { ok: true, file: settled.file };
  const { message, hint } = settled.refusal;
  return {
    ok: false,
    text,
    problems: [{ code: 'unexpected', severity: 'error', message, hint, pointer: '', line: null, column: null }],
  };
}
