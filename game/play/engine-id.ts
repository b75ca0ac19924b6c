// `npm run hashes` writes this file.

/**
 * The identity of the rules and of the engine's semantics, 16 hexadecimal digits: plays of the same identity mean the same. It
 * becomes another whenever a pinned result changes, and stays when results are only added.
 */
export const ENGINE_ID = 'a913ad0fd953d7f5';

/** The checksum of the table of pinned results (`tests/browsers/hashes.json`) that {@link ENGINE_ID} stands for. */
export const PINNED_RESULTS = 'a913ad0fd953d7f5';
