import { type Box, TICK } from '../../engine/index.ts';
import { objectName } from '../../schema/basics/index.ts';
import { speedAfter, unbentSpeed } from './assumptions.ts';
import { type StandingCircle, standingCircles } from './blockers.ts';
import { findDeadEnd } from './dead-end.ts';
import type { About, Blocker, Drift, LineEnd, Proof } from './proof.ts';
import { distance, surelyLess } from './rounding.ts';
import { px, subject, thing } from './say.ts';
import { ALL_ACCURACIES, CONTINUOUS, EXACT, rimDiscs, type Setting, type Thing } from './setting.ts';
import { swingDrift } from './swing-drift.ts';

/**
 * How far she may be from the exact line, px, and how far the corners of her box may be turned away from it. Rounding moves her
 * by less than a thousandth of that; anything closer is left undecided.
 */
const TUBE = 0.01;

/** Two distances that differ by less count as equal, px. */
const TIE = 1e-7;

/** The line from the start through the centre of the nearest asteroid. */
interface Line {
  readonly target: number;
  /** Direction, a unit vector. */
  readonly ux: number;
  readonly uy: number;
  /** Distance of the asteroid's centre from the start, px. */
  readonly centre: number;
}

/** A stretch of the line on which her box overlaps a hazard. */
interface Stretch {
  readonly from: number;
  readonly to: number;
  readonly by: Blocker;
}

/**
 * `line-trap`: from rest she cannot leave a stretch of the line through the start and the nearest asteroid.
 *
 * The invariant is that she is on the line with zero angular momentum: the pull points along the line, so nothing ever moves
 * her sideways. It holds as long as the same asteroid stays the nearest and no field, wind or wormhole acts on her. The proof
 * finds a stretch on which this is so and whose ends stop her: a hazard that her box must overlap, the end of the range, or,
 * when she dies before the asteroid's centre and is only ever pulled forward, the start itself. The object is out of reach if
 * no box on the stretch touches it.
 *
 * An energy bound gives her greatest speed on the line, and so shows that the speed limit of one axis does not bend her path.
 * Recoil moves the asteroid along the same line; {@link driftOnFall} and {@link swingDrift} bound how far. In `arcade`,
 * rounding accumulates on slanted lines, and {@link mayBeRoundedOff} bounds it; at the very centre of an asteroid a frame
 * pushes her to the right, so only the fall in one direction is covered. Rests on the lemmas `line`, `upright`, `speed on a
 * line`, `fall drift`, `swing drift`, `in range`, `arcade-axis`, `arcade-fall`, `jump` and `mouths`.
 */
export function proveLineTrap(setting: Setting, about: About, goal: Thing): Proof | null {
  const bound = boundBy(setting, about);
  return bound !== null && holds(setting, bound.line, bound.trap, goal) ? proofOf(setting, about, bound.line, bound.trap) : null;
}

/**
 * A line trap with dead ends: an end of the stretch may also be a border where another asteroid becomes the nearest, if all
 * paths beyond it end at hazards (see {@link findDeadEnd}). It costs more.
 */
export function proveDeadEnds(setting: Setting, about: About, goal: Thing): Proof | null {
  const bound = boundBy(setting, about);
  const trap = bound === null ? null : withDeadEnds(setting, bound, goal);
  return bound === null || trap === null ? null : proofOf(setting, about, bound.line, trap);
}

/** The line that binds her at rest, the hazards that stand still, and the stretch. */
interface Bound {
  readonly line: Line;
  readonly circles: readonly StandingCircle[];
  readonly trap: Trap;
}

function boundBy(setting: Setting, about: About): Bound | null {
  const { level, jump } = setting;
  if (level.astronaut.vx !== 0 || level.astronaut.vy !== 0) return null;
  const line = lineOf(setting);
  if (line === null) return null;
  // On the line the gun pulls towards one asteroid only, so recoil moves no other.
  const drift = setting.drift.map((d, i) => (i === line.target ? d : 0));
  const circles = standingCircles({ ...setting, drift }, about);
  const trap = oneWay(setting, line, circles) ?? (jump > 0 ? null : bothWays(setting, line, circles));
  return trap === null || mayBend(setting, line, trap) || mayBeRoundedOff(setting, line, trap) ? null : { line, circles, trap };
}

/** Along an axis neither the speed limit nor rounding takes her off the line. */
const isAlongAxis = ({ level: { asteroids, astronaut } }: Setting, { target }: Line): boolean =>
  asteroids[target].x === astronaut.x || asteroids[target].y === astronaut.y;

/**
 * Whether the speed limit of one axis could bend her path. At every turning point she is at rest, and she gains speed only up
 * to the asteroid's centre, which bounds her energy. With recoil, the drift of the asteroid is derived from her speed, so the
 * limit must not be reached at all.
 */
function mayBend(setting: Setting, line: Line, { back, front }: Trap): boolean {
  const { level, rules, drift, jump, strongest } = setting;
  if (!level.recoil && isAlongAxis(setting, line)) return false;
  const moved = drift[line.target];
  const out = Math.max(line.centre + moved - back.at, front.at - line.centre + moved) + 2 * TUBE;
  const far = back.by.kind === 'start' ? front.at + jump + 2 * TUBE : level.recoil ? out : swing(Math.min(out, level.range));
  return !surelyLess(speedAfter(strongest, far), unbentSpeed(rules, strongest));

  // The energy per unit of mass and pull that she gains from a turning point to the centre.
  function swing(turn: number): number {
    return turn - (turn * turn) / (2 * level.range);
  }
}

/** The relative error of one floating-point operation. */
const ROUNDING = 2e-16;

/**
 * Whether in `arcade` rounding could take her off the line or turn her box. What counts is the angular momentum about the
 * asteroid that rounding adds. Frames amplify it by less than a factor of 3 on the way, and it turns her direction from the
 * asteroid faster the nearer she is. See `offLine` in solver/verify/fall.ts for the argument (lemma `arcade-fall`).
 */
function mayBeRoundedOff(setting: Setting, line: Line, { front }: Trap): boolean {
  const { level, rules, box, jump, maxTime, strongest } = setting;
  if (jump === 0 || isAlongAxis(setting, line)) return false;
  const pull = rules.pull * (1 - (line.centre + 2 * TUBE) / level.range);
  if (level.recoil && pull < 1e-3) return true;
  const own = 1.02 * speedAfter(strongest, front.at + jump) + 1;
  // With recoil the same holds for her place relative to the asteroid, which may itself be pushed askew.
  const kick = level.recoil ? rules.recoil / (2 * level.asteroids[line.target].radius) : 0;
  const rock = level.recoil ? (1.02 * kick * own) / pull : 0;
  // An asteroid at the speed limit of one axis leaves the line as well.
  if (rock > unbentSpeed(rules, kick)) return true;
  const moved = level.recoil ? setting.drift[line.target] : 0;
  const step = jump + rock * TICK;
  const last = line.centre - driftOnFall(setting, line, front.at + jump + 2 * TUBE) - front.at - 2 * TUBE - step;
  if (last < 1) return true;
  const frames = maxTime / TICK + 3;
  const speed = own + rock;
  const rounding = level.recoil ? 2 * ROUNDING : ROUNDING;
  const coordinate = Math.abs(level.astronaut.x) + Math.abs(level.astronaut.y) + line.centre + moved + step;
  const place = 3 * rounding * coordinate;
  // The acceleration of a frame is rounded as well.
  const velocity = 3 * rounding * (speed + Math.max(3, 0.075 * Math.max(rules.pull, kick)));
  const momentum = 3 * frames * (place * speed + velocity * line.centre);
  const turned = (frames * (TICK * momentum + 3 * place * (last + step))) / (last * (last + step));
  const aside = turned * (line.centre + moved);
  return aside > TUBE / 6 || Math.max(20, box.halfDiagonal) * (turned + (aside + TICK * momentum) / last) > TUBE / 6;
}

function proofOf(setting: Setting, about: About, line: Line, trap: Trap): Proof {
  const { level, jump, maxTime } = setting;
  return {
    code: 'line-trap',
    about,
    reason: reasonOf(setting, about, line, trap),
    covers: jump > 0 ? ALL_ACCURACIES : [trap.back, trap.front].some(({ by }) => by.kind === 'dead-end') ? EXACT : CONTINUOUS,
    // Rounding adds up for as long as a run lasts.
    maxTime: level.recoil || (jump > 0 && !isAlongAxis(setting, line)) ? maxTime : null,
    certificate: {
      kind: 'line-trap',
      target: line.target,
      ...trap,
      drift: isSwing(setting, trap) ? driftOnSwing(setting, line, trap) : null,
    },
  };
}

/** Both ends of the stretch that holds her, px from the start along the line. */
interface Trap {
  readonly back: LineEnd;
  readonly front: LineEnd;
}

/**
 * How far recoil can carry the asteroid while she falls `to` px. Whenever the asteroid is accelerated, so is she, always
 * forward and at least as strongly as at the start. So its path relates to hers at most as the accelerations do (lemma `fall
 * drift`).
 */
function driftOnFall({ level, rules, drift }: Setting, { target, centre }: Line, to: number): number {
  if (!level.recoil) return 0;
  const weakest = rules.pull * (1 - (centre + TUBE) / level.range);
  if (weakest <= 0) return drift[target];
  return Math.min(drift[target], (rules.recoil * 1.01 * to) / (2 * level.asteroids[target].radius * weakest));
}

function lineOf({ level: { asteroids, astronaut } }: Setting): Line | null {
  let target = -1;
  let centre = Number.POSITIVE_INFINITY;
  for (const [i, a] of asteroids.entries()) {
    const d = distance(a, astronaut);
    if (d >= centre) continue;
    centre = d;
    target = i;
  }
  if (target < 0 || !surelyLess(TUBE, centre)) return null;
  const { x, y } = asteroids[target];
  return { target, centre, ux: (x - astronaut.x) / centre, uy: (y - astronaut.y) / centre };
}

/**
 * Where along the line her box, with its x axis along it, overlaps a circle even if both are off by the tube; null where it
 * does not.
 */
function stretchOf({ halfWidth, halfHeight }: Box, line: Line, { x, y, radius, of }: StandingCircle): Stretch | null {
  const along = x * line.ux + y * line.uy;
  const aside = Math.max(0, Math.abs(y * line.ux - x * line.uy) + 2 * TUBE - halfHeight);
  if (aside >= radius) return null;
  const half = halfWidth + Math.sqrt(radius * radius - aside * aside) - 2 * TUBE;
  return half > 0 ? { from: along - half, to: along + half, by: of } : null;
}

/** A hazard before the asteroid's centre: she is only ever pulled forward. */
function oneWay(setting: Setting, line: Line, circles: readonly StandingCircle[]): Trap | null {
  const { level, rules, box, jump } = setting;
  const target = level.asteroids[line.target];
  // Recoil moves the asteroid towards her; in frames the two may jump past each other.
  const kick = level.recoil ? rules.recoil / (2 * target.radius) : 0;
  const met = jump > 0 ? 1.02 * TICK * (speedAfter(kick, line.centre) + kick * TICK) : 0;
  const isMet = jump < target.radius && jump + met + 2 * TUBE < target.radius + box.halfWidth;
  const isTarget = (by: LineEnd['by']) => by.kind === 'asteroid' && by.index === line.target;
  const ends: LineEnd[] = circles
    .flatMap((circle) => stretchOf(box, line, circle) ?? [])
    .filter(({ from, to, by }) => to > Math.max(0, from) + jump && (isMet || !isTarget(by)))
    .map(({ from, by }) => ({ at: Math.max(0, from), by }));
  if (target.hot && isMet) {
    // A hot asteroid stops her itself.
    const at = Math.max(0, line.centre - target.radius - box.halfWidth + 2 * TUBE);
    ends.push({ at, by: { kind: 'asteroid', index: line.target } });
  }
  const first = nearestEnd(ends, (end) => end.at >= 0, 1);
  if (first === null) return null;
  const last = line.centre - (isTarget(first.by) ? 0 : driftOnFall(setting, line, first.at + jump + TUBE)) - jump - 2 * TUBE;
  return first.at < last ? { back: { at: 0, by: { kind: 'start' } }, front: first } : null;
}

const isSwing = ({ level }: Setting, { back }: Trap): boolean => level.recoil && back.by.kind !== 'start';

/** How far recoil can carry the asteroid while she swings between the ends. */
function driftOnSwing({ level, rules, drift, maxTime }: Setting, { target, centre }: Line, { back, front }: Trap): Drift {
  const stretch = { centre, back: back.at - TUBE, front: front.at + TUBE };
  return swingDrift(rules, level.asteroids[target].radius, level.range, stretch, maxTime, drift[target]);
}

/** Beyond the centre she may come back and swing farther out than she started, so both ends must stop her. */
function bothWays({ level, box, drift }: Setting, line: Line, circles: readonly StandingCircle[]): Trap | null {
  const stretches = circles.flatMap((circle) => stretchOf(box, line, circle) ?? []);
  const reach = level.range + drift[line.target] + 2 * TUBE;
  const out: Blocker = { kind: 'range' };
  const front = nearestEnd(
    [...stretches.map(({ from, by }) => ({ at: from, by })), { at: line.centre + reach, by: out }],
    (end) => end.at >= 0,
    1,
  );
  const back = nearestEnd(
    [...stretches.map(({ to, by }) => ({ at: to, by })), { at: line.centre - reach, by: out }],
    (end) => end.at <= 0,
    -1,
  );
  return front === null || back === null ? null : { front, back };
}

/**
 * Replaces an end of the trap by a border where another asteroid becomes the nearest, if there is one and what lies beyond is a
 * dead end.
 */
function withDeadEnds(setting: Setting, { line, circles, trap: { back, front } }: Bound, goal: Thing): Trap | null {
  if (setting.level.recoil || setting.jump > 0 || back.by.kind === 'start') return null;
  const shut = (end: LineEnd, sign: number): LineEnd | null => {
    const at = firstTie(setting, line, sign);
    if (at === null || sign * at >= sign * end.at) return end;
    const apex = { x: at * line.ux, y: at * line.uy };
    const deadEnd = findDeadEnd(setting, goal, circles, apex, { x: sign * line.ux, y: sign * line.uy }, line.target);
    return deadEnd === null ? null : { at, by: { kind: 'dead-end', ...deadEnd } };
  };
  const shutFront = shut(front, 1);
  const shutBack = shutFront === null ? null : shut(back, -1);
  if (shutFront === null || shutBack === null) return null;
  const trap = { front: shutFront, back: shutBack };
  return holds(setting, line, trap, goal) ? trap : null;
}

/** The first place along the line, on one side of the asteroid's centre, where another asteroid is equally near. */
function firstTie({ level: { asteroids, astronaut } }: Setting, { target, centre, ux, uy }: Line, sign: number): number | null {
  let first: number | null = null;
  for (const [i, a] of asteroids.entries()) {
    const x = (a.x - astronaut.x) * ux + (a.y - astronaut.y) * uy;
    const y = (a.y - astronaut.y) * ux - (a.x - astronaut.x) * uy;
    if (i === target || !surelyLess(0, sign * (x - centre))) continue;
    const at = (x * x + y * y - centre * centre) / (2 * (x - centre));
    if (sign * at > 0 && (first === null || sign * at < sign * first)) first = at;
  }
  return first;
}

function nearestEnd(ends: readonly LineEnd[], ahead: (end: LineEnd) => boolean, sign: number): LineEnd | null {
  let nearest: LineEnd | null = null;
  for (const end of ends) if (ahead(end) && (nearest === null || sign * end.at < sign * nearest.at)) nearest = end;
  return nearest;
}

/** Whether on all of the stretch the asteroid stays the nearest, no field acts, and no box touches the object. */
function holds(setting: Setting, line: Line, { back, front }: Trap, goal: Thing): boolean {
  const { level, box, jump } = setting;
  const { asteroids, astronaut, repulsors } = level;
  // A dead end begins exactly where another asteroid is equally near, so the stretch is examined up to there.
  const from = back.at - (back.by.kind === 'dead-end' ? 0 : TUBE);
  const to = front.at + (front.by.kind === 'dead-end' ? 0 : TUBE + jump);
  const ties = (s: number) => (s === from ? back : front).by.kind === 'dead-end';
  const at = (s: number) => ({ x: s * line.ux, y: s * line.uy });
  const place = ({ x, y }: { x: number; y: number }) => ({ x: x - astronaut.x, y: y - astronaut.y });

  const fall = isSwing(setting, { back, front }) ? 0 : driftOnFall(setting, line, to);
  const drift = isSwing(setting, { back, front }) ? driftOnSwing(setting, line, { back, front }) : { back: fall, ahead: fall };
  const near = nearnessOf(setting, line, drift);
  const staysNearest = asteroids.every((asteroid, i) => {
    if (i === line.target) return true;
    const other = place(asteroid);
    // Where only the range bounds her distance from the asteroid, the other must be out of range.
    const isOut = (a: number, b: number) => a > b || surelyLess(near.range + 4 * TUBE, distanceToStretch(line, a, b, other));
    if (!isOut(from, Math.min(to, near.from)) || !isOut(Math.max(from, near.to), to)) return false;
    const ends = [Math.max(from, near.from), Math.min(to, near.to)];
    // The difference of squared distances is linear along the line: what holds at both ends holds between them.
    if (ends[0] > ends[1]) return true;
    return ends.every((s) => {
      const far = distance(at(s), other);
      return (s === from || s === to) && ties(s) ? near.at(s) < far + TIE : surelyLess(near.at(s) + 4 * TUBE, far);
    });
  });
  if (!staysNearest) return false;
  const clear = [...repulsors, ...rimDiscs(level)].every((field) =>
    surelyLess(field.radius + TUBE, distanceToStretch(line, from, to, place(field))),
  );
  if (!clear) return false;

  // Her box is upright until the first press; then its x axis lies along the line.
  const upright = gapOf(box, goal.x, goal.y, 0, 0);
  const along = gapOf(box, goal.x * line.ux + goal.y * line.uy, goal.y * line.ux - goal.x * line.uy, from, to);
  return surelyLess(goal.radius + 4 * TUBE, upright) && surelyLess(goal.radius + 4 * TUBE, along);
}

/**
 * How far she may be from the asteroid that holds her on the line, wherever recoil has carried it: no farther than from the
 * farther end of its drift, and never out of range, because then she is lost (lemma `in range`). In frames she may jump out of
 * range.
 */
function nearnessOf({ level, jump }: Setting, { centre }: Line, { back, ahead }: Drift) {
  const range = jump > 0 ? Number.POSITIVE_INFINITY : level.range + TUBE;
  return {
    range,
    /** Between these places along the line, px, she may be in range wherever the asteroid is. */
    from: centre + ahead - range,
    to: centre - back + range,
    /** The greatest distance at a place between them, px. */
    at: (s: number) => Math.max(s - centre + back, centre + ahead - s),
  };
}

/** Distance from a place to the box swept from `from` to `to` along its x axis, px. */
function gapOf({ halfWidth, halfHeight }: Box, along: number, aside: number, from: number, to: number): number {
  const dx = Math.max(0, along - to - halfWidth, from - halfWidth - along);
  const dy = Math.max(0, Math.abs(aside) - halfHeight);
  return Math.sqrt(dx * dx + dy * dy);
}

function distanceToStretch(line: Line, from: number, to: number, p: { x: number; y: number }): number {
  const along = Math.max(from, Math.min(to, p.x * line.ux + p.y * line.uy));
  return distance(p, { x: along * line.ux, y: along * line.uy });
}

function reasonOf({ level }: Setting, about: About, line: Line, { back, front }: Trap): string {
  const end = ({ at, by }: LineEnd): string =>
    by.kind === 'range'
      ? `the edge of the range at ${px(Math.abs(at))}`
      : by.kind === 'start'
        ? 'the start'
        : by.kind === 'dead-end'
          ? `a dead end after ${px(Math.abs(at))}, where another asteroid pulls her and every path leads into a hazard`
          : `${thing(by)}, which her collision box hits after ${px(Math.abs(at))}`;
  const where =
    back.by.kind === 'start'
      ? `she can only fall towards ${end(front)}`
      : `the line ends at ${end(front)} on one side and at ${end(back)} on the other`;
  const before = [back, front].some(({ by }) => by.kind === 'dead-end') ? ' before a dead end' : '';
  return (
    `${subject(about)} is not on the line that she cannot leave: she starts at rest, and the gun pulls her straight towards ${objectName('asteroid', line.target)}, ` +
    `no other asteroid becomes nearer${before}${level.repulsors.length > 0 ? ' and no repulsor is in the way' : ''}, and ${where}: ` +
    'give her some speed at the start, move the start, or bring another asteroid nearer to that line'
  );
}
