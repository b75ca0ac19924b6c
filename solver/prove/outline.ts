import type { Cell, Quadtree } from './quadtree.ts';

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
