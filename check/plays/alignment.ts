/** What an edge of a play costs that has no partner, ticks. */
const EXTRA = 60;

/** What an edge of the reference costs that the play left out, ticks. */
const LEFT_OUT = 30;

/**
 * Finds which edge of a play stands for which edge of a reference run: the cheapest alignment (S. B. Needleman, C. D. Wunsch,
 * 1970) that pairs a press with a press and a release with a release, in order. A pair costs the ticks between both; an edge
 * without a partner costs {@link EXTRA} or {@link LEFT_OUT}, but for the edges of the reference after the last pair: the play did
 * not come so far.
 * @param reference the ticks at which the reference changes the button; the first is a press
 * @param edges those of the play
 * @returns for each edge of the reference the index of its partner, or -1
 */
export function alignEdges(reference: readonly number[], edges: readonly number[]): Int32Array {
  const [n, m] = [reference.length, edges.length];
  const width = m + 1;
  const cost = new Float64Array((n + 1) * width);
  for (let j = 1; j <= m; j++) cost[j] = EXTRA * j;
  for (let i = 1; i <= n; i++) {
    cost[i * width] = LEFT_OUT * i;
    for (let j = 1; j <= m; j++) {
      const alone = Math.min(LEFT_OUT + cost[(i - 1) * width + j], EXTRA + cost[i * width + j - 1]);
      cost[i * width + j] = Math.min(alone, pairCost(reference, edges, i, j) + cost[(i - 1) * width + j - 1]);
    }
  }
  const partners = new Int32Array(n).fill(-1);
  let [i, j] = [0, m];
  for (let end = 1; end <= n; end++) if (cost[end * width + m] < cost[i * width + m]) i = end;
  while (i > 0 && j > 0) {
    const here = cost[i * width + j];
    if (here === pairCost(reference, edges, i, j) + cost[(i - 1) * width + j - 1]) {
      i--;
      j--;
      partners[i] = j;
    } else if (here === EXTRA + cost[i * width + j - 1]) j--;
    else i--;
  }
  return partners;
}

/** What it costs to pair edge `i` of the reference with edge `j` of the play, both from 1. */
function pairCost(reference: readonly number[], edges: readonly number[], i: number, j: number): number {
  if ((i - j) % 2 !== 0) return Number.POSITIVE_INFINITY;
  return Math.abs(reference[i - 1] - edges[j - 1]);
}
