import { objectName } from '../../schema/basics/index.ts';
import type { ThingRef } from '../prove/index.ts';
import { type Claim, mouthsOf } from './claim.ts';
import { apart, isIndex, less, START } from './geometry.ts';

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

/**
 * Checks `out-of-range`: the listed asteroids are closed under everything that she can do. No other asteroid is in range of the
 * start, and none is so near to a listed one that she could pass from range to range. She cannot touch the object from within
 * the range of any listed asteroid. With wormholes, the mouths that she can enter are listed too, and the disc in which she
 * comes out is treated like a range; in frames it is enlarged by one frame's flight.
 */
export function checkOutOfRange(claim: Claim, listed: readonly number[], listedMouths: readonly number[] = []): string | null {
  const { asteroids, range } = claim.level;
  if (!Array.isArray(listed) || !listed.every((i) => isIndex(i, asteroids)))
    return 'it lists asteroids that the level does not have';
  // Out of every range she is lost at the start, but what she touches at that instant counts first.
  if (!less(claim.touch, apart(claim.thing, START))) return 'she may touch it at the start';
  const mouths = mouthsOf(claim);
  if (!Array.isArray(listedMouths) || !listedMouths.every((i) => isIndex(i, mouths)))
    return 'it lists mouths of wormholes that the level does not have';
  const inside = new Set(listed);
  const place = asteroids.map(claim.place);
  for (const [i, a] of place.entries()) {
    if (inside.has(i)) {
      const reach = range + claim.drift(i) + claim.touch;
      if (!less(reach, apart(a, claim.thing))) return `she may touch it in range of ${objectName('asteroid', i)}`;
      continue;
    }
    if (!less(range + claim.drift(i), apart(a, START)))
      return `${objectName('asteroid', i)} is in range of the start and not listed`;
    for (const j of inside) {
      const gap = 2 * range + claim.drift(i) + claim.drift(j) + claim.jump;
      if (!less(gap, apart(a, place[j])))
        return `${objectName('asteroid', i)} is not listed, and she may reach it from ${objectName('asteroid', j)}`;
    }
  }
  const taken = new Set(listedMouths);
  for (const [m, mouth] of mouths.entries()) {
    // A mouth in which she starts moves her nowhere before she has left it.
    const reach = mouth.radius + claim.jump;
    const comesFrom = (i: number) => !less(range + claim.drift(i) + reach, apart(place[i], mouth));
    const comesOut = (n: number) => !less(mouths[n].radius + claim.jump + reach, apart(mouths[n].exit, mouth));
    if (!taken.has(m)) {
      const from = listed.find(comesFrom);
      if (from !== undefined) return `a mouth is not listed, and she may reach it from ${objectName('asteroid', from)}`;
      if (listedMouths.some(comesOut)) return 'a mouth is not listed, and she may reach it out of another';
      continue;
    }
    if (!less(reach + claim.touch, apart(mouth.exit, claim.thing))) return 'she may touch it as she comes out of a mouth';
    const missing = place.findIndex((a, i) => !inside.has(i) && !less(range + claim.drift(i) + reach, apart(a, mouth.exit)));
    if (missing >= 0) return `${objectName('asteroid', missing)} is not listed, and she may come out of a mouth in range of it`;
  }
  return null;
}
