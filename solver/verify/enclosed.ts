import type { BarrierEdge, Blocker } from '../proofs/index.ts';
import type { Claim } from './claim.ts';
import { standingHazard } from './hazards.ts';
import { mouthsOf } from './mouths.ts';
import { apart, less, type Point } from './rounded.ts';

const START = { x: 0, y: 0 };

/**
 * A closed line between the start and the thing. No point of it can be her centre's: each edge lies in the disc of one hazard
 * that stands still, or out of range as a whole. The thing lies on the other side, farther from the line than she can touch it from.
 * A wormhole has both of its mouths on one side, so that it takes her from the start's side to the start's side.
 */
export function checkEnclosed(claim: Claim, barrier: readonly BarrierEdge[]): string | null {
  if (!Array.isArray(barrier) || barrier.length < 3) return 'its barrier is no closed line';
  if (!barrier.every((edge) => Number.isFinite(edge?.x) && Number.isFinite(edge?.y)))
    return 'a corner of its barrier is no place';
  const corners = barrier.map(({ x, y }) => claim.place({ x, y }));
  // a look that shows her touching the thing may come after a jump over the line
  const touch = claim.touch + claim.jump;
  for (const [i, { by }] of barrier.entries()) {
    const a = corners[i];
    const b = corners[(i + 1) % corners.length];
    if (!less(touch, distanceToSegment(claim.thing, a, b))) return `she may touch it from edge ${i} of the barrier`;
    if (!less(0, distanceToSegment(START, a, b))) return `the start lies on edge ${i} of the barrier`;
    const why = by?.kind === 'range' ? checkOutside(claim, a, b) : checkHazard(claim, by, a, b);
    if (why !== null) return `edge ${i} of the barrier: ${why}`;
  }
  if (isInside(corners, START) === isInside(corners, claim.thing)) return 'the barrier does not lie between the start and it';
  return checkMouths(claim, corners);
}

function checkMouths(claim: Claim, corners: readonly Point[]): string | null {
  for (const mouth of mouthsOf(claim)) {
    if (isInside(corners, mouth) !== isInside(corners, mouth.exit)) return 'a wormhole leads through the barrier';
    // with frames she goes on from there before she is looked at
    const reach = mouth.radius + claim.jump;
    const isNear = (a: Point, i: number) => !less(reach, distanceToSegment(mouth, a, corners[(i + 1) % corners.length]));
    if (corners.some(isNear)) return 'a mouth of a wormhole lies on the barrier';
  }
  return null;
}

/** The whole edge is farther than the range from every asteroid; between two looks she may cut half a jump of a corner. */
function checkOutside(claim: Claim, a: Point, b: Point): string | null {
  const near = claim.level.asteroids.findIndex((asteroid, i) => {
    const reach = claim.level.range + claim.drift(i) + claim.jump / 2;
    return !less(reach, distanceToSegment(claim.place(asteroid), a, b));
  });
  return near < 0 ? null : `it is in range of asteroids[${near}]`;
}

/**
 * Both ends, and so the whole edge, lie in the disc about a hazard in which her box, however turned, overlaps it. The straight
 * way between two looks outside of a disc enters it no deeper than a chord of that length does.
 */
function checkHazard(claim: Claim, by: Blocker, a: Point, b: Point): string | null {
  const hazard = standingHazard(claim, by);
  if (hazard === null) return 'what it names is no hazard that stands still';
  const r = hazard.radius + claim.inner;
  if (!less(claim.jump / 2, r)) return 'she may jump over it';
  const radius = Math.sqrt(r * r - (claim.jump * claim.jump) / 4);
  return less(apart(a, hazard), radius) && less(apart(b, hazard), radius) ? null : 'it leaves the hazard it names';
}

function distanceToSegment(p: Point, a: Point, b: Point): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const length2 = dx * dx + dy * dy;
  const t = length2 > 0 ? Math.max(0, Math.min(1, ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2)) : 0;
  return apart(p, { x: a.x + t * dx, y: a.y + t * dy });
}

/** Whether a place lies inside of a closed line: a ray to the right crosses it an odd number of times. */
function isInside(corners: readonly Point[], p: Point): boolean {
  return corners.reduce((inside, a, i) => {
    const b = corners[(i + 1) % corners.length];
    const crosses = a.y > p.y !== b.y > p.y && p.x < a.x + ((p.y - a.y) / (b.y - a.y)) * (b.x - a.x);
    return crosses ? !inside : inside;
  }, false);
}
