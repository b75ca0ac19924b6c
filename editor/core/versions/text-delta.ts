/**
 * What makes a text of another one, line by line: from line `at` of the other text on, `gone` lines are replaced by `lines`.
 * Hunks are in order and do not overlap.
 */
export type Hunk = readonly [at: number, gone: number, ...lines: string[]];

/** Pairs of equal lines that occur once in each part, in the order of both: the longest such list. */
function anchorsBetween(old: readonly string[], now: readonly string[]): (readonly [old: number, now: number])[] {
  const places = new Map<string, { count: number; old: number; now: number }>();
  for (const [i, line] of old.entries()) {
    const known = places.get(line);
    if (known === undefined) places.set(line, { count: 1, old: i, now: -1 });
    else known.count = 3;
  }
  for (const [i, line] of now.entries()) {
    const known = places.get(line);
    if (known === undefined) continue;
    known.count++;
    known.now = i;
  }
  const pairs = [...places.values()].filter(({ count, now: at }) => count === 2 && at >= 0).sort((p, q) => p.now - q.now);
  // the longest rising list of old places, by patience sorting
  const piles: number[] = [];
  const before = new Array<number>(pairs.length).fill(-1);
  for (const [i, pair] of pairs.entries()) {
    let [low, high] = [0, piles.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (pairs[piles[middle]].old < pair.old) low = middle + 1;
      else high = middle;
    }
    if (low > 0) before[i] = piles[low - 1];
    piles[low] = i;
  }
  const anchors: (readonly [number, number])[] = [];
  for (let i = piles.at(-1) ?? -1; i >= 0; i = before[i]) anchors.push([pairs[i].old, pairs[i].now]);
  return anchors.reverse();
}

/** The hunks that make `after` of `before`: few where few lines differ. */
export function deltaBetween(before: string, after: string): Hunk[] {
  const [old, now] = [before.split('\n'), after.split('\n')];
  let start = 0;
  while (start < old.length && start < now.length && old[start] === now[start]) start++;
  let end = 0;
  while (end < old.length - start && end < now.length - start && old[old.length - 1 - end] === now[now.length - 1 - end]) end++;
  const [oldEnd, nowEnd] = [old.length - end, now.length - end];
  const inner = anchorsBetween(old.slice(start, oldEnd), now.slice(start, nowEnd));
  const hunks: Hunk[] = [];
  let [i, j] = [start, start];
  for (const [a, b] of [...inner.map(([p, q]) => [p + start, q + start] as const), [oldEnd, nowEnd] as const]) {
    if (a > i || b > j) hunks.push([i, a - i, ...now.slice(j, b)]);
    [i, j] = [a + 1, b + 1];
  }
  return hunks;
}

/** Makes the text of the other one. @throws RangeError if the hunks do not fit it */
export function withDelta(before: string, hunks: readonly Hunk[]): string {
  const old = before.split('\n');
  const lines: string[] = [];
  let next = 0;
  for (const [at, gone, ...come] of hunks) {
    if (!(at >= next && gone >= 0 && at + gone <= old.length)) throw new RangeError('the hunks do not fit the text');
    for (; next < at; next++) lines.push(old[next]);
    lines.push(...come);
    next = at + gone;
  }
  for (; next < old.length; next++) lines.push(old[next]);
  return lines.join('\n');
}
