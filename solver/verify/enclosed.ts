import { objectName, type Place } from '../../schema/basics/index.ts';
import type { BarrierEdge, Blocker } from '../prove/index.ts';
import { type Claim, mouthsOf, standingHazard } from './claim.ts';
import { apart, less, START } from './geometry.ts';

/**
 * Checks `enclosed`: a closed barrier separates the start from the object. No point of it can be the place of her centre,
 * because each edge lies in the disc of one hazard that stands still, or entirely out of range; discs and the outside of the
 * range are tested by their distances from the edge alone. Her path is continuous, so she stays on her side, and the object
 * lies on the other side, farther from the barrier than she can touch it from. Both mouths of each wormhole lie on the same
 * side.
 */
export function checkEnclosed(claim: Claim, barrier: readonly BarrierEdge[]): string | null {
  if (!Array.isArray(barrier) || barrier.length < 3) return 'its barrier is not a closed line';
  if (!barrier.every((edge) => Number.isFinite(edge?.x) && Number.isFinite(edge?.y)))
    return 'a corner of its barrier is not a point';
  const corners = barrier.map(({ x, y }) => claim.place({ x, y }));
  // In frames, an observation that shows her touching the object may follow a jump over the barrier.
  const touch = claim.touch + claim.jump;
  for (const [i, { by }] of barrier.entries()) {
    const a = corners[i];
    const b = corners[(i + 1) % corners.length];
    if (!less(touch, distanceToSegment(claim.thing, a, b))) return `she may touch it from edge ${i + 1} of the barrier`;
    if (!less(0, distanceToSegment(START, a, b))) return `the start lies on edge ${i + 1} of the barrier`;
    const why = by?.kind === 'range' ? checkOutside(claim, a, b) : checkHazard(claim, by, a, b);
    if (why !== null) return `edge ${i + 1} of the barrier: ${why}`;
  }
  if (isInside(corners, START) === isInside(corners, claim.thing)) return 'the barrier does not lie between the start and it';
  return checkMouths(claim, corners);
}

function checkMouths(claim: Claim, corners: readonly Place[]): string | null {
  for (const mouth of mouthsOf(claim)) {
    if (isInside(corners, mouth) !== isInside(corners, mouth.exit)) return 'a wormhole leads through the barrier';
    // In frames she moves on from there before she is observed.
    const reach = mouth.radius + claim.jump;
    const isNear = (a: Place, i: number) => !less(reach, distanceToSegment(mouth, a, corners[(i + 1) % corners.length]));
    if (corners.some(isNear)) return 'a mouth of a wormhole lies on the barrier';
  }
  return null;
}

/** The whole edge is out of range of every asteroid. Between two observations she may cut half a jump off a corner. */
function checkOutside(claim: Claim, a: Place, b: Place): string | null {
  const near = claim.level.asteroids.findIndex((asteroid, i) => {
    const reach = claim.level.range + claim.drift(i) + claim.jump / 2;
    return !less(reach, distanceToSegment(claim.place(asteroid), a, b));
  });
  return near < 0 ? null : `it is in range of ${objectName('asteroid', near)}`;
}

/**
 * Both ends of the edge, and so all of it, lie in the disc around a hazard in which her box overlaps it at any angle. The
 * segment between two observations outside a disc enters it no deeper than a chord of that length (lemma `chord`).
 */
function checkHazard(claim: Claim, by: Blocker, a: Place, b: Place): string | null {
  const hazard = standingHazard(claim, by);
  if (hazard === null) return 'it names something other than a hazard that stands still';
  const r = hazard.radius + claim.inner;
  if (!less(claim.jump / 2, r)) return 'she may jump over it';
  const radius = Math.sqrt(r * r - (claim.jump * claim.jump) / 4);
  return less(apart(a, hazard), radius) && less(apart(b, hazard), radius) ? null : 'it leaves the hazard it names';
}

function distanceToSegment(p: Place, a: Place, b: Place): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const length2 = dx * dx + dy * dy;
  const t = length2 > 0 ? Math.max(0, Math.min(1, ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2)) : 0;
  return apart(p, { x: a.x + t * dx, y: a.y + t * dy });
}

/** Whether a place lies inside a closed line: a ray to the right crosses the line an odd number of times. */
function isInside(corners: readonly Place[], p: Place): boolean {
  return corners.reduce((inside, a, i) => {
    const b = corners[(i + 1) % corners.length];
    const crosses = a.y > p.y !== b.y > p.y && p.x < a.x + ((p.y - a.y) / (b.y - a.y)) * (b.x - a.x);
    return crosses ? !inside : inside;
  }, false);
}
