import type { IndexedCircles } from '../indexed-circles.ts';
import type { Scene } from '../scene.ts';
import { type Deadly, NONE, Square, type Watchers } from './square.ts';

/** Side of a cell, px. */
const SIDE = 32;

/** How far recoil may move an asteroid from its original place before its neighbourhoods become invalid, px. */
export const DRIFT = 16;

/** A level with so few things is one neighbourhood. */
const FEW = 24;

/**
 * Cells are kept on a torus of 2^bits by 2^bits. Most runs come to few cells, so it begins small, and grows: in a level smaller
 * than 2048 px no two of them share a slot of the largest torus.
 */
const FIRST_BITS = 3;
const LAST_BITS = 6;

/**
 * A square cell and what can matter to her anywhere in it, in the order in which the original game examines it. Everything else
 * is farther away than rounding could bridge, so leaving it out changes no bit.
 */
export interface Neighbourhood {
  /** Targets that may be the nearest, ascending. */
  readonly rivals: Int32Array;
  /** Codes of what ends the run by touch, ascending; 0 is the black hole. */
  readonly deadly: Int32Array;
  /** What she may collect by touch. */
  readonly collectables: Int32Array;
  /** Discs of each frame rule. */
  readonly discs: readonly Int32Array[];
  /** How many of all these a frame here looks at. */
  readonly things: number;
  /** Chasers at their places in the level neither see nor touch her. */
  readonly unseen: boolean;
  /** Bounds of the cell, px: from `left` and `top` inclusive to `right` and `bottom` exclusive. */
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

interface Cell extends Neighbourhood {
  readonly column: number;
  readonly row: number;
}

/** The whole numbers from 0 up to `count`, which is left out. */
function below(count: number): Int32Array {
  const all = new Int32Array(count);
  for (let i = 0; i < count; i++) all[i] = i;
  return all;
}

const emptyTorus = (bits: number): (Cell | null)[] => new Array(1 << (2 * bits)).fill(null);

function slotOf(column: number, row: number, bits: number): number {
  const mask = (1 << bits) - 1;
  return ((row & mask) << bits) | (column & mask);
}

/** Neighbourhoods of a scene, each made when she first comes there. They depend on the level alone, so all runs share them. */
export class Neighbourhoods {
  /** A neighbourhood that leaves nothing out, for places and times that the cells do not cover. */
  readonly everything: Neighbourhood;
  private bits = FIRST_BITS - 1;
  private cells: (Cell | null)[] = [];
  /** How many cells were made since the torus has had its size. */
  private made = 0;
  private readonly square: Square;
  /** Whether there is so little in the level that leaving out what is far away takes longer than to look at it. */
  readonly isOne: boolean;
  /** The cell that was made last. */
  private last: Cell | null = null;

  constructor(
    scene: Scene,
    chasers: Watchers,
    /** What ends the run by touch, besides the black hole. */
    lists: readonly Deadly[],
    private readonly collectables: IndexedCircles,
    /** Discs of each frame rule. */
    private readonly discs: readonly IndexedCircles[],
    /** Which of these count as looks of the budget. */
    private readonly areWork: readonly boolean[],
  ) {
    const { targets, level } = scene;
    this.square = new Square(scene, chasers, lists, level.recoil ? DRIFT : 0);
    const deadly = new Int32Array(lists.reduce((sum, { first, circles }) => sum + circles.count - first, 1));
    let at = 1;
    for (const { from, first, circles } of lists) for (let i = first; i < circles.count; i++) deadly[at++] = from + i;
    const discCounts = discs.map(({ count }) => count);
    const others = targets.count + deadly.length + collectables.count + chasers.circles.count;
    this.isOne = discCounts.reduce((sum, count) => sum + count, others) <= FEW;
    this.everything = {
      left: Number.NEGATIVE_INFINITY,
      right: Number.POSITIVE_INFINITY,
      top: Number.NEGATIVE_INFINITY,
      bottom: Number.POSITIVE_INFINITY,
      rivals: below(targets.count),
      deadly,
      collectables: below(collectables.count),
      discs: discCounts.map(below),
      // among few things a frame costs about as much as among none
      things: this.isOne ? 0 : deadly.length + collectables.count + this.looks(discCounts),
      unseen: false,
    };
  }

  /** The neighbourhood of a place, px. */
  at(x: number, y: number): Neighbourhood {
    const column = Math.floor(x / SIDE);
    const row = Math.floor(y / SIDE);
    const kept = this.cells[slotOf(column, row, this.bits)] ?? null;
    if (kept !== null && kept.column === column && kept.row === row) return kept;
    const cell = this.make(column, row);
    this.keep(cell);
    return cell;
  }

  private keep(cell: Cell): void {
    // it is made with the first cell; when it is a quarter full, cells begin to take each other's slots
    if (++this.made > this.cells.length >> 2 && this.bits < LAST_BITS) {
      const before = this.cells;
      this.bits++;
      this.made = 0;
      this.cells = emptyTorus(this.bits);
      for (const one of before) if (one !== null) this.cells[slotOf(one.column, one.row, this.bits)] = one;
    }
    this.cells[slotOf(cell.column, cell.row, this.bits)] = cell;
  }

  private make(column: number, row: number): Cell {
    const { square } = this;
    const x = (column + 0.5) * SIDE;
    const y = (row + 0.5) * SIDE;
    square.place(x, y, SIDE / 2);
    const { last } = this;
    square.addDeadly();
    const deadly = square.taken(last?.deadly ?? NONE);
    square.addTouching(this.collectables);
    const collectables = square.taken(last?.collectables ?? NONE);
    const discs = this.discs.map((list, k) => {
      square.addDiscs(list);
      return square.taken(last?.discs[k] ?? NONE);
    });
    square.addRivals();
    const rivals = square.taken(last?.rivals ?? NONE);
    // written out: V8 gives copies made with `...` hidden classes of their own, which makes every access slow
    const cell: Cell = {
      column,
      row,
      rivals,
      deadly,
      collectables,
      discs,
      things: deadly.length + collectables.length + this.looks(discs.map(({ length }) => length)),
      unseen: square.isUnseen,
      left: column * SIDE,
      right: (column + 1) * SIDE,
      top: row * SIDE,
      bottom: (row + 1) * SIDE,
    };
    this.last = cell;
    return cell;
  }

  /** How many of so many discs of each frame rule count as looks. */
  private looks(counts: readonly number[]): number {
    return counts.reduce((sum, count, k) => (this.areWork[k] ? sum + count : sum), 0);
  }
}
