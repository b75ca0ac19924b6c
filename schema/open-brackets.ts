import { quote } from './format-value.ts';
import { type Finding, MAX_FINDINGS, type Path } from './problem.ts';

/** Brackets may be nested this deep; a level needs 4. */
export const MAX_DEPTH = 64;

// from here on looking through a list of keys costs more than a set
const MANY_KEYS = 16;

/** The brackets that are open at a place of a JSON text, with the keys of each object so far. */
export class OpenBrackets {
  depth = 0;
  /** Whether any key begins with x-. */
  hasExtensions = false;
  /** Keys that stand more than once in their object. */
  readonly repeated: Finding[] = [];
  // an entry for each depth
  private readonly isList: boolean[] = [];
  private readonly index: number[] = [];
  private readonly keys: string[][] = [];
  private readonly keySets: (Set<string> | null)[] = [];

  /** Whether the innermost bracket is that of a list. */
  get isInList(): boolean {
    return this.depth > 0 && this.isList[this.depth - 1];
  }

  /** @returns whether one more may be open */
  open(isList: boolean): boolean {
    const { depth } = this;
    if (depth === MAX_DEPTH) return false;
    this.isList[depth] = isList;
    this.index[depth] = 0;
    this.keys[depth] = [];
    this.keySets[depth] = null;
    this.depth++;
    return true;
  }

  close(): void {
    this.depth--;
  }

  /** The next item of the innermost list, or key of the innermost object, begins. */
  next(): void {
    this.index[this.depth - 1]++;
  }

  /** Notes a key of the innermost object. @param offset of its opening quote */
  addKey(key: string, offset: number): void {
    if (key.startsWith('x-')) this.hasExtensions = true;
    const d = this.depth - 1;
    const seen = this.keys[d];
    const set = this.keySets[d];
    const isRepeated = set === null ? seen.includes(key) : set.has(key);
    seen.push(key);
    if (set !== null) set.add(key);
    else if (seen.length > MANY_KEYS) this.keySets[d] = new Set(seen);
    if (isRepeated && this.repeated.length < MAX_FINDINGS) {
      const message = `the key ${quote(key)} stands more than once in this object`;
      this.repeated.push({ code: 'duplicate-key', message, hint: 'Keep one of them.', path: this.path(), part: 'key', offset });
    }
  }

  /** The way to the key that was added last. */
  private path(): Path {
    return this.isList.slice(0, this.depth).map((isList, d) => (isList ? this.index[d] : this.keys[d][this.keys[d].length - 1]));
  }
}
