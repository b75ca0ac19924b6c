import type { WorkBudget } from '../../engine/index.ts';
import { type BlockingDisc, blockingDiscs, rangeDiscs } from './blockers.ts';
import { type OutlinePiece, outlinesOf } from './outline.ts';
import type { About, BarrierEdge, Blocker, Proof } from './proof.ts';
import { type Cell, type Judge, Quadtree } from './quadtree.ts';
import { exitOf, mouthDiscs } from './rims.ts';
import { distance, margin, surelyLess } from './rounding.ts';
import { px, subject, thing } from './say.ts';
import { ALL_ACCURACIES, CONTINUOUS, type Disc, type Setting, type Thing } from './setting.ts';

/** The smallest cell, px: gaps that differ less than this from those she fits through stay undecided. */
const UNIT = 0.25;

/** Cells larger than this, px, and than this share of the plane, are cut before anything is searched. */
const COARSE = 32;
const COARSE_SHARE = 1 / 128;

/** A plane wider than this is given up, cells: a level of that size has no use for a fine grid. */
const WIDEST = 1 << 30;

/** A plane cut finer than this is given up: what is left open would take too long. */
const MOST_LEAVES = 150_000;

/** So are searches that together have looked at so many cells. */
const MOST_VISITS = 3_000_000;

/** Where in the plane the tree lies and what blocks, in px from the start. */
interface Plane {
  readonly left: number;
  readonly bottom: number;
  readonly discs: readonly BlockingDisc[];
  readonly ranges: readonly Disc[];
  readonly goal: Disc;
}

/**
 * A closed barrier of hazards that stand still, and of what is out of range, between the start and the thing. The plane is cut
 * into squares, finer only where a way through is still open; squares count as blocked when they are so as a whole, for one reason.
 */
export function proveEnclosed(setting: Setting, about: About, goal: Thing): Proof | null {
  const { level, jump, maxTime, leastHalf } = setting;
  const near = { ...goal, r: goal.touch + jump };
  if (!surelyLess(near.r, distance(near, { x: 0, y: 0 }))) return null;
  const { asteroids: reached } = setting.reached;
  if (reached.length === 0) return null;
  const ranges = rangeDiscs(setting);
  const plane = planeAround(
    reached.map((i) => ranges[i]),
    blockingDiscs(setting, about),
    ranges,
    near,
  );
  if (plane.size > WIDEST) return null;
  const tree = new Quadtree(plane.size, judgeOf(plane, setting.budget), [...Array(plane.discs.length + ranges.length).keys()]);
  const inside = closeIn(tree, plane);
  if (inside === null) return null;
  const barrier = barrierOf(tree, inside, plane);
  if (barrier === null || level.wormholes.some((_, i) => leadsThrough(setting, barrier, 2 * i))) return null;
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
  reached: readonly Disc[],
  discs: readonly BlockingDisc[],
  ranges: readonly Disc[],
  goal: Disc,
): Plane & { size: number } {
  const left = reached.reduce((least, d) => Math.min(least, d.x - d.r), 0) - 4 * UNIT;
  const right = reached.reduce((most, d) => Math.max(most, d.x + d.r), 0) + 4 * UNIT;
  const bottom = reached.reduce((least, d) => Math.min(least, d.y - d.r), 0) - 4 * UNIT;
  const top = reached.reduce((most, d) => Math.max(most, d.y + d.r), 0) + 4 * UNIT;
  let size = 1;
  while (size <= WIDEST && size * UNIT < Math.max(right - left, top - bottom)) size *= 2;
  return { left, bottom, size, discs, ranges, goal };
}

/** What a square is: blocked by one disc, or out of range as a whole; free when nothing reaches into it and all of it is in range. */
function judgeOf({ left, bottom, discs, ranges }: Plane, budget: WorkBudget): Judge {
  return (cellX, cellY, size, nearby) => {
    const half = (size * UNIT) / 2;
    const x = left + cellX * UNIT + half;
    const y = bottom + cellY * UNIT + half;
    budget.look(1 + nearby.length / 2);
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
        if (isHazard) return { state: 'blocked', blocker: id, nearby: [] };
        inRange = true;
      }
      const nx = Math.max(0, dx - half);
      const ny = Math.max(0, dy - half);
      const near = Math.sqrt(nx * nx + ny * ny);
      if (near > disc.r + slack) continue;
      kept.push(id);
      if (!isHazard) someRange = true;
    }
    if (!someRange) return { state: 'blocked', blocker: discs.length, nearby: [] };
    const hazards = kept.some((id) => id < discs.length);
    return { state: inRange && !hazards ? 'free' : 'mixed', blocker: -1, nearby: kept };
  };
}

/** Every leaf she may get into from the start, when none of them is near the thing; null when a way is open, or may be. */
function closeIn(tree: Quadtree, plane: Plane): Cell[] | null {
  refineCoarse(tree, tree.root, Math.max(COARSE / UNIT, tree.root.size * COARSE_SHARE));
  const startX = Math.floor(-plane.left / UNIT);
  const startY = Math.floor(-plane.bottom / UNIT);
  let visits = 0;
  for (let search = 1; ; search++) {
    const start = tree.leafAt(startX, startY);
    if (start === null || start.state === 'blocked') return null;
    const { ends, visited } = flood(tree, start, search, plane);
    if (ends.length === 0) return visited;
    visits += visited.length;
    if (tree.leaves > MOST_LEAVES || visits > MOST_VISITS) return null;
    const divisible = new Set<Cell>();
    for (const end of ends) if (!gather(end, divisible)) return null;
    for (const cell of divisible) tree.split(cell);
  }
}

/** Adds the cells on the way to this one that may turn out to be blocked; false when there is none: the way is open, or can't be told to be closed. */
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

/** Everything she may get into, cells that are free first, and where she gets to the thing or over the rim of the plane. */
function flood(tree: Quadtree, start: Cell, search: number, { left, bottom, goal }: Plane): { ends: Cell[]; visited: Cell[] } {
  const visited: Cell[] = [];
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
      if (!over) {
        tree.neighbours(from, (next) => {
          if (next === null) over = true;
          else if (next.state !== 'blocked' && next.seen !== search) {
            next.seen = search;
            next.from = from;
            (next.state === 'free' ? now : later).push(next);
          }
        });
      }
      if (over) ends.push(from);
    }
    // a way through free cells alone needs no other
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

function passesMixed(end: Cell): boolean {
  for (let cell: Cell | null = end; cell !== null; cell = cell.from) if (cell.state === 'mixed') return true;
  return false;
}

/** The outline of the cells inside that has the start on one side and the thing on the other, with as few edges as may be. */
function barrierOf(tree: Quadtree, inside: readonly Cell[], plane: Plane): BarrierEdge[] | null {
  const members = new Set(inside);
  const blockers: Blocker[] = [...plane.discs.map(({ of }) => of), { kind: 'range' }];
  const toEdge = ({ x, y, blocker }: OutlinePiece): BarrierEdge => ({
    x: plane.left + x * UNIT,
    y: plane.bottom + y * UNIT,
    by: blockers[blocker],
  });
  for (const outline of outlinesOf(tree, inside, (cell) => members.has(cell))) {
    const edges = outline.map(toEdge);
    if (!separates(edges, plane.goal)) continue;
    const fewer = withFewerEdges(edges, plane);
    return separates(fewer, plane.goal) ? fewer : edges;
  }
  return null;
}

/** Whether a mouth's wormhole leads to the other side of a barrier, or lies on it. */
function leadsThrough({ level, jump }: Setting, barrier: readonly BarrierEdge[], mouth: number): boolean {
  const { x, y } = level.astronaut;
  const discs = mouthDiscs(level);
  const [near, far] = [discs[mouth], discs[exitOf(mouth)]].map((disc) => ({ ...disc, x: disc.x - x, y: disc.y - y }));
  if (isInside(barrier, near.x, near.y) !== isInside(barrier, far.x, far.y)) return true;
  return barrier.some((a, i) => {
    const b = barrier[(i + 1) % barrier.length];
    return [near, far].some((disc) => !surelyLess(disc.radius + jump, distanceToSegment(disc, a, b)));
  });
}

/** Whether the start and the thing lie on different sides of a closed line. */
function separates(edges: readonly BarrierEdge[], goal: Disc): boolean {
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

/** Joins edges of one blocker to one straight edge where that is blocked as well, and stays away from the thing. */
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
    // the longest edge that holds: halved until it does; an edge of the outline itself always does
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

/** @param width of the narrowest gap that her box can pass, px */
function reasonOf(about: About, barrier: readonly BarrierEdge[], width: number): string {
  const names = new Set<string>();
  for (const { by } of barrier) names.add(by.kind === 'range' ? 'the end of the range' : thing(by));
  const list = [...names];
  const named = list.length > MOST_NAMED ? [...list.slice(0, MOST_NAMED), `${list.length - MOST_NAMED} more`] : list;
  const last = named.pop();
  const what = named.length > 0 ? `${named.join(', ')} and ${last}` : `${last}`;
  return (
    `${subject(about)} is closed off from the start by ${what}: between them is no gap of ${px(width)}, the least her box can pass: ` +
    'move or remove one of them'
  );
}
