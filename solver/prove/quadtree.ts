/** What is known of a cell. */
export type CellState = 'free' | 'mixed' | 'blocked';

/** A square of whole units, given by its lower left corner and side. A leaf has no children. */
export interface Cell {
  readonly x: number;
  readonly y: number;
  readonly size: number;
  readonly state: CellState;
  /** The disc that contains all of it, or -1. */
  readonly blocker: number;
  /** The discs that reach into it; its quarters need to examine no others. */
  readonly nearby: readonly number[];
  children: readonly Cell[] | null;
  /** Marks of a search: the cell from which this one was reached, and the number of the search. */
  from: Cell | null;
  seen: number;
}

/** The state of a square, judged from the discs that reach into its parent. */
export interface Judgement {
  readonly state: CellState;
  readonly blocker: number;
  readonly nearby: readonly number[];
}

/** Judges the square with this corner and side, in units. */
export type Judge = (x: number, y: number, size: number, nearby: readonly number[]) => Judgement;

/** A disc; centre and radius in units. */
interface UnitDisc {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
}

/** Whether a disc reaches into a square. */
export function reachesInto({ x, y, radius }: UnitDisc, square: Pick<Cell, 'x' | 'y' | 'size'>): boolean {
  const dx = Math.max(0, square.x - x, x - square.x - square.size);
  const dy = Math.max(0, square.y - y, y - square.y - square.size);
  return dx * dx + dy * dy <= radius * radius;
}

/** A square of `size` units (a power of two) that is divided into quarters where necessary. */
export class Quadtree {
  readonly root: Cell;
  private readonly judge: Judge;
  leaves = 1;

  constructor(size: number, judge: Judge, all: readonly number[]) {
    this.judge = judge;
    this.root = this.cell(0, 0, size, all);
  }

  private cell(x: number, y: number, size: number, nearby: readonly number[]): Cell {
    return { x, y, size, ...this.judge(x, y, size, nearby), children: null, from: null, seen: 0 };
  }

  /** Divides a leaf into quarters. */
  split(leaf: Cell): readonly Cell[] {
    const half = leaf.size / 2;
    const { x, y, nearby } = leaf;
    leaf.children = [
      this.cell(x, y, half, nearby),
      this.cell(x + half, y, half, nearby),
      this.cell(x, y + half, half, nearby),
      this.cell(x + half, y + half, half, nearby),
    ];
    this.leaves += 3;
    return leaf.children;
  }

  /** The leaf that contains the unit square at (x, y); null outside. */
  leafAt(x: number, y: number): Cell | null {
    let cell = this.root;
    if (x < 0 || y < 0 || x >= cell.size || y >= cell.size) return null;
    while (cell.children !== null) {
      const half = cell.size / 2;
      cell = cell.children[(x >= cell.x + half ? 1 : 0) + (y >= cell.y + half ? 2 : 0)];
    }
    return cell;
  }

  /**
   * Calls `visit` for each leaf that shares part of a side with this one, and with null for a side on the boundary of the whole
   * square.
   */
  neighbours(leaf: Cell, visit: (neighbour: Cell | null) => void): void {
    const { x, y, size } = leaf;
    this.along(x + size, y, size, false, visit);
    this.along(x - 1, y, size, false, visit);
    this.along(x, y + size, size, true, visit);
    this.along(x, y - 1, size, true, visit);
  }

  /** Calls `visit` for each leaf that a disc reaches into; centre and radius in units. */
  inDisc(disc: UnitDisc, visit: (leaf: Cell) => void, cell = this.root): void {
    if (!reachesInto(disc, cell)) return;
    if (cell.children === null) visit(cell);
    else for (const child of cell.children) this.inDisc(disc, visit, child);
  }

  private along(x: number, y: number, size: number, across: boolean, visit: (neighbour: Cell | null) => void): void {
    for (let at = 0; at < size; ) {
      const neighbour = across ? this.leafAt(x + at, y) : this.leafAt(x, y + at);
      visit(neighbour);
      if (neighbour === null || neighbour.size >= size) return;
      at += neighbour.size;
    }
  }
}
