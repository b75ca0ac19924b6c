/** What is known of a cell. */
type CellState = 'free' | 'mixed' | 'blocked';

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
interface Judgement {
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

/** A piece of an outline between two corners of the unit grid, along an axis, with what blocks its far side. */
export interface OutlinePiece {
  readonly x: number;
  readonly y: number;
  readonly toX: number;
  readonly toY: number;
  readonly blocker: number;
}

/**
 * The closed outlines of a set of leaves, each with the set on its left. Where two leaves of the set share only a corner, the
 * outline passes between them.
 */
export function outlinesOf(tree: Quadtree, leaves: readonly Cell[], within: (cell: Cell) => boolean): OutlinePiece[][] {
  const pieces = leaves.flatMap((leaf) => rimOf(tree, leaf, within));
  const byStart = new Map<string, OutlinePiece[]>();
  for (const piece of pieces) {
    const key = `${piece.x},${piece.y}`;
    const here = byStart.get(key);
    if (here === undefined) byStart.set(key, [piece]);
    else here.push(piece);
  }
  const taken = new Set<OutlinePiece>();
  const outlines: OutlinePiece[][] = [];
  for (const first of pieces) {
    if (taken.has(first)) continue;
    const outline: OutlinePiece[] = [];
    let piece = first;
    while (!taken.has(piece)) {
      taken.add(piece);
      outline.push(piece);
      const next = byStart.get(`${piece.toX},${piece.toY}`) ?? [];
      const last = piece;
      piece = next.length === 1 ? next[0] : (next.find((other) => turnsLeft(last, other)) ?? next[0]);
    }
    outlines.push(outline);
  }
  return outlines;
}

const turnsLeft = (a: OutlinePiece, b: OutlinePiece): boolean =>
  (a.toX - a.x) * (b.toY - b.y) - (a.toY - a.y) * (b.toX - b.x) > 0;

/** The pieces of a leaf's sides at which the set ends, with the leaf on their left. */
function rimOf(tree: Quadtree, { x, y, size }: Cell, within: (cell: Cell) => boolean): OutlinePiece[] {
  const pieces: OutlinePiece[] = [];
  const side = (look: (at: number) => Cell | null, piece: (from: number, to: number) => Omit<OutlinePiece, 'blocker'>) => {
    for (let at = 0; at < size; ) {
      const beyond = look(at);
      const length = beyond === null ? size : Math.min(size - at, beyond.size);
      if (beyond !== null && !within(beyond)) pieces.push({ ...piece(at, at + length), blocker: beyond.blocker });
      at += length;
    }
  };
  const right = x + size;
  const top = y + size;
  side(
    (at) => tree.leafAt(x + at, y - 1),
    (a, b) => ({ x: x + a, y, toX: x + b, toY: y }),
  );
  side(
    (at) => tree.leafAt(right, y + at),
    (a, b) => ({ x: right, y: y + a, toX: right, toY: y + b }),
  );
  side(
    (at) => tree.leafAt(x + at, top),
    (a, b) => ({ x: x + b, y: top, toX: x + a, toY: top }),
  );
  side(
    (at) => tree.leafAt(x - 1, y + at),
    (a, b) => ({ x, y: y + b, toX: x, toY: y + a }),
  );
  return pieces;
}
