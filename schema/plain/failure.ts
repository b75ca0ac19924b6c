/** What is wrong with a text or a value, and where. It ends the reading; it is not seen outside of this folder. */
export class Failure {
  constructor(
    /** What was expected and what was found. */
    readonly message: string,
    /** Keys and indices that lead to the value. */
    readonly path: readonly (string | number)[],
    /** The place in the text, where it is no JSON. */
    readonly place: string | null = null,
  ) {}
}

/** Longer texts are cut in messages. */
const LONGEST = 40;

/** A value in a few words: `"a text"`, `a list of 3`. */
export function inWords(value: unknown): string {
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (typeof value === 'string') return JSON.stringify(value.length > LONGEST ? `${value.slice(0, LONGEST)}…` : value);
  return typeof value === 'object' && value !== null ? 'an object' : String(value);
}
