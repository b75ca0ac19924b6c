import type { WorkBudget } from '../../engine/index.ts';
import type { Disc } from '../../schema/basics/index.ts';
import { type BlockingDisc, blockingDiscs, rangeDiscs } from './blockers.ts';
import type { About, BarrierEdge, Blocker, Proof } from './proof.ts';
import { type Cell, type Judge, type OutlinePiece, outlinesOf, Quadtree, reachesInto } from './quadtree.ts';
import { distance, margin, surelyLess } from './rounding.ts';
import { px, subject, thing } from './say.ts';
import { ALL_ACCURACIES, CONTINUOUS, exitOf, mouthDiscs, type Setting, type Spot, type Thing } from './setting.ts';

/**
 * Side of the smallest cell, px. Gaps are decided only if they differ by more than this from the ones that she fits through.
 */
const UNIT = 0.25;

/** Cells larger than this, px, and larger than this share of the plane, are divided before the search begins. */
const COARSE = 32;
const COARSE_SHARE = 1 / 128;

/** The widest plane to examine, cells. */
const WIDEST = 1 << 30;

/** The most leaves of the quadtree. */
const MOST_LEAVES = 150_000;

/** The most cells that all searches together may visit. */
const MOST_VISITS = 3_000_000;

/** Looks that examining so many mouths, or cells in one, costs: none in ordinary levels. */
const mouthsLook = (count: number): number => count >> 3;

/** The plane of the quadtree and what blocks it, px from the start. */
interface Plane {
  readonly left: number;
  readonly bottom: number;
  readonly discs: readonly BlockingDisc[];
  readonly ranges: readonly Spot[];
  readonly goal: Spot;
  /** Where a wormhole may move her, in units of the quadtree; the other end of mouth i is mouth `exitOf(i)`. */
  readonly mouths: readonly Disc[];
}

/**
 * `enclosed`: a closed barrier separates the start from the object. No point of it can be the place of her centre, because each
 * edge lies in the disc of one hazard that stands still, or out of every asteroid's range. Her path is continuous, so she
 * cannot get to the other side. In `arcade` she is observed once per frame, so the discs are smaller by what a chord of one
 * frame's flight can cut off (lemma `chord`). Both mouths of each wormhole must lie on the same side, clear of the barrier.
 *
 * To find the barrier, a quadtree divides the plane. A cell is blocked if one disc contains all of it or all of it is out of
 * range. A flood fill from the start goes through all cells that are not blocked, and through wormholes. If it reaches the
 * object, the undecided cells on the path are divided and the search repeats, so that cells are small only where a gap is still
 * open. Once the object is out of reach, the outline of the visited cells is the barrier, which is then simplified. The checker
 * needs none of this: it tests the finished barrier edge by edge. Rests on the lemmas `way`, `reach`, `jump`, `chord`, `drift`
 * and `mouths`.
 */
export function proveEnclosed(setting: Setting, about: About, goal: Thing): Proof | null {
  const { level, jump, maxTime, leastHalf } = setting;
  const near = { ...goal, r: goal.touch + jump };
  if (!surelyLess(near.r, distance(near, { x: 0, y: 0 }))) return null;
  const { asteroids: reached } = setting.reached;
  if (reached.length === 0) return null;
  const ranges = rangeDiscs(setting);
  const plane = planeAround(
    setting,
    reached.map((i) => ranges[i]),
    blockingDiscs(setting, about),
    ranges,
    near,
  );
  if (plane.size > WIDEST) return null;
  const tree = new Quadtree(plane.size, judgeOf(plane, setting.budget), [...Array(plane.discs.length + ranges.length).keys()]);
  const inside = closeIn(tree, plane, setting.budget);
  if (inside === null) return null;
  const barrier = barrierOf(tree, inside, plane, setting);
  if (barrier === null) return null;
  const place = ({ x, y, by }: BarrierEdge): BarrierEdge => ({ x: x + level.astronaut.x, y: y + level.astronaut.y, by });
  return {
    code: 'enclosed',
    about,
    reason: reasonOf(about, barrier, 2 * leastHalf),
    covers: jump > 0 ? ALL_ACCURACIES : CONTINUOUS,
    maxTime: level.recoil ? maxTime : null,
    certificate: { kind: 'enclosed', barrier: barrier.map(place) },
  };
}

function planeAround(
  { level, jump }: Setting,
  reached: readonly Spot[],
  discs: readonly BlockingDisc[],
  ranges: readonly Spot[],
  goal: Spot,
): Plane & { size: number } {
  const left = reached.reduce((least, d) => Math.min(least, d.x - d.r), 0) - 4 * UNIT;
  const right = reached.reduce((most, d) => Math.max(most, d.x + d.r), 0) + 4 * UNIT;
  const bottom = reached.reduce((least, d) => Math.min(least, d.y - d.r), 0) - 4 * UNIT;
  const top = reached.reduce((most, d) => Math.max(most, d.y + d.r), 0) + 4 * UNIT;
  let size = 1;
  while (size <= WIDEST && size * UNIT < Math.max(right - left, top - bottom)) size *= 2;
  const mouths = mouthDiscs(level).map(({ x, y, radius }) => ({
    x: (x - level.astronaut.x - left) / UNIT,
    y: (y - level.astronaut.y - bottom) / UNIT,
    radius: (radius + jump + 4 * UNIT) / UNIT,
  }));
  return { left, bottom, size, discs, ranges, goal, mouths };
}

/**
 * Judges a cell: blocked when one disc contains it or all of it is out of range, free when no hazard reaches into it and all of
 * it is in range, else mixed. Nothing blocks a cell that a mouth of a wormhole reaches into, because no barrier may pass there.
 */
function judgeOf({ left, bottom, discs, ranges, mouths }: Plane, budget: WorkBudget): Judge {
  return (cellX, cellY, size, nearby) => {
    const square = { x: cellX, y: cellY, size };
    const inMouth = mouths.some((mouth) => reachesInto(mouth, square));
    const half = (size * UNIT) / 2;
    const x = left + cellX * UNIT + half;
    const y = bottom + cellY * UNIT + half;
    budget.look(1 + nearby.length / 2 + mouthsLook(mouths.length));
    const kept: number[] = [];
    let inRange = false;
    let someRange = false;
    for (const id of nearby) {
      const isHazard = id < discs.length;
      if (!isHazard && inRange) continue;
      const disc = isHazard ? discs[id] : ranges[id - discs.length];
      const dx = Math.abs(x - disc.x);
      const dy = Math.abs(y - disc.y);
      const slack = margin(dx + dy, disc.r);
      const far = Math.sqrt((dx + half) * (dx + half) + (dy + half) * (dy + half));
      if (far < disc.r - slack) {
        if (isHazard && !inMouth) return { state: 'blocked', blocker: id, nearby: [] };
        if (!isHazard) inRange = true;
      }
      const nx = Math.max(0, dx - half);
      const ny = Math.max(0, dy - half);
      const near = Math.sqrt(nx * nx + ny * ny);
      if (near > disc.r + slack) continue;
      kept.push(id);
      if (!isHazard) someRange = true;
    }
    if (!someRange && !inMouth) return { state: 'blocked', blocker: discs.length, nearby: [] };
    const hazards = kept.some((id) => id < discs.length);
    return { state: inRange && !hazards ? 'free' : 'mixed', blocker: -1, nearby: kept };
  };
}

/**
 * All leaves that she may get into from the start, when none of them is near the object; null when a gap is open or cannot be
 * excluded.
 */
function closeIn(tree: Quadtree, plane: Plane, budget: WorkBudget): Cell[] | null {
  refineCoarse(tree, tree.root, Math.max(COARSE / UNIT, tree.root.size * COARSE_SHARE));
  const startX = Math.floor(-plane.left / UNIT);
  const startY = Math.floor(-plane.bottom / UNIT);
  let visits = 0;
  for (let search = 1; ; search++) {
    const start = tree.leafAt(startX, startY);
    if (start === null || start.state === 'blocked') return null;
    const { ends, visited } = flood(tree, start, search, plane, budget);
    if (ends.length === 0) return visited;
    visits += visited.length;
    if (tree.leaves > MOST_LEAVES || visits > MOST_VISITS) return null;
    const divisible = new Set<Cell>();
    for (const end of ends) if (!gather(end, divisible)) return null;
    for (const cell of divisible) tree.split(cell);
  }
}

/**
 * Collects the mixed cells on the path to this one that can still be divided. Returns false when there is none, so that the
 * path is open or stays undecided.
 */
function gather(end: Cell, divisible: Set<Cell>): boolean {
  let some = false;
  for (let cell: Cell | null = end; cell !== null; cell = cell.from) {
    if (cell.state !== 'mixed' || cell.size === 1) continue;
    some = true;
    divisible.add(cell);
  }
  return some;
}

function refineCoarse(tree: Quadtree, cell: Cell, coarse: number): void {
  if (cell.state !== 'mixed' || cell.size <= coarse) return;
  for (const child of tree.split(cell)) refineCoarse(tree, child, coarse);
}

/**
 * Visits all cells that she may get into, free ones first. The ends are the cells where she reaches the object or leaves the
 * plane.
 */
function flood(tree: Quadtree, start: Cell, search: number, plane: Plane, budget: WorkBudget): { ends: Cell[]; visited: Cell[] } {
  const { left, bottom, goal, mouths } = plane;
  const visited: Cell[] = [];
  // Each mouth is entered once: then all cells at its other end are reached.
  const closed = new Set(mouths.keys());
  const ends: Cell[] = [];
  let now: Cell[] = [start];
  let later: Cell[] = [];
  start.seen = search;
  start.from = null;
  while (now.length > 0) {
    for (let cell = now.pop(); cell !== undefined; cell = now.pop()) {
      const from = cell;
      visited.push(from);
      let over = touches(from);
      const reach = (next: Cell | null): void => {
        if (next === null) over = true;
        else if (next.state !== 'blocked' && next.seen !== search) {
          next.seen = search;
          next.from = from;
          (next.state === 'free' ? now : later).push(next);
        }
      };
      if (!over) {
        tree.neighbours(from, reach);
        budget.look(mouthsLook(closed.size));
        for (const mouth of closed) {
          if (!reachesInto(mouths[mouth], from)) continue;
          closed.delete(mouth);
          const exit = mouths[exitOf(mouth)];
          if (isOutside(exit, tree.root.size)) over = true;
          let cells = 0;
          tree.inDisc(exit, (next) => {
            cells++;
            reach(next);
          });
          budget.look(mouthsLook(cells));
        }
      }
      if (over) ends.push(from);
    }
    // A path through free cells alone is certainly open; other ends do not matter then.
    if (ends.some((end) => !passesMixed(end))) return { ends: ends.filter((end) => !passesMixed(end)), visited };
    [now, later] = [later, now];
  }
  return { ends, visited };

  function touches({ x, y, size }: Cell): boolean {
    const half = (size * UNIT) / 2;
    const dx = Math.max(0, Math.abs(left + x * UNIT + half - goal.x) - half);
    const dy = Math.max(0, Math.abs(bottom + y * UNIT + half - goal.y) - half);
    return !surelyLess(goal.r, Math.sqrt(dx * dx + dy * dy));
  }
}

/** Whether a disc reaches out of a square with a corner at the origin. */
const isOutside = ({ x, y, radius }: Disc, size: number): boolean => Math.min(x, y) < radius || Math.max(x, y) > size - radius;

function passesMixed(end: Cell): boolean {
  for (let cell: Cell | null = end; cell !== null; cell = cell.from) if (cell.state === 'mixed') return true;
  return false;
}

/** The outline of the visited cells that separates the start from the object, with as few edges as possible. */
function barrierOf(tree: Quadtree, inside: readonly Cell[], plane: Plane, setting: Setting): BarrierEdge[] | null {
  const { astronaut } = setting.level;
  const mouths = mouthDiscs(setting.level).map((disc) => ({ ...disc, x: disc.x - astronaut.x, y: disc.y - astronaut.y }));
  const leads = (barrier: readonly BarrierEdge[]): boolean => {
    setting.budget.look(mouthsLook(mouths.length * barrier.length));
    return setting.level.wormholes.some((_, i) => leadsThrough(barrier, mouths[2 * i], mouths[2 * i + 1], setting.jump));
  };
  const members = new Set(inside);
  const blockers: Blocker[] = [...plane.discs.map(({ of }) => of), { kind: 'range' }];
  const toEdge = ({ x, y, blocker }: OutlinePiece): BarrierEdge => ({
    x: plane.left + x * UNIT,
    y: plane.bottom + y * UNIT,
    by: blockers[blocker],
  });
  for (const outline of outlinesOf(tree, inside, (cell) => members.has(cell))) {
    const edges = outline.map(toEdge);
    if (!separates(edges, plane.goal) || leads(edges)) continue;
    const fewer = withFewerEdges(edges, plane);
    return separates(fewer, plane.goal) && !leads(fewer) ? fewer : edges;
  }
  return null;
}

/** Whether a wormhole leads through a barrier, or one of its mouths lies on it. */
function leadsThrough(barrier: readonly BarrierEdge[], near: Disc, far: Disc, jump: number): boolean {
  if (isInside(barrier, near.x, near.y) !== isInside(barrier, far.x, far.y)) return true;
  return barrier.some((a, i) => {
    const b = barrier[(i + 1) % barrier.length];
    return [near, far].some((disc) => !surelyLess(disc.radius + jump, distanceToSegment(disc, a, b)));
  });
}

/** Whether the start and the object lie on different sides of a closed line. */
function separates(edges: readonly BarrierEdge[], goal: Spot): boolean {
  return isInside(edges, 0, 0) !== isInside(edges, goal.x, goal.y);
}

function isInside(edges: readonly BarrierEdge[], x: number, y: number): boolean {
  let inside = false;
  for (const [i, a] of edges.entries()) {
    const b = edges[(i + 1) % edges.length];
    if (a.y > y !== b.y > y && x < a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/** Joins consecutive edges of one blocker where the joined edge is blocked as well and keeps its distance from the object. */
function withFewerEdges(edges: readonly BarrierEdge[], { discs, ranges, goal }: Plane): BarrierEdge[] {
  const same = (a: Blocker, b: Blocker) => a === b;
  const first = edges.findIndex((edge, i) => !same(edge.by, edges[(i + edges.length - 1) % edges.length].by));
  const ring = [...edges.slice(Math.max(0, first)), ...edges.slice(0, Math.max(0, first))];
  const at = (i: number) => ring[i % ring.length];
  const holds = (from: number, to: number): boolean => {
    const a = at(from);
    const b = at(to);
    if (!surelyLess(goal.r, distanceToSegment(goal, a, b))) return false;
    return a.by.kind !== 'range' || ranges.every((disc) => surelyLess(disc.r, distanceToSegment(disc, a, b)));
  };
  const kept: BarrierEdge[] = [];
  for (let from = 0; from < ring.length; ) {
    let end = from + 1;
    while (end < ring.length && same(ring[end].by, ring[from].by)) end++;
    // Take the longest joined edge that holds, by halving. A single edge of the outline always holds.
    let to = end;
    while (to > from + 1 && !holds(from, to)) to = from + Math.max(1, Math.floor((to - from) / 2));
    kept.push(ring[from]);
    from = to;
  }
  return discs.length + ranges.length > 0 ? kept : [...edges];
}

function distanceToSegment(p: { x: number; y: number }, a: { x: number; y: number }, b: { x: number; y: number }): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const length2 = dx * dx + dy * dy;
  const t = length2 > 0 ? Math.max(0, Math.min(1, ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2)) : 0;
  return distance(p, { x: a.x + t * dx, y: a.y + t * dy });
}

const MOST_NAMED = 8;

/** @param width the narrowest gap that her box can pass, px */
function reasonOf(about: About, barrier: readonly BarrierEdge[], width: number): string {
  const names = new Set<string>();
  for (const { by } of barrier) names.add(by.kind === 'range' ? 'the edge of the range' : thing(by));
  const list = [...names];
  const named = list.length > MOST_NAMED ? [...list.slice(0, MOST_NAMED), `${list.length - MOST_NAMED} more`] : list;
  const last = named.pop();
  const what = named.length > 0 ? `${named.join(', ')} and ${last}` : `${last}`;
  return (
    `${subject(about)} is closed off from the start by ${what}: her collision box needs a gap of ${px(width)}, and there is none: ` +
    'move or remove one of them'
  );
}
