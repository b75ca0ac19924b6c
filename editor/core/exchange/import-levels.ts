import { importOriginal, LEVEL_ID_PART, type LevelFile, type Problem } from '../../../schema/index.ts';
import { readText } from '../files/index.ts';

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

/** Letters that Unicode does not decompose into a Latin letter and a mark, and umlauts in their usual transcription. */
const LETTERS: Readonly<Record<string, string>> = {
  ...{ ä: 'ae', ö: 'oe', ü: 'ue', ß: 'ss', æ: 'ae', œ: 'oe', ø: 'oe', þ: 'th', ð: 'd', đ: 'd', ħ: 'h' },
  ...{ ı: 'i', ł: 'l', ŋ: 'ng', ŧ: 't', ĸ: 'k', ſ: 's', ƒ: 'f' },
};

/** A text as letters a-z, digits and hyphens: `Sling Shot!` becomes `sling-shot`, `Böse` `boese`, `Café` `cafe`; '' if it has none. */
export const plainName = (text: string): string =>
  text
    .toLowerCase()
    .normalize('NFC')
    .replace(/[^\p{ASCII}]/gu, (letter) => LETTERS[letter] ?? letter)
    // accents are dropped; any other character that is not a letter separates words
    .normalize('NFKD')
    .replace(/\p{Mn}+/gu, '')
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 60)
    .replace(/-+$/, '');

/** `07 Sling Shot!.level.json` becomes `07-sling-shot`; a name without a Latin letter or digit becomes `level`. */
export function slugOf(fileName: string): string {
  const slug = plainName(fileName.replace(/(\.level)?\.json$/i, ''));
  if (slug === '') return 'level';
  // some names are reserved for devices on some systems
  return LEVEL_ID_PART.test(slug) ? slug : `level-${slug}`;
}

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
