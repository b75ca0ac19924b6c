import { HALF_DIAGONAL, HALF_HEIGHT, HALF_WIDTH } from '../../engine/index.ts';
import type { Cone } from '../proofs/index.ts';
import type { Claim } from './claim.ts';
import { standingHazard } from './hazards.ts';
import { apart, less, type Point } from './rounded.ts';

/** Side of the squares, px; and half a diagonal of one and more: no place of a square is farther from a corner than this. */
const SIDE = 1;
const WITHIN = 1.5;

/** A certificate may not ask for more squares than this. */
const MOST = 200_000;

/** She may be so far beside the cone, px, and a hazard counts from this depth on. */
const SLACK = 0.02;

/** Two asteroids whose distances differ by less are equally near, px. */
const EQUAL = 1e-6;

/** The directions of the cone are looked at in so many parts. */
const PARTS = 24;

type Circle = Point & { readonly radius: number };

const cross = (a: Point, b: Point): number => a.x * b.y - a.y * b.x;
const dot = (a: Point, b: Point): number => a.x * b.x + a.y * b.y;

/**
 * At `apex` she leaves the line that she fell along, in the direction `ahead`. As long as every push she can get lies in the cone, her velocity does, and
 * she stays in the cone from the apex. The squares she may come through are followed from the apex until hazards or the end of the range stop her:
 * in none of them may a push lie outside the cone, or the thing be near. Her box points where the gun last pulled, so into the cone or the other way.
 */
export function checkDeadEnd(claim: Claim, { from, to }: Cone, apex: Point, ahead: Point, before: number): string | null {
  if (claim.level.recoil) return 'with recoil the border between two asteroids moves';
  if (claim.frames) return 'with frames she may jump over the border between two asteroids';
  const isUnit = (d: unknown): d is readonly [number, number] =>
    Array.isArray(d) && d.length === 2 && Math.abs(d[0] * d[0] + d[1] * d[1] - 1) < 1e-9;
  if (!isUnit(from) || !isUnit(to)) return 'its cone is none';
  const a = { x: from[0], y: from[1] };
  const b = { x: to[0], y: to[1] };
  const middle = { x: a.x + b.x, y: a.y + b.y };
  if (!(cross(a, b) > 1e-9 && dot(middle, middle) > 1e-3)) return 'its cone is not between nothing and half of all directions';
  const inCone = (d: Point) => cross(a, d) >= 0 && cross(d, b) >= 0 && dot(middle, d) > 0;
  if (!inCone(ahead)) return 'she may leave its cone as she comes';

  const asteroids = claim.level.asteroids.map(claim.place);
  const old = asteroids[before];
  // nearer than the one before at the apex, and ever more so in both directions: then all over the cone
  const takesOver = asteroids.some((other, i) => {
    if (i === before || !(apart(other, apex) <= apart(old, apex) + EQUAL)) return false;
    const step = { x: other.x - old.x, y: other.y - old.y };
    return dot(step, a) >= 0 && dot(step, b) >= 0 && dot(step, ahead) > 0;
  });
  if (!takesOver) return 'the asteroid before may be the nearest in its cone';
  const pulling = asteroids.filter((_, i) => i !== before);
  const fields = claim.level.repulsors.map(claim.place);
  const hazards = hazardsOf(claim);
  const turns = Array.from({ length: PARTS + 1 }, (_, n) => unit(mix(a, b, n / PARTS)));

  const seen = new Set<number>();
  const waiting: Point[] = [];
  const visit = (x: number, y: number) => {
    const key = (x + 32768) * 65536 + (y + 32768);
    if (Math.abs(x) > 32000 || Math.abs(y) > 32000 || seen.has(key)) return;
    seen.add(key);
    waiting.push({ x, y });
  };
  for (const x of [-1, 0]) for (const y of [-1, 0]) visit(x, y);
  for (let square = waiting.pop(); square !== undefined; square = waiting.pop()) {
    if (seen.size > MOST) return 'it takes too many squares to follow her';
    const corners = within(square, a, b).map((p) => ({ x: p.x + apex.x, y: p.y + apex.y }));
    if (corners.length === 0) continue;
    if (asteroids.every((rock) => corners.every((p) => less(claim.level.range + WITHIN, apart(p, rock))))) continue;
    if (hazards.some((hazard) => stops(hazard, corners, turns))) continue;
    if (corners.some((p) => !less(claim.touch + WITHIN, apart(p, claim.thing)))) return 'she may touch it off the line';
    for (const [i, rock] of pulling.entries()) {
      const isFarther = pulling.some((other, k) => k !== i && corners.every((p) => less(apart(p, other), apart(p, rock))));
      if (isFarther) continue;
      for (const p of corners) {
        if (!less(WITHIN, apart(p, rock)) || !inCone({ x: rock.x - p.x, y: rock.y - p.y }))
          return 'the gun may pull her out of its cone';
      }
    }
    for (const field of fields) {
      if (corners.every((p) => less(field.radius + WITHIN, apart(p, field)))) continue;
      for (const p of corners) {
        if (!less(WITHIN, apart(p, field)) || !inCone({ x: p.x - field.x, y: p.y - field.y }))
          return 'a field may push her out of its cone';
      }
    }
    for (const [dx, dy] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ])
      visit(square.x + dx, square.y + dy);
  }
  return null;
}

/** What stands still and ends the run; without recoil, hot asteroids do. */
function hazardsOf(claim: Claim): Circle[] {
  const { novae, asteroids } = claim.level;
  return [
    ...novae.map((_, index) => standingHazard(claim, { kind: 'nova', index })),
    ...asteroids.map((_, index) => standingHazard(claim, { kind: 'asteroid', index })),
    standingHazard(claim, { kind: 'blackHole', index: 0 }),
  ].filter((hazard) => hazard !== null);
}

/** What of a square lies in the cone, by its corners from the apex: the square without what is beyond either side. */
function within(square: Point, a: Point, b: Point): Point[] {
  const sides = [(p: Point) => cross(a, p), (p: Point) => cross(p, b), (p: Point) => dot(a, p) + dot(b, p)];
  let corners = [
    { x: square.x * SIDE, y: square.y * SIDE },
    { x: (square.x + 1) * SIDE, y: square.y * SIDE },
    { x: (square.x + 1) * SIDE, y: (square.y + 1) * SIDE },
    { x: square.x * SIDE, y: (square.y + 1) * SIDE },
  ];
  for (const side of sides) {
    const left: Point[] = [];
    for (const [i, p] of corners.entries()) {
      const q = corners[(i + 1) % corners.length];
      const here = side(p) + SLACK;
      const there = side(q) + SLACK;
      if (here >= 0) left.push(p);
      if (here * there < 0) left.push(mix(p, q, here / (here - there)));
    }
    corners = left;
  }
  return corners;
}

/** Whether a hazard stops her at every place between the corners: however her box is turned, or turned in any direction of the cone. */
function stops(hazard: Circle, corners: readonly Point[], turns: readonly Point[]): boolean {
  if (corners.every((p) => less(apart(p, hazard), hazard.radius + HALF_WIDTH - SLACK))) return true;
  if (corners.some((p) => apart(p, hazard) > hazard.radius + HALF_DIAGONAL)) return false;
  return turns.slice(1).every((turn, n) => {
    const swing = HALF_DIAGONAL * apart(turn, turns[n]);
    return corners.every((p) => less(gap(p, turn, hazard) + swing, -SLACK));
  });
}

/** Gap between her box and a circle, px; negative where they overlap. */
function gap(centre: Point, side: Point, circle: Circle): number {
  const way = { x: circle.x - centre.x, y: circle.y - centre.y };
  const along = Math.max(0, Math.abs(dot(way, side)) - HALF_WIDTH);
  const across = Math.max(0, Math.abs(cross(side, way)) - HALF_HEIGHT);
  return Math.sqrt(along * along + across * across) - circle.radius;
}

const mix = (p: Point, q: Point, t: number): Point => ({ x: p.x + t * (q.x - p.x), y: p.y + t * (q.y - p.y) });
const unit = ({ x, y }: Point): Point => ({ x: x / Math.sqrt(x * x + y * y), y: y / Math.sqrt(x * x + y * y) });
