/** What a value in a level file must be. `level-shape.ts` has the shape of a whole file. */
export interface Shape {
  /** The type of the value; missing where any value may stand. */
  readonly type?: 'number' | 'integer' | 'boolean' | 'string' | 'array' | 'object';
  /** Of a number its least value; of a text or a list its least length. */
  readonly least?: number;
  /** Of a number its largest value; of a text or a list its largest length. */
  readonly most?: number;
  /** The only value that may stand here. */
  readonly only?: unknown;
  /** A regular expression that a text must match. */
  readonly pattern?: string;
  /** The shape of every entry of a list. */
  readonly each?: Shape;
  /** The shapes of an object's values by key, in the order of a file. */
  readonly keys?: Readonly<Record<string, Shape>>;
  /** Whether the object around it may lack it. */
  readonly optional?: true;
  /** What it is where it is left out. */
  readonly usual?: unknown;
}
