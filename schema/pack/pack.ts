import type * as z from 'zod';
import { block, entriesOf, inline } from '../json/index.ts';
import type { levelEntrySchema, packSchema } from './pack-schema.ts';

/** A pack file: the order of the levels of its folder. */
export type PackFile = z.infer<typeof packSchema>;

/** An entry of a pack file: the id of a level, a level with what it introduces, or the heading of a chapter. */
export type PackEntry = PackFile['levels'][number];

/**
 * The level that an entry of a pack names.
 *
 * @param entry - the entry
 * @returns its id; null for the heading of a chapter
 */
export function levelOfEntry(entry: PackEntry): string | null {
  if (typeof entry === 'string') return entry;
  return 'level' in entry ? entry.level : null;
}

/**
 * The ids of the levels that a pack lists, each once, in its order.
 *
 * @param pack - the pack
 * @returns the ids
 */
export const levelsOfPack = ({ levels }: Pick<PackFile, 'levels'>): string[] => [
  ...new Set(levels.flatMap((entry) => levelOfEntry(entry) ?? [])),
];

const keysOf = <T>(keys: Readonly<Record<keyof T, true>>): string[] => Object.keys(keys);

/** The keys of a pack file, in the order of the canonical layout. */
export const KEYS = keysOf<PackFile>({ $schema: true, version: true, name: true, levels: true });
const ENTRY_KEYS = ['chapter', ...keysOf<z.infer<typeof levelEntrySchema>>({ level: true, introduces: true })];

/** An entry in its shortest form: a level of which nothing else is said is its id. */
function formatEntry(entry: PackEntry): string {
  const isPlain = typeof entry === 'object' && 'level' in entry && Object.keys(entry).length === 1;
  return isPlain ? JSON.stringify(entry.level) : inline(entry, ENTRY_KEYS);
}

/**
 * Writes a pack file in the canonical layout: keys in the order of the schema and x- keys after them, a line for each entry, so
 * that versions merge line by line.
 *
 * @param pack - the pack, with its x- keys
 * @returns its text
 */
export function formatPack(pack: PackFile): string {
  const rows = entriesOf(pack, KEYS).map(([key, value]) => {
    const text = key === 'levels' ? block('[', pack.levels.map(formatEntry), ']', '  ') : inline(value);
    return `${JSON.stringify(key)}: ${text}`;
  });
  return `${block('{', rows, '}', '')}\n`;
}
