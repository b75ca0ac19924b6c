import type { StoredText } from './stored-text.ts';
import type { Version } from './version.ts';

/** A version that gets its number when it is stored. */
export type NewVersion = Omit<Version, 'number' | 'base' | 'size'>;

/** A history that goes to another place. */
export interface Move {
  readonly from: string;
  readonly to: string;
  /** Names this move, so that several pages that hear of it make it once. */
  readonly token: string;
}

/** What is stored of the text of a version: whatever is there, damaged or not. */
export interface FoundTexts {
  readonly copies: readonly unknown[];
  readonly bases: readonly unknown[];
}

/** Where histories are kept. Each function is one transaction; its promise rejects when the database fails. */
export interface VersionStore {
  /** The number of the history at a place, which is begun if there is none. */
  open(place: string): Promise<number>;
  /** The versions of a history, oldest first. */
  list(history: number): Promise<readonly Version[]>;
  last(history: number): Promise<Version | null>;
  /**
   * Adds a version, unless the last one has the same text. @returns the new one, or the last one; null if the version that
   * `text` is stored by is gone
   */
  add(history: number, version: NewVersion, text: StoredText): Promise<Version | null>;
  texts(history: number, version: Version): Promise<FoundTexts>;
  /** Removes versions and replaces others, except those that are no longer there. Texts that others are stored by stay. */
  change(history: number, drop: readonly number[], put: readonly Version[]): Promise<void>;
  /** Moves histories to other places, all at once. What is at a place that another history takes is set aside. */
  move(moves: readonly Move[]): Promise<void>;
}

/** The row of a place. */
export interface Head {
  readonly place: string;
  readonly history: number;
  /** The last move that brought the history here. */
  readonly token: string | null;
}

/** Where the history of a place goes that another history takes. */
const asideOf = ({ place, history }: Head): string => `${place}?aside ${history}`;

/** The heads after moves. @param heads by place; @returns the heads to delete and to put; null if the moves were made already */
export function movedHeads(
  heads: ReadonlyMap<string, Head>,
  moves: readonly Move[],
): { readonly gone: readonly string[]; readonly put: readonly Head[] } | null {
  const real = moves.filter(({ from, to }) => heads.has(from) && from !== to);
  if (real.length === 0 || moves.every(({ to, token }) => heads.get(to)?.token === token)) return null;
  const gone = new Set(real.map(({ from }) => from));
  const put: Head[] = [];
  for (const { from, to, token } of real) {
    const there = heads.get(to);
    if (there !== undefined && !gone.has(to)) put.push({ ...there, place: asideOf(there) });
    put.push({ place: to, history: (heads.get(from) as Head).history, token });
  }
  return { gone: [...gone], put };
}

/** The numbers of the texts that versions need. */
export const neededTexts = (versions: readonly Version[]): ReadonlySet<number> =>
  new Set(versions.flatMap(({ number, base }) => [number, base]));
