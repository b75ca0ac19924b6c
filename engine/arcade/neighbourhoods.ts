import type { Circles } from '../circles.ts';
import type { IndexedCircles } from '../indexed-circles.ts';
import type { Scene } from '../scene.ts';

/** Side of a cell, px. */
const SIDE = 32;

/** A square's half diagonal divided by half its side, rounded up. */
const DIAGONAL = 1.4143;

/** No place in a cell is farther than this from its centre, px. */
const REACH = (SIDE / 2) * DIAGONAL;

/** Half sides of squares around a quiet cell that may be as quiet, px; the largest such square is used. */
const FREE = [96, 64, 40];

/** How far recoil may move an asteroid from its original place before its neighbourhoods become invalid, px. */
export const DRIFT = 16;

/** Cells are kept on a torus of 2^BITS by 2^BITS: in a level smaller than 2048 px no two of them share a slot. */
const BITS = 6;
const MASK = (1 << BITS) - 1;

/**
 * What can matter to her anywhere in a square, in the order in which the original game examines it. Everything else is farther
 * away than rounding could bridge, so leaving it out changes no bit.
 */
interface Survey {
  /** Targets that may be the nearest, ascending. */
  readonly rivals: Int32Array;
  /** Codes of what ends the run by touch: 0 is the black hole, novae begin at 1, targets at 1 + novae; ascending. */
  readonly deadly: Int32Array;
  readonly minerals: Int32Array;
  readonly repulsors: Int32Array;
  /** Discs of each frame rule. */
  readonly discs: readonly Int32Array[];
  /** Only the gun acts: nothing can be touched, there is no field, and the range does not end. */
  readonly quiet: boolean;
  /** Aliens at their places in the level neither see nor touch her. */
  readonly unseen: boolean;
}

/** A square cell and what can matter anywhere in it. */
export interface Neighbourhood extends Survey {
  /** Bounds of the cell, px: from `left` and `top` inclusive to `right` and `bottom` exclusive. */
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  /** Bounds of a larger area around a quiet cell in which it is as quiet, with the same rivals and the same `unseen`, px. */
  readonly freeLeft: number;
  readonly freeRight: number;
  readonly freeTop: number;
  readonly freeBottom: number;
}

interface Cell extends Neighbourhood {
  readonly column: number;
  readonly row: number;
}

const all = (count: number): Int32Array => Int32Array.from({ length: count }, (_, i) => i);

/** Neighbourhoods of a scene, each made when she first comes there. They depend on the level alone, so all runs share them. */
export class Neighbourhoods {
  /** A neighbourhood that leaves nothing out, for places and times that the cells do not cover. */
  readonly everything: Neighbourhood;
  private readonly cells: (Cell | null)[] = new Array(1 << (2 * BITS)).fill(null);
  private readonly drift: number;

  constructor(
    private readonly scene: Scene,
    /** Discs of each frame rule. */
    private readonly discs: readonly Circles[],
  ) {
    const { targets, coldCount, novae, minerals, repulsors, level } = scene;
    this.drift = level.recoil ? DRIFT : 0;
    const hot = all(targets.count).slice(coldCount);
    this.everything = {
      left: Number.NEGATIVE_INFINITY,
      right: Number.POSITIVE_INFINITY,
      top: Number.NEGATIVE_INFINITY,
      bottom: Number.POSITIVE_INFINITY,
      rivals: all(targets.count),
      deadly: Int32Array.from([...all(1 + novae.count), ...hot.map((i) => 1 + novae.count + i)]),
      minerals: all(minerals.count),
      repulsors: all(repulsors.count),
      discs: discs.map(({ count }) => all(count)),
      quiet: false,
      freeLeft: 0,
      freeRight: 0,
      freeTop: 0,
      freeBottom: 0,
      unseen: false,
    };
  }

  /** The neighbourhood of a place, px. */
  at(x: number, y: number): Neighbourhood {
    const column = Math.floor(x / SIDE);
    const row = Math.floor(y / SIDE);
    const slot = ((row & MASK) << BITS) | (column & MASK);
    const kept = this.cells[slot];
    if (kept !== null && kept.column === column && kept.row === row) return kept;
    const cell = this.make(column, row);
    this.cells[slot] = cell;
    return cell;
  }

  private make(column: number, row: number): Cell {
    const x = (column + 0.5) * SIDE;
    const y = (row + 0.5) * SIDE;
    const here = this.survey(x, y, SIDE / 2);
    let free = SIDE / 2;
    if (here.quiet) {
      for (const half of FREE) {
        const wide = this.survey(x, y, half);
        if (!wide.quiet || wide.rivals.length > here.rivals.length || wide.unseen !== here.unseen) continue;
        free = half;
        break;
      }
    }
    // written out: V8 gives copies made with `...` hidden classes of their own, which makes every access slow
    return {
      column,
      row,
      rivals: here.rivals,
      deadly: here.deadly,
      minerals: here.minerals,
      repulsors: here.repulsors,
      discs: here.discs,
      quiet: here.quiet,
      unseen: here.unseen,
      left: column * SIDE,
      right: (column + 1) * SIDE,
      top: row * SIDE,
      bottom: (row + 1) * SIDE,
      freeLeft: x - free,
      freeRight: x + free,
      freeTop: y - free,
      freeBottom: y + free,
    };
  }

  /** What can matter to her in the square around (x, y) with half side `half`, px. */
  private survey(x: number, y: number, half: number): Survey {
    const { scene, drift } = this;
    const { targets, coldCount, novae, minerals, repulsors, aliens, level } = scene;
    const { halfDiagonal } = scene.box;
    const toCorner = half * DIAGONAL;
    const distance = (cx: number, cy: number) => Math.sqrt((cx - x) * (cx - x) + (cy - y) * (cy - y));
    // whether a distance from the centre may be below `reach` somewhere in the square; the margin is far above any rounding
    const within = (d: number, reach: number) => d <= (reach + toCorner + 1e-3) * (1 + 1e-9) + d * 1e-9;
    const touching = (circles: IndexedCircles, moves: number): number[] => {
      const near = circlesAround(circles, x, y, toCorner + halfDiagonal + moves + 1);
      return near.filter((i) => within(distance(circles.x[i], circles.y[i]), halfDiagonal + circles.r[i] + moves));
    };

    const hole = level.blackHole;
    const deadly = within(distance(hole.x, hole.y), halfDiagonal + hole.radius) ? [0] : [];
    for (const i of touching(novae, 0)) deadly.push(1 + i);
    for (const i of touching(targets, drift)) if (i >= coldCount) deadly.push(1 + novae.count + i);
    const collectable = touching(minerals, 0);
    // a field matters unless the whole square is inside it or outside
    const pushing = circlesAround(repulsors, x, y, toCorner + 1).filter((i) =>
      within(distance(repulsors.x[i], repulsors.y[i]), repulsors.r[i]),
    );
    const discs = this.discs.map((circles) =>
      all(circles.count).filter((i) => within(distance(circles.x[i], circles.y[i]), circles.r[i])),
    );
    const closest = nearestDistance(targets, x, y, distance);
    const slack = 2 * (toCorner + drift);
    const rivals =
      closest === null
        ? []
        : circlesAround(targets, x, y, (closest + slack + 1) * (1 + 1e-9)).filter((i) =>
            within(distance(targets.x[i], targets.y[i]), closest + slack),
          );
    const inRange = closest !== null && !(closest * (1 + 1e-9) + toCorner + drift + 1e-3 >= level.range);
    let unseen = true;
    for (let i = 0; i < aliens.count && unseen; i++) {
      unseen = !within(distance(aliens.x[i], aliens.y[i]), Math.max(scene.rules.alienSight, halfDiagonal + aliens.r[i]));
    }
    return {
      rivals: Int32Array.from(rivals),
      deadly: Int32Array.from(deadly),
      minerals: Int32Array.from(collectable),
      repulsors: Int32Array.from(pushing),
      discs,
      quiet:
        inRange &&
        deadly.length === 0 &&
        collectable.length === 0 &&
        pushing.length === 0 &&
        discs.every(({ length }) => length === 0),
      unseen,
    };
  }
}

/** Whether the whole cell lies within `radius` of (x, y), px; false where rounding could decide. */
export function liesWithin({ left, right, top, bottom }: Neighbourhood, x: number, y: number, radius: number): boolean {
  const dx = (left + right) / 2 - x;
  const dy = (top + bottom) / 2 - y;
  const inner = radius - REACH;
  return inner > 0 && dx * dx + dy * dy < inner * inner;
}

/** Indices, ascending, of at least all circles that come nearer than `reach` px to a place. */
function circlesAround(circles: IndexedCircles, x: number, y: number, reach: number): number[] {
  if (circles.spatial === null) return Array.from({ length: circles.count }, (_, i) => i);
  return [...circles.spatial.around(x, y, reach)].sort((a, b) => a - b);
}

function nearestDistance(
  circles: IndexedCircles,
  x: number,
  y: number,
  distance: (x: number, y: number) => number,
): number | null {
  const of = (list: Circles, i: number) => distance(list.x[i], list.y[i]);
  if (circles.spatial !== null) return of(circles, circles.spatial.nearestCentre(x, y));
  let closest: number | null = null;
  for (let i = 0; i < circles.count; i++) {
    const d = of(circles, i);
    if (closest === null || d < closest) closest = d;
  }
  return closest;
}
