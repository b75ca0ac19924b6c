/** Above this length, a typed array is sorted sooner. */
const SHORT = 64;

/** Indices, ascending. The list may be changed. */
export const ascending = (found: number[]): ArrayLike<number> =>
  found.length > SHORT ? Int32Array.from(found).sort() : found.sort((a, b) => a - b);
