import { importOriginal, type LevelFile, type Problem } from '../../../schema/index.ts';
import { readText } from '../files/index.ts';
import { slugOf } from './export.ts';

/** Levels read from a file that the user chose or dropped. */
export type Importing =
  | {
      readonly ok: true;
      readonly kind: 'level' | 'original';
      /** `slug`: a name for the file */
      readonly levels: readonly { readonly slug: string; readonly file: LevelFile }[];
      /** What was skipped, in words. */
      readonly notes: readonly string[];
    }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/** Whether a JSON text is of the original game: a list of levels, or a level with a `player`. */
function isOriginal(source: string | Uint8Array): boolean {
  try {
    const text = typeof source === 'string' ? source : new TextDecoder('utf-8', { fatal: true }).decode(source);
    const value: unknown = JSON.parse(text);
    return Array.isArray(value) || (typeof value === 'object' && value !== null && Object.hasOwn(value, 'player'));
  } catch {
    return false;
  }
}

/**
 * Reads a level file or levels of the original game, whichever it is.
 * @param source the content of a file, or pasted text
 * @param recoil whether levels of the original get recoil, as in the original
 */
export function importLevels(
  source: string | Uint8Array,
  fileName: string,
  { recoil = true }: { readonly recoil?: boolean } = {},
): Importing {
  if (!isOriginal(source)) {
    const reading = readText(source);
    if (!reading.ok) return { ok: false, problems: reading.problems };
    return { ok: true, kind: 'level', levels: [{ slug: slugOf(fileName), file: reading.file }], notes: [] };
  }
  const reading = importOriginal(source, { recoil });
  if (!reading.ok) return { ok: false, problems: reading.problems };
  return { ok: true, kind: 'original', levels: reading.levels, notes: reading.notes };
}
