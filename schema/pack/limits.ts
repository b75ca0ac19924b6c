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
