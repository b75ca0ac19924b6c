import type { Attempt, FailureCause } from '../../../check/plays/index.ts';
import { causeInWords } from '../attempts/index.ts';

/** Side of a square of the map, px: about the width of the astronaut. */
const SIDE = 24;

/** Where players die: squares with the number of deaths in each. */
export interface DeathMap {
  /** Side of a square, px. */
  readonly cellSize: number;
  /** The middle of each square, px, and the deaths in it. */
  readonly cells: readonly { readonly x: number; readonly y: number; readonly visits: number }[];
  /** The number of all deaths. */
  readonly deaths: number;
  /** Who died in each square, by its place in the grid. */
  readonly squares: ReadonlyMap<string, readonly Death[]>;
}

interface Death {
  readonly x: number;
  readonly y: number;
  readonly cause: FailureCause;
}

const DEADLY: ReadonlySet<FailureCause['kind']> = new Set(['nova', 'asteroid', 'alien', 'lost']);

const indexOf = (place: number): number => Math.floor(place / SIDE);
const keyOf = (column: number, row: number): string => `${column},${row}`;

/** The map of the attempts in which she dies; null if there is none. Time-outs and attempts that were left are no deaths. */
export function deathMapOf(attempts: readonly Pick<Attempt, 'x' | 'y' | 'cause'>[]): DeathMap | null {
  const squares = new Map<string, Death[]>();
  let deaths = 0;
  for (const { x, y, cause } of attempts) {
    if (cause === null || !DEADLY.has(cause.kind)) continue;
    deaths++;
    const key = keyOf(indexOf(x), indexOf(y));
    const square = squares.get(key);
    if (square === undefined) squares.set(key, [{ x, y, cause }]);
    else square.push({ x, y, cause });
  }
  if (deaths === 0) return null;
  const cells = [...squares].map(([key, { length: visits }]) => {
    const [column, row] = key.split(',').map(Number);
    return { x: (column + 0.5) * SIDE, y: (row + 0.5) * SIDE, visits };
  });
  return { cellSize: SIDE, cells, squares, deaths };
}

/** The deaths near a place, by cause, the most frequent first. @param reach px */
export function deathsNear({ squares }: DeathMap, x: number, y: number, reach: number): { cause: string; count: number }[] {
  const counts = new Map<string, number>();
  for (let column = indexOf(x - reach); column <= indexOf(x + reach); column++) {
    for (let row = indexOf(y - reach); row <= indexOf(y + reach); row++) {
      for (const death of squares.get(keyOf(column, row)) ?? []) {
        if ((death.x - x) ** 2 + (death.y - y) ** 2 > reach ** 2) continue;
        const cause = causeInWords(death.cause);
        counts.set(cause, (counts.get(cause) ?? 0) + 1);
      }
    }
  }
  return [...counts].map(([cause, count]) => ({ cause, count })).sort((a, b) => b.count - a.count);
}
