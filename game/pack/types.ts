import type { Level } from '../../schema/basics/index.ts';

/** A level of a pack. */
export interface PackLevel {
  /** A name that stays while the level is edited or moved within the pack, such as the name of its file. */
  readonly id: string;
  /** The level. */
  readonly level: Level;
}

/** Where progress is kept; `localStorage` is one. */
export interface PackStorage {
  /**
   * Reads a text.
   *
   * @param key - its key
   * @returns the text, or null if there is none
   */
  getItem(key: string): string | null;
  /**
   * Keeps a text.
   *
   * @param key - its key
   * @param value - the text
   */
  setItem(key: string, value: string): void;
}

/** The best play of a level: the one with most minerals, and of these the shortest. */
export interface Best {
  /** The tick in which she reached the black hole. */
  readonly tick: number;
  /** Minerals that she had collected. */
  readonly minerals: number;
  /** The play: the bytes of its `.gqr` file as base64url text; null if it was not recorded. */
  readonly play: string | null;
}
