/** What an attack tries, and until when. */
export interface Span {
  /** The first seed, or step. */
  readonly from: number;
  /** So many at most. */
  readonly most: number;
  /** ms since 1970; nothing begins after that. */
  readonly until: number;
}

/** What came of an attack. */
export interface Attacked {
  /** What was tried and says something. */
  readonly tried: number;
  readonly bugs: number;
  readonly told: string;
}

/** The seeds of a span, as long as there is time. */
export function* seedsOf({ from, most, until }: Span): Generator<number> {
  for (let seed = from; seed < from + most && Date.now() < until; seed++) yield seed;
}
