/** Indices of the edges that are shifted together. */
export type Move = readonly number[];

/**
 * The ways in which a person would re-time a run: one press or release by itself, a hold as a whole, and everything from one edge
 * on.
 * @param count edges that may be shifted, from the first
 */
export function movesOf(count: number): Move[] {
  const moves: Move[] = [];
  for (let i = 0; i < count; i++) moves.push([i]);
  for (let i = 0; i + 1 < count; i += 2) if (i + 2 < count) moves.push([i, i + 1]);
  for (let i = 0; i + 1 < count; i++) moves.push(Array.from({ length: count - i }, (_, k) => i + k));
  return moves;
}

/** Shifts the edges of a move by so many ticks. */
export function shifted(edges: readonly number[], move: Move, by: number): number[] {
  const moved = [...edges];
  for (const i of move) moved[i] += by;
  return moved;
}

/** How far all edges together are from where they were, ticks. */
export const totalShift = (edges: readonly number[], own: readonly number[]): number =>
  edges.reduce((sum, edge, i) => sum + Math.abs(edge - own[i]), 0);
