const LONGEST = 40;

/** A text in double quotes for a message: escaped so that it cannot control a terminal, and cut if it is long. */
export function quote(text: string): string {
  const shown = text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text;
  // control characters, line separators and direction marks, which JSON.stringify leaves unchanged
  return JSON.stringify(shown).replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, (c) => `\\u{${c.codePointAt(0)?.toString(16)}}`);
}

/** A JSON value in words: `the text "12"`, `a list of 3`. */
export function formatValue(value: unknown): string {
  if (value === null) return 'null';
  if (Array.isArray(value)) return value.length === 0 ? 'an empty list' : `a list of ${value.length}`;
  switch (typeof value) {
    case 'string':
      return `the text ${quote(value)}`;
    case 'number':
      return `the number ${value}`;
    case 'boolean':
      return String(value);
    case 'object':
      return 'an object';
    default:
      return 'nothing';
  }
}

/**
 * The optimal string alignment distance of two texts: the least number of letters that are inserted, deleted, replaced, or
 * swapped with their neighbour. Stops early with `limit` + 1 when the distance must be larger. Source: Damerau 1964, restricted
 * edit distance.
 */
export function editDistance(a: string, b: string, limit: number): number {
  if (Math.abs(a.length - b.length) > limit) return limit + 1;
  let before: number[] = [];
  let above = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const row = [i];
    let least = i;
    for (let j = 1; j <= b.length; j++) {
      const same = a[i - 1] === b[j - 1];
      let cost = Math.min(above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1));
      if (i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1]) cost = Math.min(cost, before[j - 2] + 1);
      row.push(cost);
      if (cost < least) least = cost;
    }
    // a swap reaches back two rows, so one row above the limit does not decide yet
    if (least > limit + 1) return limit + 1;
    before = above;
    above = row;
  }
  return Math.min(above[b.length], limit + 1);
}

/**
 * Finds the name that someone most likely meant, for "did you mean".
 *
 * @param name - what was written
 * @param known - the names that exist
 * @returns the closest of `known`, ignoring case, or null when none is close
 */
export function closestName(name: string, known: readonly string[]): string | null {
  const written = name.toLowerCase();
  let best: string | null = null;
  let bestDistance = Number.POSITIVE_INFINITY;
  for (const candidate of known) {
    const shorter = Math.min(written.length, candidate.length);
    // one mistake in three letters is a typing error, more is another word
    const limit = Math.max(1, Math.floor(shorter / 3));
    const distance = editDistance(written, candidate.toLowerCase(), limit);
    // after one replacement, a name of one letter shares nothing with another
    if (distance > limit || distance >= candidate.length || distance >= bestDistance) continue;
    best = candidate;
    bestDistance = distance;
  }
  return best;
}
