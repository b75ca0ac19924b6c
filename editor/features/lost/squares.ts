import type { LostKnown, LostState } from '../../workers/index.ts';

/** Side of a square of the shade, px of the level. */
export const LOST_SQUARE = 32;

/** A square of the shade: she was seen in it, alive, in a state that is lost. */
export interface LostSquare {
  /** Its left and upper edge, px. */
  readonly x: number;
  readonly y: number;
  /** `proved` if any of its states is proved lost. */
  readonly known: LostKnown;
  /** How many lost states were seen in it. */
  readonly states: number;
}

/** The squares of a grid that have lost states in them, row by row. */
export function squaresOf(states: readonly Pick<LostState, 'x' | 'y' | 'known'>[]): LostSquare[] {
  const squares = new Map<string, { x: number; y: number; known: LostKnown; states: number }>();
  for (const { x, y, known } of states) {
    const corner = { x: Math.floor(x / LOST_SQUARE) * LOST_SQUARE, y: Math.floor(y / LOST_SQUARE) * LOST_SQUARE };
    const key = `${corner.x} ${corner.y}`;
    const square = squares.get(key) ?? { ...corner, known, states: 0 };
    square.states++;
    if (known === 'proved') square.known = known;
    squares.set(key, square);
  }
  return [...squares.values()].sort((a, b) => a.y - b.y || a.x - b.x);
}
