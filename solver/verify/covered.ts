import type { Place } from '../../schema/basics/index.ts';
import { type Claim, standingHazard } from './claim.ts';
import { apart, boxGap, less, START, unit } from './geometry.ts';

/** The most sets of poses to examine. */
const MOST = 400_000;

/** The places of a square, and directions of the box's x axis between two that are less than half a turn apart. */
interface Poses {
  readonly centre: Place;
  readonly half: number;
  readonly from: Place;
  readonly to: Place;
}

/**
 * Checks `covered`: every pose in which her box touches the object overlaps a hazard. Sets of poses are divided until in each
 * of them either no box touches the object or all overlap one hazard (branch and bound). A box that is moved by some px, or
 * turned so that no point moves farther, changes its distances by no more than that.
 */
export function checkCovered(claim: Claim): string | null {
  // A frame in which she touches both completes the level.
  if (claim.frames) return 'with frames the black hole is tested before hazards';
  if (!less(claim.touch, apart(claim.thing, START))) return 'she may touch it at the start';
  // A wormhole may put her where she could not be otherwise, and there a mineral counts before a hazard.
  if (claim.about.kind === 'mineral' && claim.level.wormholes.length > 0) return 'a wormhole may take her to it';
  const { novae, asteroids } = claim.level;
  const hazards = [
    ...novae.map((_, index) => standingHazard(claim, { kind: 'nova', index })),
    ...asteroids.map((_, index) => standingHazard(claim, { kind: 'asteroid', index })),
    standingHazard(claim, { kind: 'blackHole', index: 0 }),
  ].filter((hazard) => hazard !== null);
  const quarter = (from: Place, to: Place): Poses => ({ centre: claim.thing, half: claim.touch, from, to });
  // Half a turn does not change the box.
  const waiting = [quarter({ x: 1, y: 0 }, { x: 0, y: 1 }), quarter({ x: 0, y: 1 }, { x: -1, y: 0 })];
  for (let looked = 0; waiting.length > 0; looked++) {
    if (looked > MOST) return 'deciding whether it is covered takes too many poses';
    const poses = waiting.pop() as Poses;
    const middle = unit({ x: poses.from.x + poses.to.x, y: poses.from.y + poses.to.y });
    const shift = poses.half * 1.4143;
    const turn = claim.box.halfDiagonal * 1.00001 * Math.max(apart(middle, poses.from), apart(middle, poses.to));
    if (less(shift + turn, boxGap(claim.box, poses.centre, middle, claim.thing))) continue;
    const isCovered = hazards.some((hazard) =>
      // A mineral counts even when a press turns her into a hazard at that instant. So it is covered only where her centre
      // cannot be at all.
      claim.about.kind === 'mineral'
        ? less(apart(poses.centre, hazard) + shift, hazard.radius + claim.inner)
        : less(boxGap(claim.box, poses.centre, middle, hazard) + shift + turn, 0),
    );
    if (isCovered) continue;
    if (shift + turn < 0.05) return 'she may touch it and no hazard';
    if (shift > turn) waiting.push(...quarters(poses));
    else waiting.push({ ...poses, to: middle }, { ...poses, from: middle });
  }
  return null;
}

function quarters(poses: Poses): Poses[] {
  const half = poses.half / 2;
  return [-half, half].flatMap((dx) =>
    [-half, half].map((dy) => ({ ...poses, half, centre: { x: poses.centre.x + dx, y: poses.centre.y + dy } })),
  );
}
