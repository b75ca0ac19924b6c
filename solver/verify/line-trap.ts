import { TICK } from '../../engine/index.ts';
import { objectName, type Place } from '../../schema/basics/index.ts';
import type { Drift, LineEnd, LineTrap } from '../prove/index.ts';
import { speedAfter, unlimited } from './assumptions.ts';
import { type Claim, mouthsOf, standingHazard } from './claim.ts';
import { checkDeadEnd } from './dead-end.ts';
import { offLine } from './fall.ts';
import { apart, isIndex, less, START } from './geometry.ts';

/**
 * How far she may be from the exact line, px, and how far the corners of her box may be turned away from it. Rounding is far
 * below it.
 */
const TUBE = 0.01;

/** Distances that differ by less are equal, px. */
const TIE = 1e-6;

/** The line from the start through the asteroid towards which she falls. */
interface Line {
  readonly target: number;
  readonly centre: number;
  readonly radius: number;
  /** The least and the greatest distance from the start to which recoil may carry the asteroid's centre, px. */
  readonly nearest: number;
  readonly farthest: number;
  /** The coordinate of a place along the line, px from the start. */
  along(p: Place): number;
  /** The distance of a place from the line, px. */
  aside(p: Place): number;
}

/**
 * Checks `line-trap`: she rests at the start, and the gun pulls her along the line to the nearest asteroid.
 *
 * The invariant is that she stays on this line with zero angular momentum, as long as no other asteroid is nearer and no field,
 * wind or wormhole acts (lemma `line`). The check tests that none of this happens on the stretch (allowing for the drift of the
 * asteroid), that she cannot pass either end of it, that the speed limit does not bend her path (lemma `speed on a line`, an
 * energy bound), that in `arcade` rounding does not take her off the line, and that no box on the stretch touches the object.
 * An end that is a dead end is followed by {@link checkDeadEnd}.
 */
export function checkLineTrap(claim: Claim, { target, back, front, drift }: LineTrap): string | null {
  const { astronaut, asteroids, repulsors } = claim.level;
  if (astronaut.vx !== 0 || astronaut.vy !== 0) return 'she is not at rest at the start';
  if (!isIndex(target, asteroids)) return 'it names an asteroid that the level does not have';
  if (!Number.isFinite(back?.at) || !Number.isFinite(front?.at) || !(back.at <= 0 && front.at >= 0))
    return 'its stretch does not contain the start';
  const centre = apart(claim.place(asteroids[target]), START);
  if (!less(TUBE, centre)) return 'the asteroid is where she starts: there is no line';
  const u = { x: claim.place(asteroids[target]).x / centre, y: claim.place(asteroids[target]).y / centre };
  const fall = driftOnFall(claim, target, centre, front.at);
  const moved = back.by?.kind === 'start' ? { back: fall, ahead: fall } : driftOnSwing(claim, target, centre, back, front, drift);
  if (moved === null) return 'the asteroid may drift farther than it says';
  const line: Line = {
    target,
    centre,
    radius: asteroids[target].radius,
    nearest: centre - moved.back,
    farthest: centre + moved.ahead,
    along: (p) => p.x * u.x + p.y * u.y,
    aside: (p) => Math.abs(p.y * u.x - p.x * u.y),
  };
  const why = back.by?.kind === 'start' ? checkOneWay(claim, line, back, front) : checkBothWays(claim, line, back, front);
  if (why !== null) return why;
  if (mayBend(claim, line, back, front)) return 'she may reach the speed limit and leave the line';

  // A dead end begins where another asteroid is equally near: she is on the line up to there.
  const from = back.by?.kind === 'dead-end' ? back.at : back.at - TUBE;
  const to = front.by?.kind === 'dead-end' ? front.at : front.at + claim.jump + TUBE;
  for (const [i, asteroid] of asteroids.entries()) {
    if (i === target) continue;
    const other = claim.place(asteroid);
    for (const { start, end, most } of partsInRange(claim, line, from, to)) {
      if (most !== null) {
        if (!less(most + 2 * TUBE, gap(line, other, start, end, 0, 0)))
          return `${objectName('asteroid', i)} may be the nearer one on the stretch`;
        continue;
      }
      for (const at of [start, end]) {
        const toTarget = Math.max(Math.abs(at - line.nearest), Math.abs(at - line.farthest));
        const toOther = apart({ x: at, y: 0 }, { x: line.along(other), y: line.aside(other) });
        const isDeadEnd = (at === to && front.by?.kind === 'dead-end') || (at === from && back.by?.kind === 'dead-end');
        const isNearer = isDeadEnd ? toTarget < toOther + TIE : less(toTarget + 2 * TUBE, toOther);
        if (!isNearer) return `${objectName('asteroid', i)} may be the nearer one on the stretch`;
      }
    }
  }
  for (const [i, field] of repulsors.entries()) {
    if (!less(field.radius + TUBE, gap(line, claim.place(field), from, to, 0, 0)))
      return `${objectName('repulsor', i)} may push her on the stretch`;
  }
  for (const [i, wind] of claim.level.winds.entries()) {
    if (!less(wind.radius + TUBE, gap(line, claim.place(wind), from, to, 0, 0)))
      return `${objectName('wind', i)} may act on her on the stretch`;
  }
  if (mouthsOf(claim).some((mouth) => !less(mouth.radius + TUBE, gap(line, mouth, from, to, 0, 0))))
    return 'a wormhole may take her off the stretch';
  const { halfWidth, halfHeight } = claim.box;
  const upright = { x: Math.max(0, Math.abs(claim.thing.x) - halfWidth), y: Math.max(0, Math.abs(claim.thing.y) - halfHeight) };
  if (!less(claim.thing.radius + TUBE, apart(upright, START))) return 'she may touch it at the start';
  const swept = gap(line, claim.thing, from, to, halfWidth, halfHeight);
  return less(claim.thing.radius + 2 * TUBE, swept) ? null : 'she may touch it on the stretch';
}

/** A part of the stretch, px from the start along the line. */
interface Part {
  readonly start: number;
  readonly end: number;
  /** The greatest distance from the target at which she is not lost, px; null where it bounds nothing. */
  readonly most: number | null;
}

/**
 * Divides the stretch by what bounds her distance from the target. Her place alone decides how far every other asteroid is.
 * In continuous time she is lost when her distance from the target, wherever recoil has carried it, exceeds the range (lemma
 * `in range`): near the ends of the stretch, this is the bound. In the middle, the bound is her distance from the farther end of the
 * target's drift. Its square minus that of her distance from another asteroid is linear for each of both ends, so its greatest
 * values lie at the ends of the part.
 */
function partsInRange({ frames, level }: Claim, { nearest, farthest }: Line, from: number, to: number): Part[] {
  if (frames) return [{ start: from, end: to, most: null }];
  const most = level.range + TUBE / 2;
  const [low, high] = [farthest - most, nearest + most];
  return [
    { start: from, end: Math.min(to, low), most },
    { start: Math.max(from, low), end: Math.min(to, high), most: null },
    { start: Math.max(from, high), end: to, most },
  ].filter(({ start, end }) => start <= end);
}

/**
 * Lemma `fall drift`: recoil accelerates the asteroid by recoil / diameter, only while the gun pulls her forward, and at least
 * as strongly as at the start. So the asteroid moves at most by that ratio times her path, which is no longer than the stretch
 * (plus 1 % for frames).
 */
function driftOnFall(claim: Claim, target: number, centre: number, end: number): number {
  const { recoil, range, asteroids } = claim.level;
  const pull = claim.rules.pull * (1 - (centre + TUBE) / range);
  if (!recoil || !less(0, pull)) return claim.drift(target);
  return Math.min(
    claim.drift(target),
    (claim.rules.recoil * 1.01 * (end + claim.jump + TUBE)) / (2 * asteroids[target].radius * pull),
  );
}

/**
 * Lemma `swing drift`: returns the claimed drift if a smaller one follows from it, so that it is never reached, else null.
 *
 * When she is ahead of the asteroid, it is accelerated after her by recoil / diameter, and she by at least `weakest`; when she
 * is behind, she is accelerated by at most the pull. With m the mean of both, the asteroid's velocity is -recoil / (m diameter)
 * times hers, except for at most the fraction (pull - weakest) / (2 m) of its own acceleration. Over time, this adds up to the
 * same ratio times her path back, plus that fraction of the bound for constant acceleration. For the drift towards the start,
 * ahead and behind change places.
 */
function driftOnSwing(
  claim: Claim,
  target: number,
  centre: number,
  back: LineEnd,
  front: LineEnd,
  drift: Drift | null | undefined,
): Drift | null {
  const { recoil, range, asteroids } = claim.level;
  if (!recoil) return { back: 0, ahead: 0 };
  if (!(Number.isFinite(drift?.back) && Number.isFinite(drift?.ahead))) return null;
  const { pull, recoil: strength } = claim.rules;
  const most = claim.drift(target);
  const bound = { back: Math.max(0, drift?.back ?? 0), ahead: Math.max(0, drift?.ahead ?? 0) };
  const isNever = (claimed: number, far: number, way: number): boolean => {
    if (claimed >= most) return true;
    const weakest = Math.max(0, pull * (1 - (far + TUBE / 2) / range));
    const mean = (pull + weakest) / 2;
    const share = (pull - weakest) / (2 * mean);
    return less(share * most + (strength * 1.01 * (way + TUBE / 2)) / (mean * 2 * asteroids[target].radius), claimed);
  };
  const holds =
    isNever(bound.ahead, front.at - centre + bound.back, -back.at) &&
    isNever(bound.back, centre + bound.ahead - back.at, front.at);
  return holds ? bound : null;
}

/**
 * Whether one axis of her velocity may reach the speed limit before the other does. Lemma `speed on a line`: she is at rest at
 * every turning point of the stretch, and from there the pull accelerates her only up to the asteroid's centre. Without recoil
 * the pull decreases linearly with the distance. A line along an axis is not bent. With recoil, her speed determines how far
 * the asteroid drifts, so the limit must not be reached at all.
 */
function mayBend(claim: Claim, line: Line, back: LineEnd, front: LineEnd): boolean {
  const { recoil, range, astronaut, asteroids } = claim.level;
  const { x, y } = asteroids[line.target];
  if (!recoil && (x === astronaut.x || y === astronaut.y)) return false;
  if (back.by?.kind === 'start')
    return !less(speedAfter(claim.push, front.at + claim.jump + TUBE), unlimited(claim.rules, claim.push));
  const far = Math.max(line.farthest - back.at, front.at - line.nearest) + TUBE;
  const inRange = Math.min(far, range);
  return !less(speedAfter(claim.push, recoil ? far : inRange * (1 - inRange / (2 * range))), unlimited(claim.rules, claim.push));
}

/**
 * She dies before she reaches the asteroid's centre, so it only ever pulls her forward, and she cannot go back behind the
 * start.
 */
function checkOneWay(claim: Claim, line: Line, back: LineEnd, front: LineEnd): string | null {
  if (back.at !== 0) return 'its stretch does not begin at the start';
  if (front.by?.kind === 'asteroid' && front.by.index === line.target) {
    // Recoil moves the asteroid towards her: she meets it here at the latest, and does not jump over half of it.
    if (!claim.level.asteroids[line.target].hot) return 'the asteroid at its end is cold';
    if (!less(line.centre - front.at + TUBE, line.radius + claim.box.halfWidth))
      return 'she may stop before she touches the asteroid';
    if (!less(claim.jump + TUBE, line.radius)) return 'she may jump over the asteroid';
    // The asteroid may jump towards her as well, at most with the speed that it gains over the whole distance.
    const kick = claim.level.recoil ? claim.rules.recoil / (2 * line.radius) : 0;
    const met = claim.frames ? TICK * (1.01 * speedAfter(kick, line.centre) + kick * TICK) : 0;
    if (!less(claim.jump + met + TUBE, line.radius + claim.box.halfWidth)) return 'the asteroid may jump over her';
    return checkRounding(claim, line, front.at);
  }
  if (!less(front.at + claim.jump + TUBE, line.nearest)) return 'she may reach the centre of the asteroid';
  return checkHazard(claim, line, front) ?? checkRounding(claim, line, front.at);
}

/**
 * In frames rounding is part of the game. Lemma `arcade-axis`: along an axis all differences, pulls and velocities across are
 * exactly 0 and stay so. On other lines {@link offLine} bounds what rounding can do.
 */
function checkRounding(claim: Claim, line: Line, end: number): string | null {
  if (!claim.frames) return null;
  const { astronaut, asteroids, recoil, range } = claim.level;
  const { x, y, radius } = asteroids[line.target];
  if (x === astronaut.x || y === astronaut.y) return null;
  if (claim.seconds === null) return 'with frames it must say for how long rounding may add up';
  const speed = 1.01 * speedAfter(claim.push, end + claim.jump) + 1;
  // The asteroid gains at most the ratio of the accelerations times her speed, see driftOnFall.
  const pull = claim.rules.pull * (1 - (line.centre + TUBE) / range);
  const kick = recoil ? claim.rules.recoil / (2 * radius) : 0;
  if (recoil && !less(0, pull)) return 'with frames rounding may take her off the line';
  const rockSpeed = (1.01 * kick * speed) / pull;
  // The speed limit of one axis would take the asteroid off the line.
  if (recoil && !less(rockSpeed, unlimited(claim.rules, kick)))
    return 'the asteroid may reach the speed limit and leave the line';
  const { beside, slope } = offLine({
    centre: line.centre,
    nearest: line.nearest - end - TUBE,
    rockSpeed,
    push: Math.max(claim.rules.pull, kick),
    drift: claim.drift(line.target),
    jump: claim.jump,
    coordinate: Math.abs(astronaut.x) + Math.abs(astronaut.y) + line.centre,
    speed,
    seconds: claim.seconds,
  });
  return beside < TUBE / 4 && Math.max(20, claim.box.halfDiagonal) * slope < TUBE / 4
    ? null
    : 'with frames rounding may take her off the line';
}

/** Beyond the centre she may turn back, and she gains speed only on the way in: nothing but what ends the run stops her. */
function checkBothWays(claim: Claim, line: Line, back: LineEnd, front: LineEnd): string | null {
  // At the very centre a frame pulls her to the right, off the line.
  if (claim.frames) return 'with frames she may leave the line at the centre of the asteroid';
  const length = front.at - back.at;
  return checkEnd(claim, line, back, length) ?? checkEnd(claim, line, front, length);
}

function checkEnd(claim: Claim, line: Line, end: LineEnd, length: number): string | null {
  if (end.by?.kind === 'dead-end') {
    const { x, y } = claim.place(claim.level.asteroids[line.target]);
    const u = { x: x / line.centre, y: y / line.centre };
    const ahead = end.at > 0 ? u : { x: -u.x, y: -u.y };
    return checkDeadEnd(claim, end.by, { apex: { x: u.x * end.at, y: u.y * end.at }, ahead, before: line.target, length });
  }
  if (end.by?.kind !== 'range') return checkHazard(claim, line, end);
  const far = end.at > line.centre ? end.at - line.farthest : line.nearest - end.at;
  const beyond = less(claim.level.range + TUBE, far);
  return beyond ? null : 'an end of its stretch is still in range';
}

/** Her box at the end of the stretch, and as far beyond as she may jump, overlaps the hazard. */
function checkHazard(claim: Claim, line: Line, { at, by }: LineEnd): string | null {
  // The gun pulls towards the target only, so recoil moves no other asteroid.
  const still: Claim = { ...claim, drift: (i) => (i === line.target ? claim.drift(i) : 0) };
  const isThing = by?.kind !== 'start' && by?.kind !== 'range' && by?.kind !== 'dead-end';
  const hazard = isThing ? standingHazard(still, by) : null;
  if (hazard === null) return 'at an end of the stretch it names something other than a hazard that stands still';
  const dy = Math.max(0, line.aside(hazard) - claim.box.halfHeight + TUBE);
  for (const place of [at, at + claim.jump]) {
    const dx = Math.max(0, Math.abs(line.along(hazard) - place) - claim.box.halfWidth) + TUBE;
    if (!less(apart({ x: dx, y: dy }, START), hazard.radius)) return 'the hazard at an end of the stretch may not stop her';
  }
  return null;
}

/**
 * Distance from a place to a box swept along the line, px; `halfAlong` is half its length along the line, `halfAside` half its
 * width.
 */
function gap(line: Line, p: Place, from: number, to: number, halfAlong: number, halfAside: number): number {
  const dx = Math.max(0, line.along(p) - to - halfAlong, from - halfAlong - line.along(p));
  return apart({ x: dx, y: Math.max(0, line.aside(p) - halfAside) }, START);
}
