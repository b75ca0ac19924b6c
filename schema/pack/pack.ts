import { block, entriesOf, inline } from '../json/index.ts';

/** The version of the pack file that this toolkit reads and writes. */
export const PACK_VERSION = 1;

/** The name of the file that says in which order the levels of its folder are played. */
export const PACK_NAME = 'pack.json';

/** Limits of a pack file. */
export const PACK_LIMITS = {
  /** characters of the name of a pack or a chapter */
  name: 120,
  /** characters of the id of a level */
  id: 4096,
  /** entries of the list */
  entries: 20_000,
  /** things that a level introduces */
  introduces: 50,
} as const;

/** An entry of a pack file: the id of a level, a level with what it introduces, or the heading of a chapter. */
export type PackEntry = string | PackLevel | PackChapter;

type PackLevel = {
  /** Path of the level below the folder, with slashes, without .level.json. */
  level: string;
  /** The effects that players are meant to meet here for the first time. */
  introduces?: string[] | undefined;
};

type PackChapter = {
  /** The heading of the levels that follow, up to the next chapter. */
  chapter: string;
};

/** A pack file: the order of the levels of its folder. */
export type PackFile = {
  /** Where the JSON Schema of this file is, for editors. */
  $schema?: string | undefined;
  /** The version of the format. */
  version: typeof PACK_VERSION;
  /** The name of the pack. */
  name: string;
  /** The levels in the order in which they are played, and the headings of chapters between them. */
  levels: PackEntry[];
};

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
const ENTRY_KEYS = ['chapter', ...keysOf<PackLevel>({ level: true, introduces: true })];

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
