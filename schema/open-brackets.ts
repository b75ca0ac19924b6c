import { quote } from './format-value.ts';
import { type Finding, MAX_FINDINGS, type Path } from './problem.ts';

/** Brackets may be nested to this depth; a level needs 4. */
export const MAX_DEPTH = 64;

// from this many keys on, searching a list costs more than a set
const MANY_KEYS = 16;

/** The brackets that are open at a place of a JSON text, with the keys that each object has so far. */
export class OpenBrackets {
  depth = 0;
  /** Whether any key begins with x-. */
  hasExtensions = false;
  /** Keys that occur more than once in their object. */
  readonly repeated: Finding[] = [];
  // one entry per depth
  private readonly isList: boolean[] = [];
  private readonly index: number[] = [];
  private readonly keys: string[][] = [];
  private readonly keySets: (Set<string> | null)[] = [];

  /** Whether the innermost bracket is that of a list. */
  get isInList(): boolean {
    return this.depth > 0 && this.isList[this.depth - 1];
  }

  /**
   * Opens a bracket.
   * @returns false if it is nested too deeply
   */
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

  /** Moves on to the next item of the innermost list, or the next key of the innermost object. */
  next(): void {
    this.index[this.depth - 1]++;
  }

  /** Adds a key to the innermost object; `offset` is that of its opening quote. */
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
      const message = `this object has the key ${quote(key)} more than once`;
      this.repeated.push({ code: 'duplicate-key', message, hint: 'Keep one of them.', path: this.path(), part: 'key', offset });
    }
  }

  /** The path of the key that was added last. */
  private path(): Path {
    return this.isList.slice(0, this.depth).map((isList, d) => (isList ? this.index[d] : this.keys[d][this.keys[d].length - 1]));
  }
}
