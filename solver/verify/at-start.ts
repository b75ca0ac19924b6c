import { objectName } from '../../schema/basics/index.ts';
import type { ThingRef } from '../prove/index.ts';
import type { Claim } from './claim.ts';
import { apart, isIndex, less } from './rounded.ts';

const START = { x: 0, y: 0 };

/**
 * Checks `nothing-in-range`: she is lost at time 0 if no asteroid is in range of the start. The object must not be touched at
 * that instant, because the black hole would count.
 */
export function checkNothingInRange(claim: Claim): string | null {
  const near = claim.level.asteroids.findIndex((a) => !less(claim.level.range, apart(claim.place(a), START)));
  if (near >= 0) return `${objectName('asteroid', near)} is not farther from the start than the range`;
  return less(claim.touch, apart(claim.thing, START)) ? null : 'she may touch it at the start';
}

/**
 * Checks `starts-in-hazard`: her box at the start, with its x axis along x, overlaps the hazard. In continuous time that counts
 * before everything but minerals. In frames the first press may already have turned the box, and the black hole is tested
 * before hazards.
 */
export function checkStartsInHazard(claim: Claim, hazard: ThingRef): string | null {
  const { novae, asteroids, aliens } = claim.level;
  const list = { nova: novae, asteroid: asteroids, alien: aliens, blackHole: [] }[hazard?.kind];
  if (list === undefined || !isIndex(hazard.index, list)) return 'it names a hazard that the level does not have';
  if (hazard.kind === 'asteroid' && !asteroids[hazard.index].hot) return 'the asteroid it names is cold';
  const { x, y, radius } = claim.place(list[hazard.index]);
  const beyondX = Math.max(0, Math.abs(x) - claim.box.halfWidth);
  const beyondY = Math.max(0, Math.abs(y) - claim.box.halfHeight);
  if (!less(apart({ x: beyondX, y: beyondY }, START), radius)) return 'the hazard it names does not touch her at the start';
  if (claim.frames && !less(apart({ x, y }, START), radius + claim.inner))
    return 'a box turned by a press may not touch the hazard';
  const mayTouch = !less(claim.touch, apart(claim.thing, START));
  return mayTouch && (claim.frames || claim.about.kind === 'mineral') ? 'she may touch it at the start' : null;
}
